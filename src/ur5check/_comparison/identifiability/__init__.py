"""Which inertial parameters of an arm motion and torque identify."""
