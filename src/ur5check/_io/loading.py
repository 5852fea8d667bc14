"""`load`: every source of an arm, by name, path or value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from .._arguments import instance, text_map
from .._errors import ModelError, UsageError
from .._files import read_regular
from .._robot import SerialArm
from .._robot.as_arm import ArmSource
from .formats import FORMATS, SUFFIXES, format_by_suffix, format_of_text
from .model_format import ModelFile, ModelFormat
from .shipped_models import SHIPPED_MODELS
from .suggestions import did_you_mean

__all__ = ["ArmSource", "load"]


def load(
    x: ArmSource,
    *,
    base: str | None = None,
    tip: str | None = None,
    arm: str | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
    strict: bool = True,
) -> SerialArm:
    """Read an arm from a file, a shipped model or a `pin.Model`.

    Parameters
    ----------
    x : name, path, pin.Model or SerialArm
        The name of a shipped model, the path of a .urdf, .xacro, MJCF .xml, .sdf or DH .toml file,
        a `pin.Model`, or a `SerialArm`, which comes back as it is.
    base, tip : str, optional
        Links (bodies or sites of an MJCF, frames of a pin.Model) between which the arm is taken;
        of a URDF or xacro by default the root, and the end of the chain that is clearly the arm.
    arm : str, optional
        In place of `tip`, of a file with several chains: the name of the last link, or another
        that tells the chain from the others ("left", "right_arm").
    packages : mapping of str to path, optional
        ROS package names and their folders, for `$(find …)` in a xacro.
    arguments : mapping of str to str, optional
        Values for the `xacro:arg`s of a xacro.
    strict : bool
        False takes a URDF or xacro also where a body or a joint of the arm cannot exist (a tensor
        that no body has, limits that are swapped), as long as every number can be read;
        `source.faults` then lists these findings.

    Returns
    -------
    SerialArm

    Raises
    ------
    ModelError
        For the first fault of a file that concerns the arm; `judge` finds all faults of the
        whole robot.
    UsageError
        For a name that means nothing, or an option that means nothing for this kind of `x`.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.load("appendix")
    <SerialArm 'appendix': 6 joints, from xacro>
    """
    for name, value in (("base", base), ("tip", tip), ("arm", arm)):
        if value is not None:
            instance(name, value, str, "give a name")
    text_map("packages", packages)
    text_map("arguments", arguments)
    if isinstance(x, SerialArm):
        _refuse("an arm that is made already", base=base, tip=tip, arm=arm, arguments=arguments)
        return x
    # By the type's name, so that Pinocchio is not imported for a file that does not need it.
    if type(x).__module__.partition(".")[0] == "pinocchio" and type(x).__name__ == "Model":
        from .pinocchio_model import read_pinocchio_model

        _refuse("a pin.Model", arm=arm, arguments=arguments)
        return read_pinocchio_model(x, base=base, tip=tip)
    if not isinstance(x, str | Path):
        raise UsageError(
            f"a {type(x).__name__} is no arm; give a model's name, a path, a pin.Model or a "
            "SerialArm"
        )
    if arm is not None:
        from .robot_loading import read_robot

        reading = read_robot(x, base=base, tip=tip, arm=arm, packages=packages, arguments=arguments)
        base, tip = reading.base, reading.tip
    entry = SHIPPED_MODELS.get(x) if isinstance(x, str) else None
    if entry is None:
        path, label = Path(x), str(Path(x))
        form = _format_of(path)
    else:
        # The errors and reports of a shipped model say the same on every machine.
        path, label = entry.path(), f"{entry.home}/{entry.file}"
        form = FORMATS[entry.kind]
        base, tip = (entry.base if base is None else base), (entry.tip if tip is None else tip)
    data = _bytes(path, label)
    form = format_of_text(form, path, data, label)
    read = form.read(ModelFile(path, label, data, base, tip, packages, arguments, strict))
    return read if entry is None else replace(read, name=entry.name)


def _refuse(what: str, **options: object) -> None:
    for name, value in options.items():
        if value:
            raise UsageError(f"{name}= has no meaning for {what}; leave it out")


def _format_of(path: Path) -> ModelFormat:
    """By the suffix.  A name without one that is no file was meant for the shipped models."""
    form = format_by_suffix(path)
    if form is not None:
        return form
    if not path.exists() and path.suffix == "":
        raise UsageError(
            f"no shipped model and no file is called {str(path)!r}; "
            f"{did_you_mean(str(path), SHIPPED_MODELS)}"
        )
    raise ModelError(
        "is a folder" if path.is_dir() else "is no kind of file that an arm is read from",
        fix=f"give a model's name, or a file ending in {', '.join(SUFFIXES)}",
        file=str(path),
    )


def _bytes(path: Path, label: str) -> bytes:
    try:
        if path.exists() and not path.is_file():
            raise ModelError("is no file", fix="give the file itself", file=label)
        return read_regular(path)
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
