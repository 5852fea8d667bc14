"""Joint states of a ROS bag, ROS 2 (sqlite3, MCAP) or ROS 1, read by rosbags without ROS."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from .._errors import UsageError
from .._robot.transforms import Array

__all__ = ["BAG_SUFFIXES", "JointStates", "read_bag"]

BAG_SUFFIXES = (".db3", ".mcap", ".bag")

#: joint names; times by the messages' own stamps [s]; position, velocity, effort, each (N, n)
JointStates = tuple[tuple[str, ...], Array, Array, Array, Array]

_TYPE = "sensor_msgs/msg/JointState"


def read_bag(path: Path, topic: str = "") -> tuple[JointStates, str]:
    """The joint states of one topic, and the topic.

    path : a .db3, .mcap or .bag file, or a ROS 2 bag's folder
    topic : which one, where there are several

    A quantity that a message leaves out is nan in its row.  Messages that have other joints than
    the first are left out (grippers publish on the same topic).  Raises UsageError.
    """
    try:
        from rosbags.highlevel import AnyReader, AnyReaderError
        from rosbags.typesys import Stores, get_typestore
    except ImportError:
        raise UsageError("reading bags needs rosbags: pip install 'ur5check[logs]'") from None
    store = get_typestore(Stores.ROS1_NOETIC if path.suffix == ".bag" else Stores.ROS2_HUMBLE)
    try:
        with AnyReader([path], default_typestore=store) as reader:
            chosen = _connection(reader.connections, topic, path)
            messages: list[Any] = [
                reader.deserialize(raw, connection.msgtype)
                for connection, _, raw in reader.messages(connections=chosen)
            ]
    except AnyReaderError as error:
        raise UsageError(f"{path}: cannot be read as a bag: {error}") from None
    if not messages:
        raise UsageError(f"{path}: topic {chosen[0].topic} has no message")
    names = tuple(messages[0].name)
    same = [message for message in messages if tuple(message.name) == names]
    t = np.array([m.header.stamp.sec + 1e-9 * m.header.stamp.nanosec for m in same])
    q, qd, tau = (
        np.array([_row(getattr(m, field), len(names)) for m in same])
        for field in ("position", "velocity", "effort")
    )
    return (names, t, q, qd, tau), chosen[0].topic


def _row(values: Array, n: int) -> Array:
    return values if len(values) == n else np.full(n, np.nan)


def _connection(connections: list[Any], topic: str, path: Path) -> list[Any]:
    states = [c for c in connections if c.msgtype == _TYPE]
    topics = sorted({c.topic for c in states})
    if not topics:
        raise UsageError(f"{path}: has no topic of type {_TYPE}")
    if topic and topic not in topics:
        raise UsageError(f"{path}: {topic} is no topic of joint states; there are {topics}")
    if not topic and len(topics) > 1:
        raise UsageError(f"{path}: has several topics of joint states; name one: --topic {topics}")
    return [c for c in states if c.topic == (topic or topics[0])]
