"""Settings of all tests: Hypothesis draws the same examples on every run, so that a failure can be
reproduced (`--hypothesis-profile=fresh` draws new ones); generated code has a folder of its own."""

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.database import DirectoryBasedExampleDatabase

settings.register_profile(
    "ur5check",
    derandomize=True,
    deadline=None,  # machines differ; time is measured in benchmarks/
    max_examples=40,
    suppress_health_check=[HealthCheck.too_slow],  # an arm of eight joints is 200 numbers
)
#: New examples on every run; failures are kept in .hypothesis/ and tried first the next time.
settings.register_profile(
    "fresh",
    settings.get_profile("ur5check"),
    derandomize=False,
    database=DirectoryBasedExampleDatabase(".hypothesis/examples"),
    max_examples=400,
    print_blob=True,
)
settings.load_profile("ur5check")


@pytest.fixture(autouse=True, scope="session")
def kernel_cache(tmp_path_factory):
    """Processes that tests start inherit it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("UR5CHECK_CACHE", str(tmp_path_factory.mktemp("kernels")))
        yield
