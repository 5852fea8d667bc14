"""Whether a link of this size can have this mass and inertia: findings, not failures."""
