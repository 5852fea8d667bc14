"""Two arms compared: alignment of axes, difference of torques, attribution to parameters."""
