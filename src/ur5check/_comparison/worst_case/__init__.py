"""The states where two arms disagree most, inside their limits."""
