"""`ur5check derive`: what it prints, writes and refuses."""

from __future__ import annotations

import re

import numpy as np
import pytest
from references import states

import ur5check
from report_schema import read_report
from ur5check._cli.main import main

G = ("derive", "paper", "--quantity", "g")


@pytest.fixture
def say(capsys):
    """`say(*arguments)`: exit code, stdout, stderr."""

    def run(*arguments: object) -> tuple[int, str, str]:
        code = main([str(argument) for argument in arguments])
        return code, *capsys.readouterr()

    return run


def test_code_on_stdout_counts_and_time_on_stderr(say):
    code, out, err = say(*G)
    assert code == 0
    module = {}
    exec(out, module)  # noqa: S102 - what we generated
    arm = ur5check.load("paper")
    q = states(arm, 10).q
    np.testing.assert_allclose(module["g"](q), ur5check.gravity_torque(arm, q), atol=1e-11)
    counts = [int(total) for total in re.findall(r"(\d+) in all", err)]
    assert counts == sorted(counts, reverse=True)
    assert len(counts) == 3
    assert re.search(r"derived in \d+\.\d s", err)
    assert say(*G, "--parameters", "symbolic", "--quiet")[2] == ""


@pytest.mark.parametrize(
    ("target", "mark"), [("python", "#"), ("c", "//"), ("sympy", "#"), ("latex", "%")]
)
def test_the_text_says_where_it_comes_from(say, tmp_path, target, mark):
    file = tmp_path / "g.txt"
    assert say(*G, "--to", target, "-o", file, "--quiet") == (0, "", "")
    head = [line for line in file.read_text(encoding="utf-8").splitlines() if line.startswith(mark)]
    said = "\n".join(head)
    assert f"{mark} Command: ur5check derive paper --quantity g --to {target}" in said
    ((name, digest),) = ur5check.load("paper").source.inputs
    assert f"from {name}, SHA-256 {digest}" in said
    assert f"ur5check {ur5check.__version__}, python" in said
    assert "constants folded, gravity as base acceleration, factored" in said


def test_json_is_a_program(say):
    code, out, _ = say(*G, "--to", "json", "--parameters", "symbolic")
    report = read_report(out)
    assert code == 0
    assert report["operations"] == report["stages"][-1]["operations"]
    assert report["parameters"]["m2"] == 8.393
    # Run it as a stranger would, from the page's words alone.
    q = states(ur5check.load("paper"), 1).q[0]
    values = dict(report["parameters"])
    values |= {f"c{i}": np.cos(x) for i, x in enumerate(q, 1)}
    values |= {f"s{i}": np.sin(x) for i, x in enumerate(q, 1)}
    for line in (*report["setup"], *report["assignments"], *report["outputs"]):
        terms = (t["k"] * np.prod([values[f] for f in t["factors"]]) for t in line["terms"])
        values[line["name"]] = sum(terms)
    g = [values[line["name"]] for line in report["outputs"]]
    np.testing.assert_allclose(g, ur5check.gravity_torque(ur5check.load("paper"), q), atol=1e-11)


def test_what_has_no_meaning_is_refused(say, tmp_path):
    for wrong in (("--quantity", "energy"), ("--to", "fortran"), ("--parameters", "some")):
        code, out, err = say("derive", "paper", *wrong)
        assert (code, out) == (2, "")
        assert "see `ur5check derive --help`" in err
    missing = tmp_path / "no" / "tau.c"
    code, _, err = say(*G, "-o", missing)
    assert code == 2
    assert "there is no folder" in err
    assert not missing.exists()
