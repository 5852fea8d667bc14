"""The paper, reproduced: everything it did, and of each of its claims what came of it."""
