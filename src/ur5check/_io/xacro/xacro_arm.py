"""A xacro to a `SerialArm`: expanded, then read as a URDF."""

from __future__ import annotations

from ..._errors import ModelError
from ..._robot.serial_arm import SerialArm
from ..model_format import ModelFile
from ..package_search import known_packages
from ..urdf.urdf_reader import read_urdf
from .xacro_reader import expand_xacro

__all__ = ["read_xacro_file"]


def read_xacro_file(file: ModelFile) -> SerialArm:
    """The arm in a xacro.  Raises ModelError as `expand_xacro` and `read_urdf` do."""
    expansion = expand_xacro(
        file.path,
        arguments=file.arguments or {},
        packages=known_packages(file.path, file.packages),
        label=file.label,
    )
    try:
        return read_urdf(
            expansion.text.encode(),
            file=file.label,
            base=file.base,
            tip=file.tip,
            kind="xacro",
            inputs=expansion.inputs,
        )
    except ModelError as error:
        if error.line is None:
            raise
        place = expansion.places.of_line(expansion.text, error.line)
        raise error.at(place) from None
