"""MJCF, the format of MuJoCo: reader and writer."""

from ..model_format import ModelFormat

__all__ = ["FORMAT"]

FORMAT = ModelFormat(
    kind="mjcf",
    title="MJCF",
    noun="an MJCF file",
    suffixes=(".xml", ".mjcf"),
    purpose="models of MuJoCo",
    options=("base", "tip"),
    reader=".mjcf.mjcf_reader:read_mjcf_file",
    writer=".mjcf.mjcf_writer:mjcf_of",
    omissions=".mjcf.mjcf_writer:not_said",
    xml_root="mujoco",
)
