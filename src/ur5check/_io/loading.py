"""One door for everything that can be taken for an arm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from .._errors import ModelError, UsageError
from .._robot import SerialArm
from .._robot.as_arm import ArmSource
from .shipped_models import SHIPPED_MODELS
from .suggestions import did_you_mean

__all__ = ["ArmSource", "load"]

_KINDS = {
    ".urdf": "urdf",
    ".xacro": "xacro",
    ".toml": "dh",
    ".xml": "xml",
    ".mjcf": "mjcf",
    ".sdf": "sdf",
}


def load(
    x: ArmSource,
    *,
    base: str | None = None,
    tip: str | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
) -> SerialArm:
    """The arm that `x` stands for.

    x : the name of a shipped model, the path of a .urdf, .xacro, MJCF .xml, .sdf or DH .toml file,
        a `pin.Model`, or a `SerialArm`, which comes back as it is
    base, tip : links (bodies or sites of an MJCF, frames of a pin.Model) between which the arm is
        taken
    packages : ROS package names and their folders, for `$(find …)` in a xacro
    arguments : values for the `xacro:arg`s of a xacro

    Raises ModelError for what is wrong in a file, UsageError for a name that means nothing and for
    an option that means nothing for this kind of `x`.
    """
    if isinstance(x, SerialArm):
        _refuse("an arm that is made already", base=base, tip=tip, arguments=arguments)
        return x
    # Asked of the name, so that Pinocchio is not imported for a file that does not need it.
    if type(x).__module__.partition(".")[0] == "pinocchio" and type(x).__name__ == "Model":
        from .pinocchio_model import read_pinocchio_model

        _refuse("a pin.Model", arguments=arguments)
        return read_pinocchio_model(x, base=base, tip=tip)
    if not isinstance(x, str | Path):
        raise UsageError(
            f"a {type(x).__name__} is no arm; give a model's name, a path, a pin.Model or a "
            "SerialArm"
        )
    entry = SHIPPED_MODELS.get(x) if isinstance(x, str) else None
    if entry is None:
        path = Path(x)
        return _read(path, _kind_of(path), str(path), base, tip, packages, arguments)
    # The errors and reports of a shipped model say the same on every machine.
    label = f"{entry.home}/{entry.file}"
    base, tip = (entry.base if base is None else base), (entry.tip if tip is None else tip)
    arm = _read(entry.path(), entry.kind, label, base, tip, packages, arguments)
    return replace(arm, name=entry.name)


def _read(
    path: Path,
    kind: str,
    label: str,
    base: str | None,
    tip: str | None,
    packages: Mapping[str, str | Path] | None,
    arguments: Mapping[str, str] | None,
) -> SerialArm:
    data = _bytes(path, label)
    if kind == "dh":
        from .dh.dh_reader import read_dh

        _refuse("a DH table", base=base, tip=tip, arguments=arguments)
        return read_dh(data, file=label)
    if kind == "xml":
        kind = _kind_by_root(data, label)
    if kind == "mjcf":
        from .mjcf.mjcf_reader import read_mjcf

        _refuse("an MJCF file", arguments=arguments)
        return read_mjcf(data, file=label, folder=path.parent, base=base, tip=tip)
    if kind == "sdf":
        from .sdf.sdf_reader import read_sdf

        _refuse("an SDF file", arguments=arguments)
        return read_sdf(data, file=label, base=base, tip=tip)
    from .urdf.urdf_reader import read_urdf

    if kind == "urdf":
        _refuse("a URDF (a xacro has arguments)", arguments=arguments)
        return read_urdf(data, file=label, base=base, tip=tip)
    from .ros_packages import default_packages
    from .xacro.xacro_reader import expand_xacro

    expansion = expand_xacro(
        path,
        arguments=arguments or {},
        packages=default_packages().with_packages(packages or {}),
    )
    # Lines are those of the expanded text: what stands in them may come from any of its files.
    return read_urdf(
        expansion.text.encode(),
        file=f"{label} (expanded)",
        base=base,
        tip=tip,
        kind="xacro",
        inputs=tuple(expansion.inputs),
    )


def _kind_by_root(data: bytes, label: str) -> str:
    """Both MuJoCo's models and some URDFs are called .xml; the root element tells."""
    from lxml import etree

    from .xml.safe_xml import checked_root

    root = checked_root(data, label)
    kind = {"mujoco": "mjcf", "robot": "urdf"}.get(root.tag)
    if kind is None:
        raise ModelError(
            "the root element is neither MJCF's nor a URDF's",
            fix="a .xml file is <mujoco> or <robot>; an SDF is called .sdf",
            file=label,
            line=root.sourceline,
            element=f"<{etree.QName(root).localname}>",
        )
    return kind


def _refuse(what: str, **options: object) -> None:
    for name, value in options.items():
        if value:
            raise UsageError(f"{name}= has no meaning for {what}; leave it out")


def _kind_of(path: Path) -> str:
    """By the suffix.  A name without one that is no file was meant for the shipped models."""
    kind = _KINDS.get(path.suffix.lower())
    if kind is not None:
        return kind
    if not path.exists() and path.suffix == "":
        raise UsageError(
            f"no shipped model and no file is called {str(path)!r}; "
            f"{did_you_mean(str(path), SHIPPED_MODELS)}"
        )
    raise ModelError(
        "is a folder" if path.is_dir() else "is no kind of file that an arm is read from",
        fix=f"give a model's name, or a file ending in {', '.join(_KINDS)}",
        file=str(path),
    )


def _bytes(path: Path, label: str) -> bytes:
    try:
        if path.exists() and not path.is_file():
            raise ModelError("is no file", fix="give the file itself", file=label)
        return path.read_bytes()
    except FileNotFoundError:
        near = did_you_mean(path.stem, SHIPPED_MODELS)
        raise ModelError(
            "there is no such file", fix=f"correct the path; shipped models: {near}", file=label
        ) from None
    except (OSError, ValueError) as error:  # ValueError: a NUL in the path
        reason = getattr(error, "strerror", None) or str(error)
        raise ModelError(
            f"cannot be read: {reason}", fix="check the path and its permissions", file=label
        ) from None
