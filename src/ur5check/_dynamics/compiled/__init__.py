"""The recursion, compiled: straight-line functions of one arm, for millions of states at a time."""
