"""Figures of results; nothing is computed here, and matplotlib is loaded when one is drawn."""
