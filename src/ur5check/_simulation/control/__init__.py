"""Trajectories, computed torque, and tracking with a wrong model or sign."""
