"""Every error that ur5check raises on purpose, as one tree.

    Ur5checkError
    ├── InputError            something the user gave is wrong                 exit code 2
    │   ├── ModelError        a model file or value: file, line, element, value
    │   ├── StateError        q, qd, qdd or tau: shape, number, length
    │   └── UsageError        an option, a name, a combination that has no meaning
    └── EngineError           a reference engine is absent, or could not take the model  exit code 2

An error says what is wrong *and* what to do.  `ModelError` keeps its parts as fields, so that a
report can print them one by one and a test can look at one of them.
"""

from __future__ import annotations

from ._finding import Finding, Place

__all__ = ["EngineError", "InputError", "ModelError", "StateError", "Ur5checkError", "UsageError"]


class Ur5checkError(Exception):
    """Base of all errors raised on purpose; `docs/api.md` lists them."""


class InputError(Ur5checkError):
    """Something that the user gave is wrong."""


class ModelError(InputError):
    """A description of an arm cannot be taken as it stands.

    Parameters
    ----------
    problem : str
        What is wrong, as a clause ("mass is negative").
    fix : str
        What to do about it, as an imperative ("give the mass in kilograms").
    file : str or None
        Where it is written, when it is written in a file.
    line : int or None
        From 1.
    element : str or None
        The element, key or body that holds it ("link 'forearm' inertial/mass").
    value : object
        The offending value, as it was written.
    rule : str
        Id of the rule that was broken.

    Examples
    --------
    >>> import ur5check
    >>> try:
    ...     ur5check.Joint("elbow", (0, 0, 0))
    ... except ur5check.ModelError as error:
    ...     error.element, error.fix
    ("joint 'elbow'", 'give its direction')
    """

    #: The rule of what has no rule of its own.
    UNSPECIFIED = "XML100"

    def __init__(
        self,
        problem: str,
        *,
        fix: str,
        file: str | None = None,
        line: int | None = None,
        element: str | None = None,
        value: object = None,
        rule: str = UNSPECIFIED,
    ) -> None:
        self.problem = problem
        self.fix = fix
        self.file = file
        self.line = line
        self.element = element
        self.value = value
        self.rule = rule
        super().__init__(self._sentence())

    @classmethod
    def of(cls, finding: Finding) -> ModelError:
        """A finding as an error, at its first place; its message holds the value already.

        Parameters
        ----------
        finding : Finding

        Returns
        -------
        ModelError
        """
        place = finding.place
        error = cls(
            finding.message,
            fix=finding.fix,
            file=place.file or None,
            line=place.line or None,
            element=place.element or (finding.subject if finding.subject != "file" else None),
            rule=finding.rule,
        )
        error.value = finding.value
        return error

    @property
    def finding(self) -> Finding:
        """The same as a finding, for reports that list several."""
        return Finding(
            rule=self.rule,
            severity="error",
            subject=self.element or "file",
            message=self.problem,
            places=(Place(self.file or "", self.line or 0, 0, self.element or ""),),
            value=None if self.value is None else _shortened(self.value),
            consequence="the file cannot be read as it stands",
            fix=self.fix,
        )

    def _sentence(self) -> str:
        place = self.file or ""
        if self.line is not None:
            place += f":{self.line}"
        parts = [part for part in (place, self.element) if part]
        shown = "" if self.value is None else f" (got {_shortened(self.value)})"
        return ": ".join([*parts, f"{self.problem}{shown}; {self.fix}"])


class StateError(InputError):
    """A joint state or torque has the wrong length, shape or content."""


class UsageError(InputError):
    """An option, a name or a combination of them has no meaning."""


class EngineError(Ur5checkError):
    """A reference engine is not installed, or could not take the model it was given."""


def _shortened(value: object, limit: int = 80) -> str:
    text = repr(value)
    return text if len(text) <= limit else text[: limit - 1] + "…"
