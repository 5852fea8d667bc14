"""Motion of an arm under given torques, by our integrator or by engines that can step."""
