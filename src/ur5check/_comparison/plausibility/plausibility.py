"""Findings on mass and inertia of each link, given its size.

The laws of dynamics hold for any numbers. A body has a shape, and its mass lies within it:

    pseudo-inertia     J = [[Σ, m c], [(m c)ᵀ, m]] is positive definite, Σ = ∫ x xᵀ dm
                       (Wensing, Kim & Slotine 2018)
    triangle           I_a + I_b ≥ I_c: the same as Σ_c having no negative eigenvalue
    centre of mass     lies in the convex hull of the body
    radius of gyration k = √(I/m) about an axis is at most the distance of the body's farthest
                       corner from that axis, since I = ∫ ρ² dm ≤ m ρ_max²
    density            m / V

The first four are theorems: a number beyond them is impossible for the body that the mesh shows.
The density, and the bounds of `plausible_reach`, are
ranges of robot arms, with a reason beside each bound: outside them a number is suspicious. Without
a mesh only the reach of a link, from joint to joint, is known, and no finding is "impossible".
"""

from __future__ import annotations

from ..._arguments import instance
from ..._io.meshes.mesh_shapes import Meshes, link_meshes
from ..._robot.as_arm import ArmSource, as_arm
from .plausible_body import Plausibility, body_findings
from .plausible_extent import extent_findings
from .plausible_reach import reach_findings, whole_findings

__all__ = ["Plausibility", "plausibility"]


def plausibility(arm: ArmSource, meshes: Meshes | None = None) -> tuple[Plausibility, ...]:
    """Implausible numbers of an arm, link by link, then of the whole arm.

    Parameters
    ----------
    arm : name, path, pin.Model or SerialArm
        See `load`.
    meshes : Meshes, optional
        The links' shapes; those that the arm's URDF names when None.

    Returns
    -------
    tuple of Plausibility
        Empty if nothing is implausible.  These are no failures: the numbers may be right.

    Raises
    ------
    InputError
        For an arm that cannot be read, or another type of meshes.

    References
    ----------
    Wensing, Kim & Slotine 2018; Traversaro et al. 2016.

    Examples
    --------
    >>> import ur5check
    >>> {found.severity for found in ur5check.plausibility("paper")}
    {'suspicious'}
    """
    arm = as_arm(arm)
    if meshes is not None:
        instance("meshes", meshes, Meshes, "leave it out to use those that the URDF names")
    shown = link_meshes(arm) if meshes is None else meshes
    findings = [
        Plausibility("note", None, arm.name, "mesh", None, None, "", f"Not checked: {note}.")
        for note in shown.notes
    ]
    for number, (link, shapes) in enumerate(zip(arm.links, shown.links, strict=True), 1):
        own = body_findings(number, link)
        findings += own
        if link.inertia.mass <= 0.0:
            continue  # reported above; the checks below need a mass
        if shapes:
            findings += extent_findings(number, link, shapes)
        else:
            findings += reach_findings(number, link)
    return (*findings, *whole_findings(arm))
