"""`read_recording`: files to a `Recording` of the model's joints, with findings."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from .._errors import UsageError
from .._finding import Finding, Place
from .._robot.transforms import Array
from .._rules.finding_log import FindingLog
from .column_names import Quantity, columns_of
from .joint_matching import joint_order
from .options import RecordingOptions
from .read_bag import BAG_SUFFIXES, read_bag
from .read_table import Table, read_table
from .recording import Recording

__all__ = ["TABLE_SUFFIXES", "read_recording"]

TABLE_SUFFIXES = (".csv", ".txt", ".dat", ".tsv", ".parquet")

#: What the blocks of a table without a header are, by the number of its columns over joints.
_BLOCKS: dict[int, tuple[str, ...]] = {
    2: ("t", "q", "tau"),
    3: ("t", "q", "qd", "tau"),
    5: ("t", "q", "qd", "current", "-", "model"),
}
_FIELDS: dict[Quantity, str] = {
    "q": "q", "qd": "qd", "tau": "tau", "current": "current", "model": "model_tau",
}  # fmt: skip


def read_recording(
    files: str | Path | Sequence[str | Path],
    joints: Sequence[str],
    options: RecordingOptions = RecordingOptions(),  # noqa: B008 - immutable
) -> tuple[Recording, tuple[Finding, ...]]:
    """Read a recording of a model's joints.

    Parameters
    ----------
    files : path, or sequence of paths
        A ROS bag, a table, or several tables of the same rows (position, velocity, effort).
    joints : sequence of str
        Names of the model's joints, in its order.
    options : RecordingOptions
        What the file does not say.

    Returns
    -------
    recording : Recording
        As the file has it, in the model's order of joints; nothing is filtered or left out but
        rows of another length.
    findings : tuple of Finding
        Of family LOG.

    Raises
    ------
    UsageError
        For files that cannot be read, or whose columns are not known.
    """
    named = [files] if isinstance(files, str | Path) else files
    if (
        not isinstance(named, Sequence)
        or not named
        or not all(isinstance(f, str | Path) for f in named)
    ):
        raise UsageError("files: give the path of a recording, or a list of paths")
    paths = [Path(f) for f in named]
    for path in paths:
        if not path.exists():
            raise UsageError(f"{path}: there is no such file")
    log = FindingLog()
    if paths[0].suffix.lower() in BAG_SUFFIXES or paths[0].is_dir():
        if len(paths) > 1:
            raise UsageError("give one bag at a time")
        recording = _of_bag(paths[0], options)
    else:
        recording = _of_tables(paths, joints, options, log)
    recording = _of_model(recording, joints, options, log)
    return _scaled(recording, options), tuple(log.findings)


def _of_bag(path: Path, options: RecordingOptions) -> Recording:
    (names, t, q, qd, tau), topic = read_bag(path, options.topic)
    return Recording(
        str(path), names, t, q, _given(qd), _given(tau), np.arange(1, len(t) + 1),
        inputs=_inputs([path]),
        columns=(f"joint states of {topic}; time by the messages' own stamps",),
    )  # fmt: skip


def _of_tables(
    paths: list[Path], joints: Sequence[str], options: RecordingOptions, log: FindingLog
) -> Recording:
    for path in paths:
        if path.suffix.lower() not in TABLE_SUFFIXES:
            known = ", ".join((*BAG_SUFFIXES, *TABLE_SUFFIXES))
            raise UsageError(f"{path}: no kind of recording; known are {known}")
    parts = [(path, read_table(path)) for path in paths]
    for path, table in parts:
        if table.cut:
            log.add(
                "LOG103",
                "rows",
                f"{len(table.cut)} row{'s' if len(table.cut) > 1 else ''} of another length",
                *(Place(str(path), row) for row in table.cut[:1]),
                value=float(len(table.cut)),
            )
    lengths = {len(table.values) for _, table in parts}
    if len(lengths) > 1:
        raise UsageError(f"the files have {sorted(lengths)} rows; give tables of the same rows")
    found: dict[Quantity, Array] = {}
    names: tuple[str, ...] = ()
    columns: list[str] = []
    for path, table in parts:
        given, own, said = _quantities(path, table, len(joints), options, several=len(parts) > 1)
        found = {**given, **found}
        names = names or own
        columns += said
    if "q" not in found:
        raise UsageError(f"{paths[0]}: no columns of positions; say which: --columns")
    count = len(found["q"])
    if "t" in found:
        t = found["t"][:, 0]
    elif options.rate:
        t = np.arange(count) / options.rate
    else:
        raise UsageError(f"{paths[0]}: no column of time; give --rate HZ or --columns")
    return Recording(
        ", ".join(map(str, paths)),
        names or tuple(f"joint {i + 1}" for i in range(found["q"].shape[1])),
        t,
        found["q"],
        rows=parts[0][1].rows,
        inputs=_inputs(paths),
        columns=tuple(columns),
        **{field: found.get(quantity) for quantity, field in _FIELDS.items() if quantity != "q"},
    )


def _quantities(
    path: Path, table: Table, n: int, options: RecordingOptions, *, several: bool
) -> tuple[dict[Quantity, Array], tuple[str, ...], list[str]]:
    """Arrays by quantity, joint names where columns bear them, and what was taken for what."""
    if table.names and "=" not in options.columns:
        by_name = columns_of(table.names)
        if several and "q" not in by_name and not set(by_name) - {"t"}:
            by_name = _by_file_name(path, table)
        return _named(table, by_name)
    if table.names:
        return _named(table, _by_pattern(path, table.names, options.columns, n))
    blocks = (
        tuple(options.columns.split(",")) if options.columns else _default_blocks(path, table, n)
    )
    return _blocks(path, table, blocks, n)


def _named(
    table: Table, by_name: dict[Quantity, dict[str, int]]
) -> tuple[dict[Quantity, Array], tuple[str, ...], list[str]]:
    joints = list(by_name.get("q") or next((v for k, v in by_name.items() if k != "t"), {}))
    if joints and all(joint.isdigit() for joint in joints):
        joints.sort(key=int)
    given: dict[Quantity, Array] = {}
    said = []
    for quantity, columns in by_name.items():
        order = [""] if quantity == "t" else joints
        if all(joint in columns for joint in order):
            given[quantity] = table.values[:, [columns[joint] for joint in order]]
            first = table.names[columns[order[0]]]
            said.append(f"{quantity}: {first!r}{' …' if len(order) > 1 else ''}")
    named = () if all(joint.isdigit() for joint in joints) else tuple(joints)
    return given, named, said


def _by_file_name(path: Path, table: Table) -> dict[Quantity, dict[str, int]]:
    """One quantity in a file of its own: the file's name says which, the header the joints."""
    for word in reversed(re.split(r"[\W_]+", path.stem.lower())):
        meaning = columns_of((f"{word}_0",))
        if meaning:
            quantity = next(iter(meaning))
            by_name: dict[Quantity, dict[str, int]] = {quantity: {}}
            for column, name in enumerate(table.names):
                if columns_of((name,)).get("t"):
                    by_name["t"] = {"": column}
                else:
                    by_name[quantity][name.strip()] = column
            return by_name
    return {}


def _by_pattern(
    path: Path, names: tuple[str, ...], patterns: str, n: int
) -> dict[Quantity, dict[str, int]]:
    found: dict[Quantity, dict[str, int]] = {}
    for item in patterns.split():
        quantity, _, pattern = item.partition("=")
        if quantity not in (*_FIELDS, "t"):
            raise UsageError(
                f"--columns: {quantity!r} is no quantity; write t, {', '.join(_FIELDS)}"
            )
        if quantity == "t":
            wanted = {"": pattern}
        else:
            start = 0 if pattern.replace("{i}", "0") in names else 1
            wanted = {str(i): pattern.replace("{i}", str(i + start)) for i in range(n)}
        missing = next((name for name in wanted.values() if name not in names), None)
        if missing is not None:
            raise UsageError(f"{path}: --columns: there is no column {missing!r}")
        found[quantity] = {joint: names.index(name) for joint, name in wanted.items()}
    return found


def _default_blocks(path: Path, table: Table, n: int) -> tuple[str, ...]:
    width = table.values.shape[1]
    blocks = _BLOCKS.get((width - 1) // n) if (width - 1) % n == 0 else None
    if blocks is None:
        raise UsageError(
            f"{path}: has no header and {width} columns; say what they are, such as "
            "--columns t,q,qd,tau"
        )
    return blocks


def _blocks(
    path: Path, table: Table, blocks: tuple[str, ...], n: int
) -> tuple[dict[Quantity, Array], tuple[str, ...], list[str]]:
    known = (*_FIELDS, "t", "-")
    wrong = next((block for block in blocks if block not in known), None)
    if wrong is not None:
        raise UsageError(f"--columns: {wrong!r} is no quantity; write {', '.join(known)}")
    widths = [1 if block == "t" else n for block in blocks]
    if sum(widths) != table.values.shape[1]:
        raise UsageError(
            f"{path}: has {table.values.shape[1]} columns, but {','.join(blocks)} of {n} joints "
            f"are {sum(widths)}; correct --columns"
        )
    ends = np.cumsum(widths)
    given: dict[Quantity, Array] = {
        block: table.values[:, end - width : end]  # type: ignore[misc]
        for block, width, end in zip(blocks, widths, ends, strict=True)
        if block != "-"
    }
    said = [f"no header: columns taken as {', '.join(blocks)} of {n} joints"]
    return given, (), said


def _of_model(
    recording: Recording, joints: Sequence[str], options: RecordingOptions, log: FindingLog
) -> Recording:
    order, how = joint_order(recording, joints, by_order=options.by_order)
    if how == "order":
        log.add(
            "LOG111",
            "joints",
            "are matched to the model's by their order",
            Place(recording.file),
            value=", ".join(recording.joints[k] for k in order),
        )
    return recording.of_joints(order, tuple(joints))


def _scaled(recording: Recording, options: RecordingOptions) -> Recording:
    """Units, offsets, gains and gears, as the options say."""
    n = recording.n
    q, qd, tau = recording.q, recording.qd, recording.tau
    if options.degrees:
        q, qd = np.radians(q), None if qd is None else np.radians(qd)
    if options.gains:
        if len(options.gains) not in (1, n):
            raise UsageError(f"gains: give 1 or {n} numbers, not {len(options.gains)}")
        source = tau if tau is not None else recording.current
        tau = None if source is None else source * np.array(options.gains)
    if options.offsets:
        if len(options.offsets) != n:
            raise UsageError(f"offsets: give {n} numbers, not {len(options.offsets)}")
        q = q - np.array(options.offsets)
    if options.coupling:
        G = np.array(options.coupling)
        if G.shape != (n, n) or np.linalg.matrix_rank(G) < n:
            raise UsageError(f"coupling: give {n} independent rows of {n} numbers")
        q, qd = q @ G.T, None if qd is None else qd @ G.T
        tau = None if tau is None else tau @ np.linalg.inv(G)
    return replace(recording, q=q, qd=qd, tau=tau)


def _given(values: Array) -> Array | None:
    return None if np.isnan(values).all() else values


def _inputs(paths: list[Path]) -> tuple[tuple[str, str], ...]:
    files = [
        file
        for path in paths
        for file in (sorted(p for p in path.rglob("*") if p.is_file()) if path.is_dir() else [path])
    ]
    digests = []
    for file in files:
        with file.open("rb") as stream:
            digests.append((str(file), hashlib.file_digest(stream, "sha256").hexdigest()))
    return tuple(digests)
