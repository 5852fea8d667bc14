"""Could a link of this size weigh this much, and turn this hard?  Findings, link by link.

The laws of dynamics hold for any numbers.  A body has a shape, though, and its mass lies in it:

    pseudo-inertia     J = [[Σ, m c], [(m c)ᵀ, m]] is positive definite, Σ = ∫ x xᵀ dm
                       (Wensing, Kim & Slotine 2018)
    triangle           I_a + I_b ≥ I_c: the same as Σ_c having no negative eigenvalue
    centre of mass     lies in the convex hull of the body
    radius of gyration k = √(I/m) about an axis is at most the distance of the body's farthest
                       corner from that axis, since I = ∫ ρ² dm ≤ m ρ_max²
    density            m / V

The first four are theorems: a number beyond them is impossible for the body that the mesh shows.
The rest are known issues of robots, with a reason beside each bound: beyond them a number is
suspicious. Without a mesh there is only the reach of a link, from joint to joint, and the words are
weaker.
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
    """What is odd about an arm's numbers, link by link, then about the whole arm.

    meshes : the links' shapes (default: those that the arm's URDF names, see `link_meshes`)

    Nothing found is an empty tuple.  Findings are no failures: a vendor may have reasons.
    """
    arm = as_arm(arm)
    if meshes is not None:
        instance("meshes", meshes, Meshes, "leave it out to use those that the URDF names")
    shown = link_meshes(arm) if meshes is None else meshes
    findings = [
        Plausibility("note", None, arm.name, "mesh", None, None, "", f"Not held against: {note}.")
        for note in shown.notes
    ]
    for number, (link, shapes) in enumerate(zip(arm.links, shown.links, strict=True), 1):
        own = body_findings(number, link)
        findings += own
        if link.inertia.mass <= 0.0:
            continue  # said above, and nothing below has a meaning for it
        if shapes:
            findings += extent_findings(number, link, shapes)
        else:
            findings += reach_findings(number, link)
    return (*findings, *whole_findings(arm))
