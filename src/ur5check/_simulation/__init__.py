"""Arms that move: our own integrator and two physics engines, and whether they agree."""
