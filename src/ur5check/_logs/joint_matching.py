"""Which joint of a recording is which joint of the model: by name, by suffix, or by order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._errors import UsageError
from .recording import Recording

__all__ = ["joint_order"]

How = Literal["name", "suffix", "order"]


def joint_order(
    recording: Recording, joints: Sequence[str], *, by_order: bool
) -> tuple[list[int], How]:
    """The recording's joint for each of the model's, and how they were matched.

    Names that differ by a prefix ("left_arm_joint_1", "joint_1") match where each suffix is met
    once.  Joints without names are taken in order.  Raises UsageError where names do not match.
    """
    names = recording.joints
    if by_order or names[0] == "joint 1":
        if len(names) != len(joints):
            raise UsageError(
                f"{recording.file}: has {len(names)} joints, the model {len(joints)}; name the "
                "columns, or take another --base or --tip"
            )
        return list(range(len(joints))), "order"
    if all(joint in names for joint in joints):
        return [names.index(joint) for joint in joints], "name"
    matches = [_by_suffix(joint, names) for joint in joints]
    found = [match for match in matches if match is not None]
    if len(found) == len(joints) == len(set(found)):
        return found, "suffix"
    missing = (
        next(joint for joint, match in zip(joints, matches, strict=True) if match is None)
        if None in matches
        else joints[0]
    )
    raise UsageError(
        f"{recording.file}: no joint like {missing!r}; it has {', '.join(names)}; "
        "--match-order takes them in order"
    )


def _by_suffix(joint: str, names: Sequence[str]) -> int | None:
    alike = [k for k, name in enumerate(names) if name.endswith(joint) or joint.endswith(name)]
    return alike[0] if len(alike) == 1 else None
