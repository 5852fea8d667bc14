"""What pytest is asked to check, and the verdicts on it, each computed once a process."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest

from .._errors import Ur5checkError
from .._validation.configuration import Configuration, find_configuration
from .._validation.engine_judgement import engines_asked
from .._validation.verdict import (
    PairVerdict,
    Request,
    Verdict,
    compare_verdicts,
    files_under,
    verdicts,
)

__all__ = ["PluginRequest"]

#: States at which the computation is checked: as `validate` takes for many files.
_SAMPLES = 100


@dataclass(frozen=True)
class PluginRequest:
    """What is checked.

    files : absolute paths of the models;  against : None where nothing is compared
    """

    files: tuple[Path, ...]
    against: str | None
    engines: tuple[str, ...]
    configuration: Configuration
    root: Path
    _verdicts: dict[str, Verdict] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        named: list[str],
        against: str | None,
        engines: str | None,
        *,
        by_option: bool,
        root: Path,
    ) -> PluginRequest:
        """Raises pytest.UsageError for a file, engine or setting that has no meaning.

        by_option : whether models were named on the command line, from the current folder, or as
            patterns by the project, from its root
        """
        try:
            if by_option:
                files = [Path(file).resolve() for file in files_under(named)]
            else:
                files = sorted(path for pattern in named for path in root.glob(pattern))
            missing = [str(file) for file in files if not file.is_file()]
            if missing or not files:
                raise pytest.UsageError(f"ur5check: no such file: {', '.join(missing or named)}")
            configuration = find_configuration(files[0].parent)
            asked = configuration.engines
            if engines is not None:
                asked = tuple(name.strip() for name in engines.split(",") if name.strip())
            engines_asked(asked)
        except Ur5checkError as error:
            raise pytest.UsageError(f"ur5check: {error}") from None
        other = configuration.against if against is None else against
        return cls(tuple(dict.fromkeys(files)), other, asked, configuration, root)

    def verdict(self, model: Path | str) -> Verdict:
        """The verdict on a model; raises Ur5checkError as `judge` does."""
        name = str(model)
        if name not in self._verdicts:
            request = Request(name, samples=_SAMPLES, engines=self.engines)
            request = request.with_settings(self.configuration)
            (verdict,) = verdicts([request], self.configuration, self.configuration.fail_level)
            self._verdicts[name] = verdict
        return self._verdicts[name]

    def agreement(self, model: Path) -> PairVerdict | None:
        """How the model compares with the one of `against`; None with itself."""
        if self.against is None:
            raise ValueError("nothing to compare with")
        mine, other = self.verdict(model), self.verdict(self.against)
        pairs = compare_verdicts([mine], replace(other), self.configuration).pairs
        return pairs[0] if pairs else None
