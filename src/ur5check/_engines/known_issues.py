"""Known known issues of readers: what each does to a model, why, and what helps.

A known issue has an id by which reports, docs and tests name it, and the kinds of import difference
that it explains (listed in `audit.import_difference`).  Some are harmless, some change torques.
Where a rewritten file helps, `repaired` writes it; where only a human can (a tensor that no body
has), the fix says what to do.

Measured with Pinocchio 4.1, MuJoCo 4.0, Drake 1.51, DART 6.20 and iDynTree 15.1.
"""

from __future__ import annotations

from dataclasses import replace

from lxml import etree

from .._errors import UsageError
from .._robot.serial_arm import SerialArm
from .engine_urdf import written
from .known_issue import KnownIssue
from .urdf_repairs import (
    fix_root_to_world,
    give_base_mass,
    keep_shapes_massless,
    say_effort_in_transmissions,
    write_massless_links,
    write_no_limit,
)

__all__ = [
    "KNOWN_ISSUES",
    "TARGETS",
    "known_issue_for",
    "known_issues_of",
    "repaired",
    "repaired_text",
]


KNOWN_ISSUES: tuple[KnownIssue, ...] = (
    KnownIssue(
        "pinocchio-merges-fixed-links",
        "pinocchio",
        ("body-merged", "base-kept", "base-ignored"),
        False,
        "fixed links are merged into their parents",
        "Links behind fixed joints become part of the moving link that carries them, those on the "
        "base part of the universe, where they weigh nothing on any joint.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "pinocchio-continuous-joint",
        "pinocchio",
        ("coordinates",),
        False,
        "a continuous joint takes two coordinates",
        "It is held as (cos q, sin q), so that nq exceeds nv.",
        "none is needed here; in your own code use pin.integrate and model.joints[i].nq",
    ),
    KnownIssue(
        "mujoco-mass-from-shape",
        "mujoco",
        ("shape-mass",),
        True,
        "a link without <inertial> gets the mass of its collision shape",
        "A body without an inertial is filled with the density of water, 1000 kg/m³, wherever it "
        "has a collision shape, and melted into the link that carries it.",
        'set <mujoco><compiler inertiafromgeom="false"/></mujoco>; `ur5check expand --for mujoco`',
        keep_shapes_massless,
    ),
    KnownIssue(
        "mujoco-fuses-fixed-links",
        "mujoco",
        ("body-merged", "body-lost"),
        False,
        "fixed links melt into their parents",
        "Links behind fixed joints lose their names and frames, the tool's among them "
        "(fusestatic, on for URDF); their inertias are kept.",
        "none is needed for torques; for the frames set fusestatic='false'",
    ),
    KnownIssue(
        "mujoco-base-is-world",
        "mujoco",
        ("base-ignored",),
        False,
        "the root link becomes the world",
        "It is held still and its inertia is dropped: a base that stands bears on no joint.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "mujoco-no-velocity-limit",
        "mujoco",
        ("velocity-limit",),
        False,
        "velocity limits are not kept",
        "MuJoCo's joints know position and force ranges only.",
        "limit velocities in the controller",
    ),
    KnownIssue(
        "mujoco-equal-limits",
        "mujoco",
        ("position-limit",),
        False,
        "equal lower and upper limits are ignored",
        "A joint that is limited to one position turns freely.",
        "make it a fixed joint",
    ),
    KnownIssue(
        "drake-impossible-tensor",
        "drake",
        ("tensor-changed", "com-moved", "mass-changed"),
        True,
        "a tensor that no body has is replaced",
        "A tensor that breaks the triangle inequality, if only in its last printed digit, gives "
        "way to that of a solid sphere of water density and the same mass, with a warning on the "
        "log. Moments can shrink a hundredfold.",
        "correct the tensor: print more digits, or raise the smallest moments",
    ),
    KnownIssue(
        "drake-effort-from-transmission",
        "drake",
        ("effort-limit",),
        False,
        "effort limits count only where there is a transmission",
        "A joint has no actuator, and so no effort limit, unless a <transmission> drives it.",
        "add a <transmission> for each joint; `ur5check expand --for drake`",
        say_effort_in_transmissions,
    ),
    KnownIssue(
        "drake-no-friction",
        "drake",
        ("friction",),
        False,
        "dry friction is not kept",
        "A MultibodyPlant has no Coulomb friction in its joints, and says so on the log.",
        "add it as a force of your own",
    ),
    KnownIssue(
        "drake-continuous-limits",
        "drake",
        ("position-limit",),
        False,
        "a continuous joint keeps position limits",
        "Where a continuous joint's <limit> has lower and upper, which mean nothing there, Drake "
        "keeps them.",
        "take lower and upper out of the continuous joint's <limit>",
    ),
    KnownIssue(
        "drake-keeps-base",
        "drake",
        ("base-kept",),
        False,
        "the base keeps its inertia",
        "Links on the base stay bodies; welded to the world they bear on no joint.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "drake-floating-root",
        "drake",
        (),
        True,
        "the root floats unless it is welded",
        "A URDF's root is free in space until WeldFrames, or a root link of the name `world`, "
        "holds it. ur5check welds it.",
        "name the root `world`; `ur5check expand --for drake`",
        fix_root_to_world,
    ),
    KnownIssue(
        "dart-default-inertia",
        "dart",
        ("default-inertia",),
        True,
        "a link without <inertial> weighs 1 kg",
        "DART gives such a link, a tool frame for instance, 1 kg and moments of 1 kg m².",
        "write an <inertial> of mass zero; `ur5check expand --for dart`",
        write_massless_links,
    ),
    KnownIssue(
        "dart-keeps-base",
        "dart",
        ("base-kept",),
        False,
        "the base keeps its inertia",
        "Links on the base stay bodies; standing still they bear on no joint.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "dart-floating-root",
        "dart",
        (),
        True,
        "the root floats unless it is told to stand",
        "DartLoader makes the root joint floating by default. ur5check asks for a fixed one.",
        "set mDefaultRootJointType to FIXED, or hang the root on a link `world`; "
        "`ur5check expand --for dart`",
        fix_root_to_world,
    ),
    KnownIssue(
        "dart-no-motor-inertia",
        "dart",
        ("armature",),
        True,
        "a motor's inertia has no place",
        "DART's joints carry no armature.",
        "add it to the mass matrix, or compare without it",
    ),
    KnownIssue(
        "idyntree-links-become-frames",
        "idyntree",
        ("body-lost", "body-merged"),
        False,
        "massless links at the ends become frames",
        "A link without <inertial> behind a fixed joint is kept as a frame of its parent.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "idyntree-keeps-base",
        "idyntree",
        ("base-kept",),
        False,
        "the base keeps its inertia",
        "iDynTree's base floats, so its inertia is part of the model; held still it bears on no "
        "joint.",
        "none is needed: torques do not change",
    ),
    KnownIssue(
        "idyntree-continuous-limits",
        "idyntree",
        ("position-limit",),
        False,
        "a continuous joint has limits of 0",
        "With a <limit> for effort and velocity, a continuous joint says that it has position "
        "limits, both 0.",
        "read the limits of revolute joints only",
    ),
    KnownIssue(
        "idyntree-no-motor-inertia",
        "idyntree",
        ("armature",),
        True,
        "a motor's inertia has no place",
        "iDynTree's joints carry no armature.",
        "add it to the mass matrix, or compare without it",
    ),
    KnownIssue(
        "gazebo-floating-root",
        "gazebo",
        (),
        True,
        "the root falls unless it hangs on `world`",
        "A model spawned from a URDF is free unless its root is a link named `world`.",
        "hang the root on `world`; `ur5check expand --for gazebo`",
        fix_root_to_world,
    ),
    KnownIssue(
        "gazebo-massless-base",
        "gazebo",
        ("body-lost",),
        True,
        "a base without mass is dropped, and the arm with it",
        "SDFormat leaves out a link that weighs nothing, unless it is fixed to one that weighs, "
        "and all links that hang on it.",
        "give the base a mass; being fixed to the world, it bears on no torque. "
        "`ur5check expand --for gazebo` gives it 1 kg",
        give_base_mass,
    ),
    KnownIssue(
        "gazebo-no-limit",
        "gazebo",
        ("position-limit", "velocity-limit", "effort-limit"),
        False,
        "the largest double is out of range",
        "Written with 16 digits it is more than the largest double, and SDFormat refuses it.",
        "write 1e16, SDFormat's own word for no limit; `ur5check expand --for gazebo`",
        write_no_limit,
    ),
)

#: What `repaired_text` and `ur5check expand --for` write for.
TARGETS = tuple(
    dict.fromkeys(
        known_issue.engine for known_issue in KNOWN_ISSUES if known_issue.rewrite is not None
    )
)


def known_issues_of(key: str) -> tuple[KnownIssue, ...]:
    """The known issues of one engine."""
    return tuple(known_issue for known_issue in KNOWN_ISSUES if known_issue.engine == key)


def known_issue_for(key: str, kind: str) -> KnownIssue | None:
    """The known issue of an engine that explains an import difference of this kind, if one does."""
    return next(
        (known_issue for known_issue in known_issues_of(key) if kind in known_issue.kinds), None
    )


def repaired_text(urdf: str, key: str) -> tuple[str, tuple[KnownIssue, ...]]:
    """A URDF's text, rewritten so that this engine reads it rightly, and the known issues it was
    for.

    Raises UsageError for a key that no fix is known for, ModelError if a name is taken that a
    fix needs.
    """
    if key not in TARGETS:
        raise UsageError(f"nothing needs to be rewritten for {key!r}; choose {', '.join(TARGETS)}")
    parser = etree.XMLParser(resolve_entities=False, no_network=True)
    root = etree.fromstring(urdf.encode(), parser)
    repaired = tuple(
        known_issue for known_issue in known_issues_of(key) if known_issue.applied(root)
    )
    etree.indent(root)
    return written(root), repaired


def repaired(arm: SerialArm, key: str) -> SerialArm:
    """The arm with its URDF rewritten for an engine; as it is where nothing needs rewriting."""
    if arm.source.urdf is None or key not in TARGETS:
        return arm
    text, _ = repaired_text(arm.source.urdf, key)
    return replace(arm, source=replace(arm.source, urdf=text))
