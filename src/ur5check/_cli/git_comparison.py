"""`diff --against-git REF FILE`: a file as a commit has it, against the file as it is now."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from .._errors import UsageError
from .._finding import Finding
from .._io.git_revision import Revision, checked_out
from .._validation.judgement import Judgement, judge
from .._validation.revision_change import RevisionChange, revision_change

if TYPE_CHECKING:
    from .._robot.serial_arm import SerialArm
    from .options import ModelOptions

__all__ = ["arms_and_change"]


def arms_and_change(
    name: str, options: ModelOptions, say: Callable[[str], None]
) -> tuple[list[SerialArm], RevisionChange]:
    """The arm as commit `name` has it, the arm as it is, and what else the commit changed.

    options : of both models, which are the same file.  Raises UsageError as `checked_out` does
    """
    from .._io.package_search import packages_around
    from .._io.shipped_models import SHIPPED_MODELS

    model = options.models[1]
    if model in SHIPPED_MODELS:
        raise UsageError(f"--against-git takes a file, not the shipped model {model}")
    file = Path(model)
    with checked_out(name, file) as revision:
        there = revision.of(file)
        # Packages beside the repository, in a workspace, are the same for both.
        known = packages_around(file) | {k: Path(v) for k, v in options.packages.items()}
        folders = {name: revision.of(folder) for name, folder in known.items()}
        earlier = replace(
            options,
            models=(str(there), model),
            packages={name: str(path) for name, path in folders.items() if path.is_dir()},
        )
        say(f"reading {model} of {name}")
        before, _ = earlier.load(quiet=True, strict=False)
        say(f"reading {model}")
        _, after = options.load(quiet=True, strict=False)
        change = revision_change(
            name,
            (_judged(earlier, 0), revision.tree),
            (_judged(options, 1), revision.top),
        )
        inputs = tuple((revision.label(label), digest) for label, digest in before.source.inputs)
        before = replace(
            before,
            given_label=f"{name}:{file.name}",
            source=replace(before.source, inputs=inputs),
        )
        gone = tuple(_labelled(finding, revision) for finding in change.gone)
    return [before, after], replace(change, gone=gone)


def _judged(options: ModelOptions, which: int) -> Judgement:
    model = options.models[which]
    arguments = options.arguments or None
    chain = options.chains[which]
    return judge(model, **chain, packages=options.packages, arguments=arguments, samples=1)


def _labelled(finding: Finding, revision: Revision) -> Finding:
    places = tuple(replace(p, file=revision.label(p.file)) for p in finding.places)
    return replace(finding, message=revision.label(finding.message), places=places)
