"""The torque difference of two arms at any number of states, with exact statistics."""
