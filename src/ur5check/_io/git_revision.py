"""A file as a commit has it, with the files beside it: what its xacro includes and packages need.

The whole tree of the commit is written to a temporary folder, through an index of its own, so that
the repository, its index and its list of worktrees stay as they are.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .._errors import UsageError

__all__ = ["Revision", "checked_out"]


@dataclass(frozen=True)
class Revision:
    """The tree of a commit.

    name : as the user gave it;  top : of the repository;  tree : folder that holds the commit's
    """

    name: str
    top: Path
    tree: Path

    def of(self, path: Path) -> Path:
        """The path's place in the commit's tree; paths outside the repository stay."""
        whole = path.resolve()
        return self.tree / whole.relative_to(self.top) if whole.is_relative_to(self.top) else path

    def label(self, text: str) -> str:
        """A text with the commit's name in the place of the temporary folder."""
        return text.replace(f"{self.tree}{os.sep}", f"{self.name}:")


@contextlib.contextmanager
def checked_out(name: str, file: Path) -> Iterator[Revision]:
    """The tree of a commit of the file's repository, which is gone when the block ends.

    Raises UsageError where there is no repository, commit, or such a file in the commit.
    """
    folder = file.resolve().parent
    if not folder.is_dir():
        raise UsageError(f"--against-git: there is no folder {str(folder)!r}")
    top = Path(_git(folder, "rev-parse", "--show-toplevel", problem=f"{file} is in no repository"))
    no_commit = f"{name!r} names no commit of {top}"
    commit = _git(
        top, "rev-parse", "--verify", "--end-of-options", f"{name}^{{commit}}", problem=no_commit
    )
    with tempfile.TemporaryDirectory(prefix="ur5check-") as scratch:
        tree = Path(scratch).resolve() / "tree"
        tree.mkdir()
        index = {"GIT_INDEX_FILE": str(tree.with_name("index"))}
        failed = f"{name} cannot be checked out"
        _git(top, "read-tree", commit, problem=failed, more=index)
        _git(top, "checkout-index", "--all", f"--prefix={tree}/", problem=failed, more=index)
        revision = Revision(name, top, tree)
        if not revision.of(file).is_file():
            raise UsageError(f"--against-git {name}: has no file {file.resolve().relative_to(top)}")
        yield revision


def _git(folder: Path, *words: str, problem: str, more: dict[str, str] | None = None) -> str:
    try:
        done = subprocess.run(  # noqa: S603 - git itself, no shell
            ["git", "-C", str(folder), *words],  # noqa: S607
            capture_output=True,
            text=True,
            check=False,
            env={**os.environ, **(more or {})},
        )
    except FileNotFoundError:
        raise UsageError("--against-git needs git, which is not installed") from None
    if done.returncode != 0:
        raise UsageError(f"--against-git: {problem}: {' '.join(done.stderr.split())}")
    return done.stdout.strip()
