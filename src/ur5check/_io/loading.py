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
from .formats import FORMATS, SUFFIXES, format_by_suffix
from .model_format import ModelFile, ModelFormat
from .shipped_models import SHIPPED_MODELS
from .suggestions import did_you_mean

__all__ = ["ArmSource", "load"]


def load(
    x: ArmSource,
    *,
    base: str | None = None,
    tip: str | None = None,
    packages: Mapping[str, str | Path] | None = None,
    arguments: Mapping[str, str] | None = None,
) -> SerialArm:
    """Read an arm from a file, a shipped model or a `pin.Model`.

    Parameters
    ----------
    x : name, path, pin.Model or SerialArm
        The name of a shipped model, the path of a .urdf, .xacro, MJCF .xml, .sdf or DH .toml file,
        a `pin.Model`, or a `SerialArm`, which comes back as it is.
    base, tip : str, optional
        Links (bodies or sites of an MJCF, frames of a pin.Model) between which the arm is taken.
    packages : mapping of str to path, optional
        ROS package names and their folders, for `$(find …)` in a xacro.
    arguments : mapping of str to str, optional
        Values for the `xacro:arg`s of a xacro.

    Returns
    -------
    SerialArm

    Raises
    ------
    ModelError
        For what is wrong in a file.
    UsageError
        For a name that means nothing, or an option that means nothing for this kind of `x`.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.load("appendix")
    <SerialArm 'appendix': 6 joints, from xacro>
    """
    for name, value in (("base", base), ("tip", tip)):
        if value is not None:
            instance(name, value, str, "give the name of a link")
    text_map("packages", packages)
    text_map("arguments", arguments)
    if isinstance(x, SerialArm):
        _refuse("an arm that is made already", base=base, tip=tip, arguments=arguments)
        return x
    # By the type's name, so that Pinocchio is not imported for a file that does not need it.
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
        form, label = _format_of(path), str(path)
    else:
        # The errors and reports of a shipped model say the same on every machine.
        path, form, label = entry.path(), FORMATS[entry.kind], f"{entry.home}/{entry.file}"
        base, tip = (entry.base if base is None else base), (entry.tip if tip is None else tip)
    data = _bytes(path, label)
    arm = _read(ModelFile(path, label, data, base, tip, packages, arguments), form)
    return arm if entry is None else replace(arm, name=entry.name)


def _read(file: ModelFile, form: ModelFormat) -> SerialArm:
    if file.path.suffix.lower() == ".xml":
        form = _format_by_root(file)
    given = {"base": file.base, "tip": file.tip, "arguments": file.arguments}
    _refuse(form.noun, **{key: given[key] for key in given if key not in form.options})
    return form.read(file)


def _format_by_root(file: ModelFile) -> ModelFormat:
    """Both MuJoCo's models and some URDFs are called .xml; the root element decides."""
    from lxml import etree

    from .xml.safe_xml import checked_root

    root = checked_root(file.data, file.label)
    known = {form.xml_root: form for form in FORMATS.values() if form.xml_root}
    if root.tag not in known:
        raise ModelError(
            "the root element is neither MJCF's nor a URDF's",
            fix="a .xml file is <mujoco> or <robot>; an SDF is called .sdf",
            file=file.label,
            line=root.sourceline,
            element=f"<{etree.QName(root).localname}>",
            rule="XML102",
        )
    return known[root.tag]


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
