"""Everything that can be said of a difference, put together and told."""
