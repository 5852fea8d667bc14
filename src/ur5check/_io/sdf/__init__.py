"""SDF, the format of Gazebo: reader."""

from ..model_format import ModelFormat

__all__ = ["FORMAT"]

FORMAT = ModelFormat(
    kind="sdf",
    title="SDF",
    noun="an SDF file",
    suffixes=(".sdf",),
    purpose="models and worlds of Gazebo and Drake",
    options=("base", "tip"),
    reader=".sdf.sdf_reader:read_sdf_file",
)
