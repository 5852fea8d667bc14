"""Torque errors due to rounding: of angles, of constants, and of every printed number."""
