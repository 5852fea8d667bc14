"""A program as Python source, which needs only NumPy."""

from __future__ import annotations

from collections.abc import Sequence

from ..._arguments import instance
from .infix_text import description, right_hand_side
from .program import Program, read_input

__all__ = ["to_python"]

_INDENT = "    "


def to_python(program: Program, *, head: Sequence[str] = ()) -> str:
    """A program as Python source: one function, named after the quantity, `tau(q, qd, qdd)`.

    Joint arrays are (..., n); leading axes broadcast.  Parameters left as symbols become keyword
    arguments whose defaults are the arm's own numbers.

    Parameters
    ----------
    program : Program
        See `trace`.
    head : sequence of str
        Lines for the top of the file, such as its provenance, written as comments.

    Returns
    -------
    str
        A module that needs only NumPy.

    Raises
    ------
    UsageError
        For another type of program.

    Examples
    --------
    >>> import ur5check
    >>> text = ur5check.to_python(ur5check.trace("paper", "g"))
    >>> "def g(q):" in text
    True
    """
    instance("program", program, Program, "see ur5check.trace")
    first, *others = description(program)
    signature = ", ".join(program.arguments)
    if program.parameters:
        values = "".join(f"{_INDENT}{k}={v!r},\n" for k, v in program.parameters.items())
        signature = f"\n{_INDENT}{signature},\n{_INDENT}*,\n{values}"
    leads = ", ".join(f"{name}.shape[:-1]" for name in program.arguments)
    body = [
        f'"""{first}',
        "",
        *others,
        "",
        f"{', '.join(program.arguments)} : array-like, shape (..., {program.n}); "
        "[rad], [rad/s], [rad/s²], or [m] … where a joint slides.",
        '"""',
        *(f"{name} = np.asarray({name})" for name in program.arguments),
        *(f"{name} = {_read(name)}" for name in program.inputs),
        *(
            f"{line.name} = {right_hand_side(line)}"
            for line in (*program.setup, *program.assignments)
        ),
        "entries = (",
        *(f"{_INDENT}{right_hand_side(line)}," for line in program.outputs),
        ")",
        f"lead = np.broadcast_shapes({leads})",
        "result = np.stack([np.broadcast_to(entry, lead) for entry in entries], axis=-1)",
        f"return result.reshape(lead + {program.shape!r})",
    ]
    lines = [
        *(f"# {line}".rstrip() for line in head),
        "import numpy as np",
        "",
        "",
        f"def {program.quantity}({signature}):",
        *((_INDENT + line).rstrip() for line in body),
    ]
    return "\n".join(lines) + "\n"


def _read(name: str) -> str:
    """An input from the joint arrays: `c2` is np.cos(q[..., 1])."""
    kind, joint = read_input(name)
    functions = {"c": "np.cos(q[..., {}])", "s": "np.sin(q[..., {}])"}
    return functions.get(kind, kind + "[..., {}]").format(joint)
