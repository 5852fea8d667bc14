"""Bags written by rosbags' own writers: ROS 2 in sqlite3 and MCAP, ROS 1."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_typestore

from logs.recorded import Motion
from ur5check import Ur5checkError
from ur5check._logs.options import RecordingOptions
from ur5check._logs.reading import read_recording

JOINTS = ("pan", "lift", "roll")
TYPE = "sensor_msgs/msg/JointState"


def write_bag(folder: Path, kind: str, motion: Motion, topics: tuple[str, ...] = ("/js",)) -> Path:
    """Every second message is a gripper's, whose joints are none of the arm's."""
    store = get_typestore(Stores.ROS1_NOETIC if kind == "ros1" else Stores.ROS2_HUMBLE)
    Header, Time, State = (
        store.types[name] for name in ("std_msgs/msg/Header", "builtin_interfaces/msg/Time", TYPE)
    )
    writer: Any
    if kind == "ros1":
        path = folder / "run.bag"
        writer = Writer1(path)
    else:
        path = folder / f"run_{kind}"
        plugin = StoragePlugin.MCAP if kind == "mcap" else StoragePlugin.SQLITE3
        writer = Writer2(path, version=8, storage_plugin=plugin)
    with writer:
        links = [writer.add_connection(topic, TYPE, typestore=store) for topic in topics]
        for k, stamp in enumerate(np.rint(motion.t * 1e9).astype(int).tolist()):
            stamp += 1_700_000_000_000_000_000
            time = Time(sec=stamp // 10**9, nanosec=stamp % 10**9)
            head = Header(stamp=time, frame_id="", **({"seq": k} if kind == "ros1" else {}))
            arm = State(head, ["lift", "pan", "roll"], *(
                values[k][[1, 0, 2]] for values in (motion.q, motion.qd, motion.tau)
            ))  # fmt: skip
            hand = State(head, ["finger"], np.ones(1), np.zeros(0), np.zeros(0))
            for message in (arm, hand):
                raw = (store.serialize_ros1 if kind == "ros1" else store.serialize_cdr)(
                    message, TYPE
                )
                for link in links:
                    writer.write(link, stamp, raw)
    return path


@pytest.mark.parametrize("kind", ["sqlite3", "mcap", "ros1"])
def test_joint_states_of_a_bag(motion: Motion, tmp_path: Path, kind: str) -> None:
    short = Motion(*(values[:300] for values in (motion.t, motion.q, motion.qd, motion.tau)))
    recording, findings = read_recording(write_bag(tmp_path, kind, short), JOINTS)
    assert recording.joints == JOINTS
    # Seconds since 1970 as floats: a quarter of a microsecond.
    assert np.abs((recording.t - recording.t[0]) - short.t).max() < 1e-6
    for name in ("q", "qd", "tau"):
        assert np.array_equal(getattr(recording, name), getattr(short, name))
    assert findings == ()


def test_a_file_of_a_bag_does_as_well(motion: Motion, tmp_path: Path) -> None:
    short = Motion(*(values[:60] for values in (motion.t, motion.q, motion.qd, motion.tau)))
    for kind, suffix in (("sqlite3", "db3"), ("mcap", "mcap")):
        folder = write_bag(tmp_path, kind, short)
        (file,) = folder.glob(f"*.{suffix}")
        assert read_recording(file, JOINTS)[0].count == 60


def test_several_topics_need_a_name(motion: Motion, tmp_path: Path) -> None:
    short = Motion(*(values[:60] for values in (motion.t, motion.q, motion.qd, motion.tau)))
    bag = write_bag(tmp_path, "sqlite3", short, ("/left", "/right"))
    with pytest.raises(Ur5checkError, match="--topic"):
        read_recording(bag, JOINTS)
    with pytest.raises(Ur5checkError, match="/js"):
        read_recording(bag, JOINTS, RecordingOptions(topic="/js"))
    assert read_recording(bag, JOINTS, RecordingOptions(topic="/left"))[0].count == 60


def test_what_is_no_bag_is_refused(tmp_path: Path) -> None:
    for name in ("run.db3", "run.bag", "run.mcap"):
        (tmp_path / name).write_text("no bag")
        with pytest.raises(Ur5checkError, match=name):
            read_recording(tmp_path / name, JOINTS)
