"""URDF, the format of ROS: reader and writer."""

from ..model_format import ModelFormat

__all__ = ["FORMAT"]

FORMAT = ModelFormat(
    kind="urdf",
    title="URDF",
    noun="a URDF (a xacro has arguments)",
    suffixes=(".urdf",),
    purpose="robots in ROS; read by most simulators",
    options=("base", "tip"),
    reader=".urdf.urdf_reader:read_urdf_file",
    writer=".urdf.urdf_writer:urdf_of",
    omissions=".urdf.urdf_writer:not_said",
    xml_root="robot",
)
