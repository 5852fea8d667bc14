"""Reading one table of a DH file: its keys, numbers, angles, vectors; each fault a `ModelError`."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping
from typing import Any, NoReturn

from ..._errors import ModelError
from ..printed_numbers import Printed
from ..suggestions import did_you_mean
from .toml_lines import line_of

__all__ = ["Table"]

# Longer than any arm: a greater length was meant in millimetres [m].
_LONGEST = 20.0

_PI = re.compile(r"([+-]?)\s*(?:(\d+(?:\.\d+)?)\s*\*\s*)?pi(?:\s*/\s*(\d+(?:\.\d+)?))?", re.ASCII)


class Table:
    """A TOML table, and its place for error messages.

    row : which [[joint]], from 0; None for the top of the file
    """

    def __init__(
        self,
        values: Mapping[str, Any],
        *,
        file: str,
        text: str,
        name: str = "",
        row: int | None = None,
        key: str | None = None,
    ) -> None:
        self.values = values
        self.name = name
        self.file, self._text, self._row, self._key = file, text, row, key

    def fail(
        self,
        key: str | None,
        problem: str,
        fix: str,
        value: object = None,
        rule: str = "XML100",
    ) -> NoReturn:
        raise ModelError(
            problem,
            fix=fix,
            file=self.file,
            line=self.line(key),
            element=" ".join(part for part in (self.name, key) if part) or None,
            value=value,
            rule=rule,
        )

    def line(self, key: str | None) -> int | None:
        return line_of(self._text, self._row, self._key or key)

    def refuse_unknown_keys(self, known: Collection[str]) -> None:
        for key in self.values:
            self.refuse_unknown_key(key, known)

    def refuse_unknown_key(self, key: str, known: Collection[str]) -> None:
        if key not in known:
            self.fail(key, "is no key of this format", did_you_mean(key, known))

    def require(self, *keys: str) -> None:
        for key in keys:
            if key not in self.values:
                self.fail(key, "is missing", f"write {key} = …", rule="XML104")

    def _given(self, key: str) -> Any:
        self.require(key)
        return self.values[key]

    def text(self, key: str, *, choices: Collection[str] | None = None) -> str:
        value = self._given(key)
        if not isinstance(value, str) or not value.strip():
            self.fail(key, "is not a text", f'write {key} = "…"', value)
        if choices is not None and value not in choices:
            self.fail(key, "is not one of the choices", did_you_mean(value, choices), value)
        return value

    def number(self, key: str) -> float:
        return self._number(key, self._given(key))

    def length(self, key: str) -> float:
        """[m]"""
        return self._length(key, self.number(key))

    def angle(self, key: str) -> float:
        """[rad], from a number or from a text such as "-3*pi/4"."""
        value = self._given(key)
        if isinstance(value, str):
            match = _PI.fullmatch(value.strip())
            if match is None or (match[3] is not None and float(match[3]) == 0.0):
                fix = 'write a number in radians, or a fraction of pi such as "-3*pi/4"'
                self.fail(key, "is no angle", fix, value)
            angle = float(match[2] or 1) * math.pi / float(match[3] or 1)
            angle = -angle if match[1] == "-" else angle
        else:
            angle = self.number(key)
        if abs(angle) > 2 * math.pi:
            problem = "is beyond a full turn: it looks like degrees"
            self.fail(key, problem, "write radians", value, rule="JNT110")
        return angle

    def vector(self, key: str, *, metres: bool) -> tuple[float, float, float]:
        value = self._given(key)
        if not isinstance(value, list):
            self.fail(key, "is not a list of three numbers", f"write {key} = [x, y, z]", value)
        numbers = [self._number(key, entry) for entry in value]
        if len(numbers) != 3:
            problem = f"takes 3 numbers, not {len(numbers)}"
            self.fail(key, problem, f"write {key} = [x, y, z]", [float(n) for n in numbers])
        if metres:
            numbers = [self._length(key, number) for number in numbers]
        a, b, c = numbers
        return a, b, c

    def table(self, key: str, known: Collection[str]) -> Table:
        """The table under `key`, with no keys but the known ones."""
        value = self.values[key]
        if not isinstance(value, dict):
            self.fail(key, "is not a table", f"write {key} = {{ {known_keys(known)} }}", value)
        inner = Table(
            value,
            file=self.file,
            text=self._text,
            name=" ".join(part for part in (self.name, key) if part),
            row=self._row,
            key=key,
        )
        if known:
            inner.refuse_unknown_keys(known)
        return inner

    def _number(self, key: str, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.fail(key, "is not a number", "write a number, without quotes", value, "XML103")
        if not isinstance(value, Printed):
            try:
                value = Printed(str(value))
            except (ValueError, OverflowError):
                fix = "write a finite number"
                self.fail(key, "is larger than a double can hold", fix, rule="XML103")
        if not math.isfinite(value):
            self.fail(key, "is not finite", "write a finite number", float(value), "XML103")
        return value

    def _length(self, key: str, metres: float) -> float:
        if abs(metres) > _LONGEST:
            problem = f"is longer than {_LONGEST:g} m: it looks like millimetres"
            self.fail(key, problem, "write metres", float(metres))
        return metres


def known_keys(known: Collection[str]) -> str:
    return ", ".join(f"{key} = …" for key in known) or "…"
