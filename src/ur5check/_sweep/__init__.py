"""Two arms at millions of states: what is kept of them, and how it is kept exact."""
