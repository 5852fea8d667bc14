"""How fast, against whom: everything that `ur5check bench` measures."""
