"""Two robots with several chains, limb by limb."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from numpy.typing import ArrayLike

from .._errors import InputError
from .._io.robot_limbs import Limbs, matched_limbs
from .difference import Difference, diff

__all__ = ["LimbComparison", "LimbPair", "compare_limbs"]


@dataclass(frozen=True, eq=False)
class LimbPair:
    """One limb in both robots.

    a, b : its name, that of its last link; None in a robot that has not got it
    difference : None where it cannot be compared;  problem : why not
    """

    a: str | None
    b: str | None
    difference: Difference | None
    problem: str = ""

    @property
    def agrees(self) -> bool:
        """Whether it is in both robots, can exist and is the same."""
        d = self.difference
        return d is not None and d.agrees and not any(d.faults.values())


@dataclass(frozen=True, eq=False)
class LimbComparison:
    """Two robots, limb by limb; limbs overlap where they have a torso in common."""

    a: Limbs
    b: Limbs
    limbs: tuple[LimbPair, ...]

    @property
    def agrees(self) -> bool:
        """Whether all limbs agree."""
        return all(limb.agrees for limb in self.limbs)


def compare_limbs(
    a: Limbs,
    b: Limbs,
    *,
    samples: int,
    seed: int,
    gravity: ArrayLike | None = None,
    tolerance: float | str | None = None,
    as_written: bool = False,
    progress: Callable[[str], None],
) -> LimbComparison:
    """`diff` of every limb that both have."""
    found = []
    for name_a, name_b in matched_limbs(a, b):
        if name_a is None or name_b is None:
            which = "second" if name_a is None else "first"
            found.append(LimbPair(name_a, name_b, None, f"only in the {which} file"))
            continue
        progress(f"comparing {name_a}")
        arms = (a.arms[name_a], b.arms[name_b])
        problems = [str(arm) for arm in arms if isinstance(arm, InputError)]
        difference = None
        if not problems:
            try:
                difference = diff(
                    *(arm for arm in arms if not isinstance(arm, InputError)),
                    samples=samples,
                    seed=seed,
                    gravity=gravity,
                    tolerance=tolerance,
                    as_written=as_written,
                )
            except InputError as error:
                problems = [str(error)]
        found.append(LimbPair(name_a, name_b, difference, "; ".join(problems)))
    return LimbComparison(a, b, tuple(found))
