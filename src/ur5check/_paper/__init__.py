"""The paper reproduced: its computations, and a verdict on each of its claims."""
