"""What torque can tell of an arm's numbers, and what it never can."""
