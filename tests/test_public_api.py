"""The public API: what it holds, what it accepts as an arm, and what it does with bad arguments."""

from __future__ import annotations

import inspect
import json
import re
from importlib import import_module

import numpy as np
import pytest

import ur5check
from repository import REPOSITORY
from ur5check import Ur5checkError, results, testing

ARM = ur5check.load("paper")
ROBOT = ur5check.load_robot("paper")
Q = np.zeros((3, 6))
STATES = ur5check.random_states(6, 3, seed=0)
PAIR = ur5check.pair_up("paper", "appendix")
GAINS = ur5check.Gains.placed(6, (-8.0, -10.0, -12.0))
KERNEL = ur5check.compile(ARM, path="numpy")

NOT_ARMS = {
    "none": None,
    "number": 3,
    "unknown name": "pepper",
    "absent file": "absent.urdf",
    "directory": "/",
    "nul": "a\0.urdf",
    "list": [ARM],
}
NOT_JOINTS = {
    "none": None,
    "text": "zero",
    "words": ["0"] * 6,
    "short": np.zeros(5),
    "scalar": 0.0,
    "nan": np.full(6, np.nan),
    "inf": np.full(6, np.inf),
    "masked": np.ma.masked_equal(np.zeros(6), 0.0),
    "objects": np.array([None] * 6),
    "bools": np.zeros(6, dtype=bool),
    "ragged": [[0.0] * 6, [0.0] * 5],
    "nested": [0.0, 0.0, 0.0, 0.0, 0.0, [0.0]],
}
NOT_GRAVITY = {"text": "down", "short": (0, 0), "nan": (0, 0, np.nan), "words": ["0", "0", "-9"]}
NOT_COUNTS = {"none": None, "text": "ten", "zero": 0, "negative": -1, "float": 1.5, "bool": True}
NOT_SEEDS = {"none": None, "text": "s", "negative": -1, "float": 0.5, "bool": True}
NOT_NUMBERS = {"none": None, "text": "1", "nan": np.nan, "negative": -1.0, "bool": True}
NOT_OBJECTS = {"none": None, "text": "x", "number": 1}

#: Function, good arguments by name, and which kinds of bad values stand for which argument.
CALLS = [
    (ur5check.load, {"x": ARM}, {"x": NOT_ARMS, "base": {"number": 3}, "packages": {"list": [1]}}),
    (
        ur5check.load_robot,
        {"model": "paper"},
        {
            "model": {**NOT_ARMS, "arm": ARM},
            "packages": {"list": [1]},
            "arguments": {"number": 3},
        },
    ),
    (
        ur5check.compare_recording,
        {"model": ARM, "files": "run.csv"},
        {
            "model": NOT_ARMS,
            "files": {"number": 3, "list": [1], "nothing": [], "no such file": "none.csv"},
            "options": NOT_OBJECTS,
            "friction": NOT_OBJECTS,
        },
    ),
    (ur5check.RobotTree.of, {"robot": ROBOT}, {"robot": {**NOT_OBJECTS, "arm": ARM}}),
    (
        ur5check.forward_kinematics,
        {"arm": ur5check.RobotTree.of(ROBOT), "q": Q, "link": "link 6"},
        {"q": NOT_JOINTS, "link": {**NOT_OBJECTS, "list": ["link 6"]}},
    ),
    *(
        (
            getattr(ur5check, name),
            {"arm": ARM, **dict.fromkeys(joints, Q)},
            {"arm": NOT_ARMS, **dict.fromkeys(joints, NOT_JOINTS), **gravity},
        )
        for name, joints, gravity in (
            ("rnea", ("q", "qd", "qdd"), {"gravity": NOT_GRAVITY}),
            ("torque_regressor", ("q", "qd", "qdd"), {"gravity": NOT_GRAVITY}),
            ("mass_matrix", ("q",), {}),
            ("coriolis_matrix", ("q", "qd"), {}),
            ("gravity_torque", ("q",), {"gravity": NOT_GRAVITY}),
            ("forward_dynamics", ("q", "qd", "tau"), {"gravity": NOT_GRAVITY}),
            ("kinetic_energy", ("q", "qd"), {}),
            ("potential_energy", ("q",), {"gravity": NOT_GRAVITY}),
            ("forward_kinematics", ("q",), {}),
            ("link_frames", ("q",), {}),
        )
    ),
    (
        ur5check.random_states,
        {"n": 6, "count": 3, "seed": 0},
        {"n": NOT_COUNTS, "count": NOT_COUNTS, "seed": NOT_SEEDS},
    ),
    (
        ur5check.diff,
        {"a": ARM, "b": ARM, "samples": 3},
        {"a": NOT_ARMS, "b": NOT_ARMS, "samples": NOT_COUNTS, "seed": NOT_SEEDS}
        | {"gravity": NOT_GRAVITY},
    ),
    (ur5check.explain, {"difference": None}, {"difference": NOT_OBJECTS}),
    (
        ur5check.judge,
        {"model": "paper", "samples": 3},
        {"model": {"none": None, "number": 3, "unknown": "papre", "folder": "/"}}
        | {"samples": NOT_COUNTS, "seed": NOT_SEEDS, "payload": NOT_NUMBERS}
        | {"hold": {"text": "x", "unknown": {"nowhere": 1.0}}, "packages": {"text": "x"}},
    ),
    (
        ur5check.validate,
        {},
        {"samples": NOT_COUNTS, "seed": NOT_SEEDS, "gravity": NOT_GRAVITY, "progress": {"n": 3}},
    ),
    (
        ur5check.compare_engines,
        {"engines": ["pinocchio"], "samples": 3},
        {"model": NOT_ARMS, "engines": {"text": "dart", "number": 3, "unknown": ["bullet"]}}
        | {"samples": NOT_COUNTS, "seed": NOT_SEEDS, "progress": {"text": "x"}},
    ),
    (ur5check.compare_fleet, {}, {"arms": {"text": "ur5", "empty": [], "names": ["ur5"]}}),
    (
        ur5check.sweep,
        {"a": ARM, "b": ARM, "states": 10},
        {"a": NOT_ARMS, "b": NOT_ARMS, "threads": NOT_COUNTS, "seed": NOT_SEEDS}
        | {"states": {k: v for k, v in NOT_COUNTS.items() if k != "none"}}
        | {"sample": {"number": 3, "unknown": "halton"}, "tolerance": {"text": "x", "nan": np.nan}}
        | {"checkpoint": {"number": 3}, "scheduler": {"number": 3}, "progress": {"text": "x"}},
    ),
    (ur5check.pair_up, {"a": ARM, "b": ARM}, {"a": NOT_ARMS, "b": NOT_ARMS}),
    *(
        (function, {"pair": PAIR, "states": STATES}, {"pair": NOT_OBJECTS, "states": NOT_OBJECTS})
        for function in (
            ur5check.attribute,
            ur5check.attribute_by_parameter,
            ur5check.attribute_by_term,
            ur5check.diagnose,
            ur5check.error_budget,
            ur5check.equivalence,
        )
    ),
    (
        ur5check.worst_cases,
        {"pair": PAIR},
        {"pair": NOT_OBJECTS, "seed": NOT_SEEDS}
        | {"starts": {k: v for k, v in NOT_COUNTS.items() if k != "none"}}
        | {"acceleration": NOT_NUMBERS},
    ),
    (ur5check.identify, {"arm": ARM}, {"arm": NOT_ARMS, "seed": NOT_SEEDS, "frame": {"x": "x"}}),
    (ur5check.plausibility, {"arm": ARM}, {"arm": NOT_ARMS, "meshes": {"text": "x"}}),
    (ur5check.derive, {"arm": ARM, "quantity": "g"}, {"arm": NOT_ARMS, "quantity": NOT_OBJECTS}),
    (ur5check.trace, {"arm": ARM, "quantity": "g"}, {"arm": NOT_ARMS, "quantity": NOT_OBJECTS}),
    (ur5check.to_python, {}, {"program": NOT_OBJECTS}),
    (ur5check.sympy_matrix, {}, {"program": NOT_OBJECTS}),
    (ur5check.compile, {"arm": ARM}, {"arm": NOT_ARMS, "threads": NOT_COUNTS, "path": {"c": "c"}}),
    (ur5check.compile_difference, {"a": ARM, "b": ARM}, {"a": NOT_ARMS, "b": NOT_ARMS}),
    (ur5check.jax_rnea, {}, {"arm": NOT_ARMS}),
    (
        ur5check.make_engine,
        {"key": "pinocchio", "arm": ARM},
        {"key": {"none": None, "unknown": "bullet", "list": []}, "arm": NOT_ARMS}
        | {"gravity": NOT_GRAVITY},
    ),
    (ur5check.repaired_text, {"urdf": "<robot/>", "key": "dart"}, {"urdf": NOT_ARMS}),
    (
        ur5check.static_hold,
        {"plant": ARM, "model": ARM, "q": np.zeros(6), "seconds": 0.01},
        {"plant": NOT_ARMS, "model": NOT_ARMS, "q": NOT_JOINTS, "seconds": NOT_NUMBERS}
        | {"dt": NOT_NUMBERS, "engine": {"none": None, "unknown": "bullet"}},
    ),
    (
        ur5check.convergence,
        {"arm": ARM, "q": np.zeros(6), "tau": np.zeros(6)},
        {"arm": NOT_ARMS, "q": NOT_JOINTS, "tau": NOT_JOINTS, "seconds": NOT_NUMBERS},
    ),
    (ur5check.track, {"controller": None, "plant": None, "trajectory": None}, {"plant": {"x": 1}}),
    (
        ur5check.Gains,
        {"kp": np.eye(2), "ki": np.eye(2), "kd": np.eye(2)},
        {"kp": NOT_OBJECTS, "kd": {"nan": np.full((2, 2), np.nan), "short": np.eye(3)}},
    ),
    (
        ur5check.Quintic,
        {"start": np.zeros(6), "goal": np.ones(6), "duration": 1.0},
        {"start": NOT_JOINTS, "goal": NOT_JOINTS, "duration": NOT_NUMBERS},
    ),
    (ur5check.ComputedTorque, {"model": None, "gains": GAINS}, {"model": NOT_OBJECTS}),
    (ur5check.effort_limits, {"arm": ARM}, {"arm": NOT_ARMS}),
    (ur5check.poles, {"gains": GAINS}, {"gains": NOT_OBJECTS, "law": NOT_OBJECTS}),
    (ur5check.paper_case, {}, {"number": NOT_COUNTS | {"ten": 10}}),
    (ur5check.draw_case, {"r": None, "number": 1}, {"r": NOT_OBJECTS}),
    (ur5check.draw_overview, {}, {"r": NOT_OBJECTS}),
    (ur5check.reproduce, {}, {"progress": {"text": "x"}}),
    (ur5check.contribution_in_words, {}, {"contribution": NOT_OBJECTS}),
    (ur5check.equivalence_in_words, {}, {"equivalence": NOT_OBJECTS}),
    (ur5check.rounding_in_words, {}, {"item": NOT_OBJECTS}),
    (ur5check.mistake_advice, {}, {"found": NOT_OBJECTS}),
    (ur5check.mistake_details, {}, {"found": NOT_OBJECTS}),
    (ur5check.mistake_sentence, {"pair": PAIR}, {"found": NOT_OBJECTS}),
    (ur5check.mismatch_sentence, {"diagnosis": None}, {"mismatch": NOT_OBJECTS}),
    (ur5check.Transform, {"R": np.eye(3), "p": np.zeros(3)}, {"R": NOT_JOINTS, "p": NOT_JOINTS}),
    (
        ur5check.Inertia,
        {"mass": 1.0, "com": np.zeros(3), "tensor": np.eye(3)},
        {"mass": NOT_JOINTS | {"words": "1"}, "com": NOT_JOINTS, "tensor": NOT_JOINTS},
    ),
    (ur5check.Joint, {"name": "j", "axis": (0, 0, 1)}, {"name": {"n": 3}, "axis": NOT_JOINTS}),
    (
        ur5check.SerialArm,
        {"name": "a", "joints": ARM.joints, "links": ARM.links},
        {"name": {"none": None}, "joints": NOT_OBJECTS | {"none of them": ()}}
        | {"links": NOT_OBJECTS, "gravity": NOT_GRAVITY},
    ),
    (
        ur5check.States,
        {"q": Q, "qd": Q, "qdd": Q},
        {"q": {k: v for k, v in NOT_JOINTS.items() if k not in ("nan", "inf")}},
    ),
    *(
        (
            getattr(KERNEL, name),
            dict.fromkeys(joints, Q),
            {**dict.fromkeys(joints, NOT_JOINTS), "out": {"text": "x", "short": np.zeros(2)}},
        )
        for name, joints in (
            ("rnea", ("q", "qd", "qdd")),
            ("mass_matrix", ("q",)),
            ("gravity_torque", ("q",)),
        )
    ),
]

BAD = [
    pytest.param(function, good | {argument: value}, id=f"{function.__name__}-{argument}-{kind}")
    for function, good, arguments in CALLS
    for argument, values in arguments.items()  # type: ignore[attr-defined]
    for kind, value in values.items()
    if not (argument == "mass" and kind == "scalar")
]


@pytest.mark.parametrize(("function", "arguments"), BAD)
def test_a_bad_argument_raises_an_error_that_says_what_to_do(function, arguments):
    with pytest.raises(Ur5checkError) as caught:
        function(**arguments)
    assert len(str(caught.value)) > 20


def test_every_public_function_is_in_the_table():
    tried = {function for function, _, _ in CALLS}
    functions = {
        name
        for name in ur5check.__all__
        if inspect.isfunction(getattr(ur5check, name)) and getattr(ur5check, name) not in tried
    }
    assert functions == {"installed_engines", "steppers", "known_issues_of"}  # nothing to refuse


@pytest.mark.parametrize("layout", ["states", "joints"])
def test_out_must_not_overlap_an_input(layout):
    q = np.zeros((6, 6))
    with pytest.raises(Ur5checkError, match="overlaps q"):
        KERNEL.gravity_torque(q, layout=layout, out=q)


@pytest.mark.parametrize("name", ["rnea", "torque_regressor"])
def test_a_name_and_a_path_are_as_good_as_an_arm(name):
    function, rest = getattr(ur5check, name), np.zeros(6)
    path = REPOSITORY / "models" / "paper.toml"
    wanted = function(ARM, rest, rest, rest)
    for arm in ("paper", path, str(path)):
        np.testing.assert_array_equal(function(arm, rest, rest, rest), wanted)


RESULTS = [
    ur5check.diff("paper", "appendix", samples=20),
    ur5check.validate("paper", samples=5),
    ur5check.sweep("paper", "appendix", states=100),
    ur5check.compare_engines("paper", engines=["pinocchio"], samples=5),
]


@pytest.mark.parametrize("result", RESULTS, ids=lambda result: type(result).__name__)
def test_a_result_shows_itself(result):
    assert isinstance(result, results.Result)
    assert repr(result) == f"<{type(result).__name__}: {result.verdict}>"
    assert result.summary().splitlines()[0] == result.verdict
    assert max(map(len, result.to_text(width=80).splitlines())) <= 80
    assert json.loads(result.to_json())["schema"].startswith("ur5check.")
    html = result._repr_html_()
    assert html.count("<table>") == html.count("</table>") > 0
    with pytest.raises(Ur5checkError, match="width"):
        result.to_text(width=10)


def test_html_escapes_what_a_file_says():
    from dataclasses import replace

    arm = replace(ARM, name="<script>")
    html = ur5check.diff(arm, "appendix", samples=5)._repr_html_()
    assert "<script>" not in html
    assert "&lt;script&gt;" in html


def test_names_of_the_public_modules_are_there():
    for module in (results, testing, import_module("ur5check.strategies")):
        assert set(module.__all__) <= set(vars(module))


PAGES = [
    REPOSITORY / "README.md",
    *sorted((REPOSITORY / "docs").glob("*.md")),
    *sorted((REPOSITORY / "notebooks").glob("*.ipynb")),
]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_documentation_uses_the_public_api_only(page):
    private = re.compile(r"(?:from|import) +ur5check\._|\bur5check\._\w+\.\w+\(")
    assert not private.search(page.read_text(encoding="utf-8"))
