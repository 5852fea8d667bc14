"""Whether a link of this size could have this mass and inertia: findings, not failures."""
