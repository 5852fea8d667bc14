"""Which files a model was read from, so that -o overwrites none of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from .._errors import ModelError
from .._io.package_search import known_packages
from .._io.shipped_models import SHIPPED_MODELS

__all__ = ["input_files"]


def input_files(
    model: str, inputs: Iterable[tuple[str, str]], packages: Mapping[str, str]
) -> list[Path]:
    """The model's own file, and those named in its `inputs` that can be found again."""
    file = SHIPPED_MODELS[model].path() if model in SHIPPED_MODELS else Path(model)
    map_of_packages = known_packages(file, packages)
    files = [file]
    for name, _ in inputs:
        try:
            files.append(map_of_packages.resolve(name, file.parent))
        except ModelError:
            # A label, such as the one of a shipped model: that file stands in the list already.
            continue
    return files
