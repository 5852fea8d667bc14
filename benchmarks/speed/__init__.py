"""What `bench_speed.py` measures: one question a file."""
