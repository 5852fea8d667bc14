"""The appendix's soft limits: a safety controller acts only if they lie inside the hard limits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from .._io.ros_packages import default_packages
from .._io.shipped_models import lookup
from .._io.xacro.xacro_reader import expand_xacro
from .._io.xml.safe_xml import parsed_xml
from .claim import Claim, ClaimOutcome, Trial, judged
from .evidence import Evidence
from .paper_models import Form

__all__ = ["SoftLimits", "read_soft_limits", "soft_limit_trial", "soft_limits"]


@dataclass(frozen=True)
class SoftLimits:
    """One joint's limits [rad], and the soft limits inside them."""

    joint: str
    lower: float
    upper: float
    soft_lower: float
    soft_upper: float

    @property
    def margin(self) -> float:
        """Distance of soft limits inside the hard ones, worse side [rad]; negative: outside."""
        return min(self.soft_lower - self.lower, self.upper - self.soft_upper)


def soft_limits(evidence: Evidence) -> Iterator[ClaimOutcome]:
    """Every soft limit lies inside the joint's own limit."""
    evidence.say("expanding the appendix with its soft limits")
    claim = Claim(
        "soft-limits",
        "The soft limits lie inside each joint's own limits",
        "smallest distance from a soft limit in to the hard one: above 0, or it never acts",
        "appendix, safety_controller",
        "rad",
    )
    both: tuple[tuple[str, Form, str], ...] = (
        ("appendix", "printed", "false"),
        ("appendix, limited:=true", "other", "true"),
    )
    yield from judged(
        claim,
        (soft_limit_trial(name, form, _appendix(limited)) for name, form, limited in both),
    )


def soft_limit_trial(name: str, form: Form, limits: tuple[SoftLimits, ...]) -> Trial:
    """The joint whose soft limits lie furthest out."""
    worst = min(limits, key=lambda joint: joint.margin)
    why = f"{worst.joint}: soft ±{worst.soft_upper:.3f}, hard ±{worst.upper:.3f} rad"
    return Trial(name, form, worst.margin, 0.0, why, "above")


def read_soft_limits(urdf: str) -> tuple[SoftLimits, ...]:
    """Of every joint of a URDF that has a safety_controller."""
    found = []
    for joint in parsed_xml(urdf).iterfind("joint"):
        limit, safety = joint.find("limit"), joint.find("safety_controller")
        if limit is not None and safety is not None:
            hard = (float(limit.get(end)) for end in ("lower", "upper"))
            soft = (float(safety.get(f"soft_{end}_limit")) for end in ("lower", "upper"))
            found.append(SoftLimits(joint.get("name"), *hard, *soft))
    return tuple(found)


def _appendix(limited: str) -> tuple[SoftLimits, ...]:
    expansion = expand_xacro(
        lookup("appendix").path(),
        arguments={"safety_limits": "true", "limited": limited},
        packages=default_packages(),
    )
    return read_soft_limits(expansion.text)
