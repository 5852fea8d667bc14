"""xacro, the macro language in which URDFs are written: it is expanded, then read as a URDF."""

from ..model_format import ModelFormat

__all__ = ["FORMAT"]

FORMAT = ModelFormat(
    kind="xacro",
    title="xacro",
    noun="a xacro",
    suffixes=(".xacro",),
    purpose="sources of URDFs, with parameters",
    options=("base", "tip", "arguments"),
    reader=".xacro.xacro_arm:read_xacro_file",
)
