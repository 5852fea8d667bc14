"""The states of the largest torque difference of two arms within their limits."""
