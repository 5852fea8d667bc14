"""Generated C is C99 without a warning, and computes what the recursion does."""

from __future__ import annotations

import ctypes
import subprocess
from math import prod

import numpy as np
import pytest
from references import RECURSION, arguments, states

import ur5check
from examples import random_arm
from ur5check._dynamics.symbolic.to_c import to_c
from ur5check._dynamics.symbolic.trace import trace

STRICT = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wno-unused-variable", "-Werror"]


def compiled(source, folder):
    (folder / "form.c").write_text(source, encoding="utf-8")
    command = ["gcc", *STRICT, "-shared", "-fPIC", "-o", "form.so", "form.c", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(folder / "form.so"))


def run(library, program, given):
    """The compiled function at each state, through plain C arrays."""
    function, defaults = getattr(library, program.quantity), []
    if program.parameters:
        values = ctypes.c_double * len(program.parameters)
        defaults.append(ctypes.byref(values.in_dll(library, f"{program.quantity}_defaults")))
    results = []
    for state in zip(*given, strict=True):
        result = (ctypes.c_double * prod(program.shape))()
        function(*((ctypes.c_double * program.n)(*x) for x in state), *defaults, result)
        results.append(np.array(result).reshape(program.shape))
    return np.array(results)


@pytest.mark.parametrize("quantity", ["tau", "M", "C", "g"])
@pytest.mark.parametrize("parameters", ["numeric", "symbolic"])
def test_compiled_c_computes_the_quantity(quantity, parameters, tmp_path):
    arm = ur5check.load("paper")
    program = trace(arm, quantity, parameters=parameters, tries=0)
    given = arguments(program, states(arm, 1000))
    result = run(compiled(to_c(program), tmp_path), program, given)
    np.testing.assert_allclose(result, RECURSION[quantity](arm, *given), atol=1e-11, rtol=0)


def test_a_sliding_joint_too(tmp_path):
    arm = random_arm(4, seed=3)
    assert "prismatic" in {joint.kind for joint in arm.joints}
    program = trace(arm, regroup=False)
    given = arguments(program, states(arm, 20))
    result = run(compiled(to_c(program), tmp_path), program, given)
    np.testing.assert_allclose(result, ur5check.rnea(arm, *given), rtol=1e-11)


def test_a_wrong_file_is_refused(tmp_path):
    with pytest.raises(AssertionError, match="error"):
        compiled(
            to_c(trace(ur5check.load("paper"), "g", tries=0)).replace("double", "duble"), tmp_path
        )
