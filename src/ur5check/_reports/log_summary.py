"""A model against a recording in a few sentences, the verdict first."""

from __future__ import annotations

import math

from .._comparison.diagnosis.mistakes import LINK_MISTAKES
from .._logs.cause import Cause
from .._logs.comparison import AT_FLOOR, GAIN_KNOWN, RecordingComparison
from .wording import coordinates, joined

__all__ = ["cause_in_words", "summarize_log", "verdict_of_log", "word_of_log"]


def word_of_log(c: RecordingComparison) -> str:
    """PASS, FAIL or UNUSABLE."""
    if not c.usable or not c.judged:
        return "UNUSABLE"
    return "PASS" if c.at_floor else "FAIL"


def verdict_of_log(c: RecordingComparison) -> str:
    """The first sentence."""
    name = c.arm.label
    if not c.usable:
        return (
            "These torques were computed by a controller, not measured: they say nothing about "
            f"{name}."
        )
    if not c.judged:
        return f"At no joint does the torque of {name} stand out: nothing can be said about it."
    joints = f"{len(c.judged)} of {len(c.joints)} joints"
    if c.at_floor:
        return (
            f"{name} explains the recording as well as the best parameters of its geometry would, "
            f"judged at {joints}, with friction and rotor inertia of each drive."
        )
    worst = max(c.judged, key=lambda joint: joint.above_floor)
    return (
        f"{name} leaves {worst.above_floor:.1f} times the torque unexplained that the best "
        f"parameters of its geometry leave ({worst.name}: {worst.with_rotor:.3g} N m against "
        f"{worst.floor:.3g})."
    )


def summarize_log(c: RecordingComparison) -> tuple[str, ...]:
    """The sentences after the verdict: what would explain it, and of which joints nothing is
    said.
    """
    if not c.usable:
        return ()
    lines = []
    if c.named:
        first, *others = c.named
        best = "One cause explains it" if not others else "One cause explains it best"
        lines.append(f"{best}: {cause_in_words(first, c)}.")
        lines += [f"Also possible: {cause_in_words(other, c)}." for other in others[:2]]
    elif not c.at_floor:
        lines.append(
            "No single cause explains it: no gain, payload, tilted gravity, joint's zero or sign, "
            "and neither one link's numbers nor a known mistake in them."
        )
    elif c.remarks:
        first, *others = c.remarks
        or_another = f", or as well {cause_in_words(others[0], c)}" if others else ""
        lines.append(
            f"Within the floor's margin, yet clear: {cause_in_words(first, c)}{or_another}."
        )
    lines += _other_recordings(c)
    for rival in c.rivals:
        better = "better" if rival.difference > 0.0 else "worse"
        lines.append(
            f"{c.arm.label} explains it {better} than {rival.label}: mean squared residuals over "
            f"the floor's differ by {abs(rival.difference):.3g} ± {rival.half_width:.2g}."
            if rival.clear
            else f"{rival.label} explains it as well, within the scatter between blocks of time."
        )
    differing = [parameter for parameter in c.parameters if parameter.differs]
    if differing and not c.at_floor and not c.named:
        lines.append(
            f"{len(differing)} of {len(c.parameters)} base parameters differ clearly (--full); "
            "--repair writes the nearest model that explains the recording."
        )
    silent = [joint.name for joint in c.joints if not joint.stands_out]
    if silent:
        lines.append(
            f"No statement about {joined(silent)}: the model's torque there is smaller than what "
            "friction leaves unexplained."
        )
    negative = [joint.name for joint in c.judged if _clearly_negative(joint.drive)]
    if negative:
        lines.append(
            f"The rotor inertia of {joined(negative)} comes out negative: the model's own inertia "
            "about that axis is too large, or velocities are late."
        )
    return tuple(lines)


def _other_recordings(c: RecordingComparison) -> list[str]:
    lines = []
    if c.load is not None:
        value, width = c.load.value, c.load.half_width
        lines.append(
            f"Against the unloaded run the robot carried {value[0]:.4g} ± {width[0]:.2g} kg at "
            f"{coordinates(value[1:])} m in the frame of {c.arm.source.tip}; a wrong drive gain "
            "scales it."
        )
    if c.validation is not None:
        v = c.validation
        used = "help" if v.helps else "do not help"
        ratio = float((v.fitted / v.given).mean())
        lines.append(
            f"Parameters fitted here {used} on {v.file}: on average {ratio:.2f} times the residual "
            "of the given model."
        )
    return lines


def _clearly_negative(drive: object) -> bool:
    value, width = drive.value[-1], drive.half_width[-1]  # type: ignore[attr-defined]
    return bool(value + width < 0.0)


def cause_in_words(cause: Cause, c: RecordingComparison) -> str:
    """A cause with its values and nominal 95 % intervals."""
    value, width = cause.value, cause.half_width
    joint = c.joints[cause.joint - 1].name if cause.joint else ""
    match cause.id:
        case "gain-of-all":
            return f"all measured torques are {value[0]:.3f} ± {width[0]:.3f} times the model's"
        case "gain-of-joint":
            return (
                f"the measured torque of {joint} is {value[0]:.3f} ± {width[0]:.3f} times the "
                "model's (drive gain)"
            )
        case "payload":
            carried = "the robot carried" if value[0] > 0.0 else "the robot lacked"
            return (
                f"{carried} {abs(value[0]):.3g} ± {width[0]:.2g} kg at {coordinates(value[1:])} m "
                f"in the frame of {c.arm.source.tip}"
            )
        case "gravity-direction":
            return f"the base is tilted by {value[3]:.2f} ± {width[3]:.2f}° against the model's"
        case "joint-zero":
            if c.arm.joints[cause.joint - 1].kind == "prismatic":
                return f"{joint} counts from a zero {1e3 * value[0]:.3g} mm off"
            return (
                f"{joint} counts from a zero {math.degrees(value[0]):.3g} ± "
                f"{math.degrees(width[0]):.2g}° off"
            )
        case "joint-sign":
            return f"{joint} turns the other way in the recording"
        case "mistake":
            says = next(m.says for m in LINK_MISTAKES if m.id == cause.mistake)
            return f"a mistake in {_link(cause, c)}: {says} ({cause.how})"
        case "link-mass":
            own = c.arm.links[cause.joint - 1].inertia.mass
            return (
                f"parameters of {_link(cause, c)}: with centre and tensor as they are, the mass is "
                f"{value[0]:.4g} ± {width[0]:.2g} kg instead of {own:.4g}"
            )
        case "link-centre":
            return (
                f"parameters of {_link(cause, c)}: with mass and tensor as they are, the centre of "
                f"mass is {coordinates(value)} m, at most ± {max(width):.2g}"
            )
        case "link-tensor":
            return f"parameters of {_link(cause, c)}: its tensor, with mass and centre as they are"


def _link(cause: Cause, c: RecordingComparison) -> str:
    return f"link {cause.joint} ({c.arm.links[cause.joint - 1].name})"


def floor_in_words() -> str:
    """What is called at the floor."""
    return (
        f"At the floor: at most {AT_FLOOR:g} times what all base parameters, friction and rotor "
        "inertia leave when they are fitted to this recording, or above it by less than "
        f"{GAIN_KNOWN:.0%} of the model's torque, as a gain that is wrong by so much would leave."
    )
