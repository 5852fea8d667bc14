"""The process in which Drake (libsdformat) reads a model: request and answer are JSON.

Poses and axes are Drake's: relative to frames, joints relative to links.
"""

from __future__ import annotations

import json
import logging
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..bounded_process import limit_resources

__all__ = ["main"]


def main() -> None:
    """Answer one request: {"text", "root", limits}; root : the link whose orientation is asked."""
    answer_file = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what Drake prints is no part of the answer
    request = json.loads(sys.stdin.buffer.read())
    limit_resources(
        seconds=request["seconds"],
        memory=request["memory_bytes"],
        file_size=request["output_bytes"],
    )
    try:
        answer = _read(request["text"], request["root"])
    except Exception as error:  # noqa: BLE001 - whatever it is, the answer must say it
        answer = {"refused": f"{type(error).__name__} in Drake: {error}"}
    with os.fdopen(answer_file, "wb") as file:
        file.write(json.dumps(answer).encode())


def _read(text: str, root: str) -> dict[str, Any]:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    with _log_kept() as said:
        try:
            Parser(plant).AddModelsFromString(text, "sdf")
            plant.Finalize()
        except RuntimeError as error:
            return {"refused": str(error)}
    context = plant.CreateDefaultContext()
    body = plant.world_body() if root == "world" else plant.GetBodyByName(root)
    actuators = map(plant.get_joint_actuator, plant.GetJointActuatorIndices())
    motors = {actuator.joint().name(): actuator for actuator in actuators}
    return {
        "said": said,
        "joints": {
            joint.name(): _joint(joint, motors.get(joint.name()))
            for joint in map(plant.get_joint, plant.GetJointIndices())
            if not joint.is_ephemeral()
        },
        "orientation": plant.EvalBodyPoseInWorld(context, body).rotation().matrix().tolist(),
    }


def _joint(joint: Any, motor: Any) -> dict[str, Any]:
    kind = str(joint.type_name())
    axis = None
    if kind in ("revolute", "prismatic"):
        axis = joint.revolute_axis() if kind == "revolute" else joint.translation_axis()
        axis = axis.tolist()
    moves = axis is not None
    rotor = 0.0 if motor is None else motor.default_rotor_inertia()
    return {
        "kind": kind,
        "parent": joint.parent_body().name(),
        "child": joint.child_body().name(),
        "axis": axis,
        "lower": joint.position_lower_limit() if moves else None,
        "upper": joint.position_upper_limit() if moves else None,
        "velocity": joint.velocity_upper_limit() if moves else None,
        "armature": rotor * motor.default_gear_ratio() ** 2 if rotor else 0.0,
        "origin": _matrix(joint.frame_on_parent()),
        "child_frame": _matrix(joint.frame_on_child()),
    }


def _matrix(frame: Any) -> list[list[float]]:
    matrix: list[list[float]] = frame.GetFixedPoseInBodyFrame().GetAsMatrix4().tolist()
    return matrix


@contextmanager
def _log_kept() -> Iterator[list[str]]:
    """Drake's warnings become notes instead of lines on stderr."""
    said: list[str] = []
    logger, handler = logging.getLogger("drake"), logging.Handler(logging.WARNING)
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    logger.addHandler(handler)
    logger.propagate = False
    try:
        yield said
    finally:
        logger.removeHandler(handler)
