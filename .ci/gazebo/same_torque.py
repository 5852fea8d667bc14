"""Are the torques that were heard those of `ur5check.gravity_torque`?

    same_torque.py MODEL POSE HEARD

POSE and HEARD are JSON lists.  A float64 message loses nothing, so they must be equal.
"""

from __future__ import annotations

import json
import sys

import ur5check

model, pose, heard = sys.argv[1:]
expected = [float(t) for t in ur5check.gravity_torque(ur5check.load(model), json.loads(pose))]
largest = max(abs(t) for t in expected)
astray = max(abs(a - b) for a, b in zip(json.loads(heard), expected, strict=True))
# The exported URDF prints every number so that it reads back as itself.
if astray > 1e-14 * largest:
    raise SystemExit(f"heard {heard}, ur5check computes {expected}")
sys.stdout.write(f"the torque that was heard is ur5check's, to {astray:.0e} N m\n")
