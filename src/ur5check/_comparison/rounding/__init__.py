"""What rounded digits cost: angles, constants, and every number that is printed short."""
