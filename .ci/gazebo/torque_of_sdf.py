"""Does Gazebo's reading of a URDF weigh what ours does?

    torque_of_sdf.py MODEL FILE.sdf [TOLERANCE]

FILE.sdf is what libsdformat made of the exported URDF: the way that Gazebo takes.  Drake reads it,
with a libsdformat of its own, and its gravity torques are held against ur5check's for MODEL.
"""

from __future__ import annotations

import logging
import sys
from pathlib import Path

import numpy as np
from lxml import etree
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant

import ur5check

STATES = 200
# [N m]: a lever summed over seven bodies; libsdformat prints every number in 16 digits.
TOLERANCE = 1e-11


def main(model: str, file: str, tolerance: str = str(TOLERANCE)) -> None:
    """Print the largest difference [N m]; leave with 1 if it is too large."""
    logging.getLogger("drake").setLevel(logging.ERROR)  # that Drake knows no self_collide
    arm = ur5check.load(model)
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(without_shapes(Path(file)), "sdf")
    plant.mutable_gravity_field().set_gravity_vector(arm.gravity)
    plant.Finalize()
    if plant.num_positions() != arm.n:
        raise SystemExit(f"{file}: {plant.num_positions()} coordinates, the arm has {arm.n}")
    places = [plant.GetJointByName(name).position_start() for name in arm.joint_names]
    context = plant.CreateDefaultContext()
    worst = 0.0
    for q in np.random.default_rng(0).uniform(-np.pi, np.pi, (STATES, arm.n)):
        theirs = np.zeros(arm.n)
        theirs[places] = q
        plant.SetPositions(context, theirs)
        tau = -plant.CalcGravityGeneralizedForces(context)[places]
        worst = max(worst, float(np.abs(tau - ur5check.gravity_torque(arm, q)).max()))
    sys.stdout.write(f"{file}: gravity torques of {model} differ by at most {worst:.1e} N m\n")
    if worst > float(tolerance):
        raise SystemExit(f"{file}: weighs something else than {model}")


def without_shapes(file: Path) -> str:
    """The model without meshes, which nobody has installed here."""
    root = etree.parse(file).getroot()
    for shape in [*root.iter("visual"), *root.iter("collision")]:
        shape.getparent().remove(shape)
    return etree.tostring(root, encoding="unicode")


if __name__ == "__main__":
    main(*sys.argv[1:])
