"""Do all engines mean the same robot: what each has read, and how far apart their answers are."""
