"""Why two arms differ: first the same axes, then the same frames, then whose number it is."""
