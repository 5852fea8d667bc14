"""A sweep in a few sentences, the verdict first."""

from __future__ import annotations

import numpy as np

from .._sweep.reach_map import HEIGHTS
from .._sweep.sweep_result import Sweep

__all__ = ["sample_in_words", "summarize"]


def summarize(s: Sweep) -> tuple[str, ...]:
    """Verdict, how usual it is, how often a limit is passed, where the tool is then."""
    sentences = [_verdict(s)]
    if not s.agrees:
        sentences += [_usual(s), _over(s), _where(s)]
    return tuple(sentence for sentence in sentences if sentence)


def sample_in_words(s: Sweep) -> str:
    """The states as "1,000,000 random states"."""
    of = s.plan.sample.description()
    match of["kind"]:
        case "random":
            return f"{s.count:,} random states"
        case "sobol":
            return f"{s.count:,} Sobol points"
        case "grid":
            return f"{s.count:,} postures at rest ({of['levels']} of each joint)"
    return f"{s.count:,} states of {of['file']}"


def _verdict(s: Sweep) -> str:
    a, b = s.pair.a.label, s.pair.given_b.label
    j = int(s.maximum.argmax())
    size = f"{s.maximum[j]:.3g} N m"
    among = f"at {sample_in_words(s)}"
    if s.agrees:
        return f"{a} and {b} need the same torques {among}: none differs by more than {size}."
    share = s.share_of_effort()[j]
    of = "" if np.isnan(share) else f", {share:.0%} of its limit"
    return (
        f"{a} and {b} need different torques {among}: up to {size} apart "
        f"(joint {j + 1}, {s.pair.a.joints[j].name}{of})."
    )


def _usual(s: Sweep) -> str:
    j = int(s.maximum.argmax())
    half, most = s.quantile(0.5)[j], s.quantile(0.99)[j]
    return (
        f"At that joint, half of the states stay below {half:.3g} N m, 99 % below {most:.3g} N m."
    )


def _over(s: Sweep) -> str:
    share, limits = s.share_over(), s.plan.tolerance
    if share is None or limits is None:
        return ""
    j = int(share.argmax())
    if share[j] == 0.0:
        return "No state exceeds the limit of --tolerance."
    never = int((share == 0.0).sum())
    rest = f"; {never} of {len(share)} joints never pass theirs" if never else ""
    passes = f"passes {limits[j]:.4g} N m at {share[j]:.2%} of the states"
    return f"Joint {j + 1}, {s.pair.a.joints[j].name}, {passes}{rest}."


def _where(s: Sweep) -> str:
    highest = s.statistics.reach.max(axis=0)
    column, row = divmod(int(highest.argmax()), HEIGHTS)
    grid = s.plan.grid
    radius = grid.radii()[column : column + 2].mean()
    height = grid.heights()[row : row + 2].mean()
    return (
        f"The largest on the reach map, {highest.max():.3g} N m, is reached with the tool "
        f"{radius:.2f} m from the base's z axis, {abs(height):.2f} m "
        f"{'above' if height >= 0 else 'below'} the base."
    )
