"""What all tests share: Hypothesis draws the same examples on every run, so that a red build can be
made again, and generated code is kept in a folder of the test run's own."""

import pytest
from hypothesis import HealthCheck, settings

settings.register_profile(
    "ur5check",
    derandomize=True,
    deadline=None,  # machines differ; time is measured in benchmarks/
    max_examples=40,
    suppress_health_check=[HealthCheck.too_slow],  # an arm of eight joints is 200 numbers
)
settings.load_profile("ur5check")


@pytest.fixture(autouse=True, scope="session")
def kernel_cache(tmp_path_factory):
    """Processes that tests start inherit it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("UR5CHECK_CACHE", str(tmp_path_factory.mktemp("kernels")))
        yield
