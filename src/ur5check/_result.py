"""What every result offers: one sentence, a summary, the whole report, JSON, and a notebook's view.

Reports are made in `_reports`, which stands above every result and is loaded when one is shown.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = ["Result"]


class Result:
    """Base of the results that have a report; `to_text` and `to_json` are those of the commands."""

    __slots__ = ()

    @property
    def verdict(self) -> str:
        """The first sentence of the report."""
        verdict = self._document().verdict
        return "" if verdict is None else str(verdict.text)

    def summary(self) -> str:
        """The sentences at the head of the report, the verdict first.

        Returns
        -------
        str
            One sentence a line.
        """
        return "\n".join([self.verdict, *self._document().lines])

    def to_text(self, *, width: int = 100) -> str:
        """The whole report as plain text, as the command prints it.

        Parameters
        ----------
        width : int
            Columns of a line, at least 40.

        Returns
        -------
        str

        Raises
        ------
        UsageError
            For a width that is no whole number, or below 40.
        """
        from ._arguments import integer

        columns = integer("width", width, least=40)
        return str(_reports("terminal").render_text(self._document(), width=columns))

    def to_json(self) -> str:
        """The whole report as JSON, as `--format json` writes it (docs/json.md).

        Returns
        -------
        str
        """
        return str(_reports("of_result").json_of(self))

    def _repr_html_(self) -> str:
        return str(_reports("html").render_html(self._document()))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.verdict}>"

    def _document(self) -> Any:
        return _reports("of_result").document_of(self)


def _reports(module: str) -> Any:
    return import_module(f"ur5check._reports.{module}")
