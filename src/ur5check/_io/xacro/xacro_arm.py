"""A xacro to a `SerialArm`: expanded, then read as a URDF."""

from __future__ import annotations

from ..._robot.serial_arm import SerialArm
from ..model_format import ModelFile
from ..package_search import known_packages
from ..urdf.urdf_reader import read_urdf
from .xacro_reader import expand_xacro

__all__ = ["read_xacro_file"]


def read_xacro_file(file: ModelFile) -> SerialArm:
    """The arm in a xacro.  Raises ModelError as `expand_xacro` and `load_arm` do."""
    expansion = expand_xacro(
        file.path,
        arguments=file.arguments or {},
        packages=known_packages(file.path, file.packages),
        label=file.label,
    )
    return read_urdf(
        expansion.text.encode(),
        file=f"{file.label} (expanded)",
        base=file.base,
        tip=file.tip,
        kind="xacro",
        inputs=expansion.inputs,
        places=expansion.places,
        strict=file.strict,
    )
