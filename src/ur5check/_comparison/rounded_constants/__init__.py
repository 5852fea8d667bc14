"""Constants that were written with few digits: 1.5707 for π/2, 0.0833333 for 1/12, gravity."""
