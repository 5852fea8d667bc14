"""Making an arm follow: trajectories, computed torque, and what a wrong model or sign costs."""
