"""Tables of Denavit–Hartenberg parameters in TOML: reader and writer."""

from ..model_format import ModelFormat

__all__ = ["FORMAT"]

FORMAT = ModelFormat(
    kind="dh",
    title="DH table",
    noun="a DH table",
    suffixes=(".toml",),
    purpose="tables of papers and data sheets",
    options=(),
    reader=".dh.dh_reader:read_dh_file",
    tensors_needed=False,
    writer=".dh.dh_writer:dh_toml_of",
)
