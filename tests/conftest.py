"""Settings of all tests: Hypothesis draws the same examples on every run, so that a failure can be
reproduced (`--hypothesis-profile=fresh` draws new ones); generated code has a folder of its own.
Here are also the fixtures that several folders use; what they need is imported when they are used.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.database import DirectoryBasedExampleDatabase

if TYPE_CHECKING:
    from ur5check._paper.evidence import Evidence
    from ur5check._paper.reproduction import Reproduction

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


@pytest.fixture(scope="session")
def evidence() -> Evidence:
    """What the paper's claims are judged by, computed once."""
    from ur5check._paper.evidence import gather

    return gather(lambda line: None)


@pytest.fixture(scope="session")
def reproduction(evidence: Evidence) -> Reproduction:
    """The paper at rest: its numbers, its nine cases, its limits."""
    from ur5check._paper.claims import OF_CASES, OF_DERIVATION, OF_GEOMETRY, OF_LIMITS, OF_NUMBERS
    from ur5check._paper.reproduction import judge

    return judge(evidence, (*OF_GEOMETRY, *OF_DERIVATION, *OF_NUMBERS, *OF_CASES, *OF_LIMITS))


@pytest.fixture
def plant(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], str]:
    """`plant(class name)`: registers an engine of `planted_engines`, returns its key."""
    import planted_engines
    from ur5check._engines.engine_entry import EngineEntry
    from ur5check._engines.registry import REGISTRY

    def enter(name: str) -> str:
        assert hasattr(planted_engines, name)
        engine = getattr(planted_engines, name)
        entry = EngineEntry(key=name.lower(), title=name, order=99, make=engine)
        monkeypatch.setitem(REGISTRY, entry.key, entry)
        return entry.key

    return enter
