"""Every public docstring is numpydoc: it documents what the object has, and its examples run."""

from __future__ import annotations

import dataclasses
import doctest
import functools
import inspect
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import pytest
from numpydoc.docscrape import NumpyDocString

import ur5check

MODULES = ("ur5check", "ur5check.results", "ur5check.strategies", "ur5check.testing")

#: A member's name in its module, and the member.
Named = tuple[str, Any]


def public_objects() -> Iterator[Named]:
    """Classes and functions that the public modules export, each once."""
    seen = set()
    for module in map(import_module, MODULES):
        for name in module.__all__:
            value = getattr(module, name)
            if callable(value) and id(value) not in seen:
                seen.add(id(value))
                yield f"{module.__name__}.{name}", value


def public_members(name: str, owner: type) -> Iterator[Named]:
    """Methods and properties of a class, without those that it inherits."""
    for member, value in vars(owner).items():
        if member.startswith("_") and member != "__call__":
            continue
        plain = value.__func__ if isinstance(value, classmethod | staticmethod) else value
        if inspect.isfunction(plain) or hasattr(plain, "fget") or hasattr(plain, "attrname"):
            yield f"{name}.{member}", plain


OBJECTS = dict(public_objects())
FUNCTIONS = {n: value for n, value in OBJECTS.items() if not inspect.isclass(value)}
CLASSES = {n: value for n, value in OBJECTS.items() if inspect.isclass(value)}
MEMBERS = dict(member for name, owner in CLASSES.items() for member in public_members(name, owner))
METHODS = {n: value for n, value in MEMBERS.items() if inspect.isfunction(value)}
PROPERTIES = {n: value for n, value in MEMBERS.items() if not inspect.isfunction(value)}


def docstring(value: Any) -> NumpyDocString:
    return NumpyDocString(inspect.getdoc(value) or "")


def documented(doc: Any, section: str) -> list[str]:
    """The names of a section, "q, qd" as two."""
    return [name.lstrip("*") for entry in doc[section] for name in entry.name.split(", ")]


def arguments(function: Callable[..., Any]) -> list[str]:
    names = list(inspect.signature(function).parameters)
    return names[1:] if names[:1] in (["self"], ["cls"]) else names


def faults_of_function(function: Callable[..., Any]) -> list[str]:
    """What numpydoc and this project ask of a public function or method."""
    doc = docstring(function)
    faults = [] if doc["Summary"] else ["no summary"]
    names = arguments(function)
    if sorted(documented(doc, "Parameters")) != sorted(names):
        faults.append(f"documents {documented(doc, 'Parameters')}, takes {names}")
    returned = inspect.signature(function).return_annotation
    if returned not in (None, "None") and not (doc["Returns"] or doc["Yields"]):
        faults.append("no Returns")
    faults += [f"{p.name} has neither type nor text" for p in doc["Parameters"] if not p.type]
    return faults


def faults_of_public_function(function: Callable[..., Any]) -> list[str]:
    """A function of a module also says what it raises, and shows an example."""
    doc = docstring(function)
    faults = faults_of_function(function)
    if arguments(function) and function not in NEVER_RAISE and not doc["Raises"]:
        faults.append("no Raises")
    if not doc["Examples"]:
        faults.append("no Examples")
    return faults


def faults_of_class(owner: type) -> list[str]:
    """A class documents every field, as what it is made from or as what it holds."""
    doc = docstring(owner)
    faults = [] if doc["Summary"] else ["no summary"]
    fields = dataclasses.fields(owner) if dataclasses.is_dataclass(owner) else ()
    held = documented(doc, "Parameters") + documented(doc, "Attributes")
    wanted = [field.name for field in fields]
    if fields and sorted(held) != sorted(wanted):
        faults.append(f"documents {held}, holds {wanted}")
    return faults


def failed_examples(name: str, value: Any) -> int:
    """Examples of a docstring that do not print what they say."""
    runner = doctest.DocTestRunner(verbose=False)
    for test in doctest.DocTestFinder(recurse=False).find(value, name, module=False, globs={}):
        runner.run(test)
    return runner.summarize(verbose=False).failed


#: They take any key, and know nothing of those that do not exist.
NEVER_RAISE = {OBJECTS["ur5check.known_issues_of"]}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_says_what_it_takes_returns_and_raises(name: str) -> None:
    assert faults_of_public_function(FUNCTIONS[name]) == []


@pytest.mark.parametrize("name", CLASSES)
def test_a_class_documents_its_fields(name: str) -> None:
    assert faults_of_class(CLASSES[name]) == []


@pytest.mark.parametrize("name", METHODS)
def test_a_method_says_what_it_takes_and_returns(name: str) -> None:
    assert faults_of_function(METHODS[name]) == []


@pytest.mark.parametrize("name", PROPERTIES)
def test_a_property_has_a_summary_of_one_line(name: str) -> None:
    text = inspect.getdoc(PROPERTIES[name]) or ""
    assert len(text.splitlines()[:1]) == 1
    assert text.splitlines()[0].endswith((".", "]")), text


@pytest.fixture(autouse=True, scope="module")
def _reproduced_once() -> Iterator[None]:
    """`reproduce` takes seconds, and three examples call it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ur5check, "reproduce", functools.cache(ur5check.reproduce))
        yield


@pytest.mark.parametrize("name", [*OBJECTS, *MEMBERS])
def test_examples_print_what_they_say(name: str) -> None:
    assert failed_examples(name, OBJECTS.get(name) or MEMBERS[name]) == 0


def test_values_that_users_make_have_an_example() -> None:
    made = {name for name, owner in CLASSES.items() if docstring(owner)["Parameters"]}
    assert {name for name in made if not docstring(OBJECTS[name])["Examples"]} == set()


def good(q: float) -> float:
    """Twice q.

    Parameters
    ----------
    q : float
        [rad]

    Returns
    -------
    float

    Raises
    ------
    ValueError
        Never.

    Examples
    --------
    >>> 2 * 3
    6
    """
    return 2 * q


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("q : float", "qd : float"),
        ("q : float", "q"),
        ("Returns\n    -------\n    float", ""),
        ("Raises\n    ------\n    ValueError\n        Never.", ""),
        ("Examples\n    --------\n    >>> 2 * 3\n    6", ""),
    ],
)
def test_a_bad_docstring_is_refused(wrong: str, right: str) -> None:
    def bad(q: float) -> float:
        return 2 * q

    assert good.__doc__ is not None
    bad.__doc__ = good.__doc__.replace(wrong, right)
    assert bad.__doc__ != good.__doc__
    assert faults_of_public_function(good) == []
    assert faults_of_public_function(bad) != []


def test_a_field_without_text_and_a_wrong_example_are_refused() -> None:
    @dataclasses.dataclass
    class Pose:
        """A pose.

        Attributes
        ----------
        x : float
            [m]

        >>> 1 + 1
        3
        """

        x: float
        y: float

    assert faults_of_class(Pose) != []
    assert failed_examples("Pose", Pose) == 1
