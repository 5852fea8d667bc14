"""How many planted faults the rules find, under the right rule, and what they find in sound robots.

    python benchmarks/bench_rules.py [--seed N] [--missed]

Robots are those of example-robot-data whose files have no error.  Half of them were used to set
thresholds ("tuning"), half were not ("reporting"); both are printed.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections import defaultdict
from pathlib import Path
from xml.etree import ElementTree as ET

from planted_faults import KINDS, Kind, planted

from ur5check._finding import Finding
from ur5check._io.robot_loading import read_robot
from ur5check._io.ros_packages import example_robot_data
from ur5check._rules.check import check_rules
from ur5check._rules.rule_subject import RuleSubject

TUNING = (
    "ur_description/urdf/ur3_robot.urdf",
    "ur_description/urdf/ur10_robot.urdf",
    "panda_description/urdf/panda.urdf",
    "kinova_description/robots/kinova.urdf",
    "z1_description/urdf/z1.urdf",
    "xarm_description/urdf/xarm7.urdf",
    "so_arm_description/urdf/so101.urdf",
    "solo_description/robots/solo12.urdf",
    "talos_data/robots/talos_left_arm.urdf",
    "tiago_pro_description/robots/tiago_pro.urdf",
    "g1_description/urdf/g1_29dof_rev_1_0.urdf",
    "go2_description/urdf/go2.urdf",
    "laikago_description/urdf/laikago.urdf",
    "alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf",
)
REPORTING = (
    "ur_description/urdf/ur3_gripper.urdf",
    "so_arm_description/urdf/so100.urdf",
    "talos_data/robots/talos_full_v2.urdf",
    "centauro_description/urdf/centauro.urdf",
    "baxter_description/urdf/baxter.urdf",
    "human_description/robots/human.urdf",
    "bolt_description/robots/bolt.urdf",
    "quadruped_description/urdf/quadruped.urdf",
    "b1_description/urdf/b1.urdf",
    "a1_description/urdf/a1.urdf",
    "anymal_b_simple_description/robots/anymal.urdf",
    "hextilt_description/urdf/hextilt_flying_arm_5.urdf",
    "alex_description/urdf/alex_nub_hands.urdf",
    "g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf",
)


def findings_of(text: str, folder: Path) -> list[Finding]:
    """What the rules find in a file's text, shapes without meshes."""
    file = folder / "robot.urdf"
    file.write_text(text, encoding="utf-8")
    reading = read_robot(file)
    if reading.robot is None:
        return list(reading.findings)
    return check_rules(RuleSubject(reading.robot), reading.findings)


def key(finding: Finding) -> tuple[str, str]:
    """What makes two findings of a file and its spoiled copy the same."""
    return finding.rule, finding.subject


def run(robots: dict[str, Path], seed: int) -> tuple[dict[str, list[int]], list[str], int, int]:
    """Per kind [planted, detected, first]; what was missed; links and errors of the sound files."""
    counts: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0])
    missed: list[str] = []
    links = errors = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for name, path in robots.items():
            print(f"{name}", file=sys.stderr)
            root = ET.fromstring(path.read_bytes())  # noqa: S314 - installed with this program
            clean = findings_of(ET.tostring(root, encoding="unicode"), folder)
            known = {key(finding) for finding in clean}
            links += len(root.findall("link"))
            errors += sum(finding.severity == "error" for finding in clean)
            for kind in KINDS:
                _try(kind, name, root, known, folder, seed, counts, missed)
    return counts, missed, links, errors


def _try(
    kind: Kind, name: str, root: ET.Element, known: set[tuple[str, str]], folder: Path, seed: int,
    counts: dict[str, list[int]], missed: list[str],
) -> None:  # fmt: skip
    made = planted(root, kind, seed)
    if made is None:
        return
    text, subject = made
    new = [f for f in findings_of(text, folder) if key(f) not in known]
    hits = [
        f
        for f in new
        if f.rule in kind.rules
        and (f.subject in ("robot", "file") or subject in f"{f.subject} {f.message}")
    ]
    counts[kind.name][0] += 1
    counts[kind.name][1] += bool(hits)
    counts[kind.name][2] += bool(new) and new[0].rule in kind.rules
    if not hits or new[0].rule not in kind.rules:
        shown = ", ".join(f"{f.rule} {f.subject}" for f in new[:3]) or "nothing"
        missed.append(f"{kind.name} in {subject} of {name}: {shown}")


def main() -> None:
    """Print both halves."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--missed", action="store_true", help="list what was missed")
    args = parser.parse_args()
    share = example_robot_data()
    assert share is not None  # noqa: S101 - a dependency of ur5check
    halves = {"tuning": TUNING, "reporting": REPORTING}
    for half, files in halves.items():
        robots = {Path(file).stem: share / "robots" / file for file in files}
        counts, missed, links, errors = run(robots, args.seed)
        total = [sum(column) for column in zip(*counts.values(), strict=True)]
        print(f"{half}: {len(robots)} robots, {len(counts)} kinds, {total[0]} faults planted")
        print(f"  detected {total[1] / total[0]:.1%}, right rule first {total[2] / total[0]:.1%}")
        print(f"  sound files: {errors} errors in {links} links")
        if args.missed:
            print("\n".join(f"  missed: {line}" for line in missed))


if __name__ == "__main__":
    main()
