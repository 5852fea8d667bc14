"""Hypothesis draws the same examples on every run: a red build can be made again."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "ur5check",
    derandomize=True,
    deadline=None,  # machines differ; time is measured in benchmarks/
    max_examples=40,
    suppress_health_check=[HealthCheck.too_slow],  # an arm of eight joints is 200 numbers
)
settings.load_profile("ur5check")
