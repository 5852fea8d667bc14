"""Look-ups among the known issues that the files in `adapters` declare, and the repaired URDF.

Some known issues are harmless, some change torques.  Where a rewritten file avoids one, `repaired`
writes it; where only the author of the model can (an inertia tensor that no body can have), the
record's `fix` says what to do.
"""

from __future__ import annotations

from dataclasses import replace

from lxml import etree

from .._arguments import instance
from .._errors import UsageError
from .._io.xml.safe_xml import checked_root
from .._robot.robot_tree import ArmOrTree
from .engine_urdf import written
from .known_issue import KnownIssue
from .registry import READERS

__all__ = ["known_issue_for", "known_issues_of", "repairable", "repaired", "repaired_text"]


def known_issues_of(key: str) -> tuple[KnownIssue, ...]:
    """The known issues of one engine or reader.

    Parameters
    ----------
    key : str
        As in `installed_engines`; also "gazebo" and others that only read models.

    Returns
    -------
    tuple of KnownIssue
        Empty for a key that is not known.

    Examples
    --------
    >>> import ur5check
    >>> ur5check.known_issues_of("mujoco")[0].id
    'mujoco-mass-from-shape'
    """
    entry = READERS.get(key) if isinstance(key, str) else None
    return entry.known_issues if entry else ()


def known_issue_for(key: str, kind: str) -> KnownIssue | None:
    """The known issue of a reader that explains an import difference of this kind, if one does."""
    return next((issue for issue in known_issues_of(key) if kind in issue.kinds), None)


def repairable() -> tuple[str, ...]:
    """Keys of the readers for which a URDF can be rewritten (`ur5check expand --for`)."""
    return tuple(
        key
        for key, entry in READERS.items()
        if any(issue.rewrite is not None for issue in entry.known_issues)
    )


def repaired_text(urdf: str, key: str) -> tuple[str, tuple[KnownIssue, ...]]:
    """A URDF's text, rewritten so that a reader imports it rightly.

    Parameters
    ----------
    urdf : str
        The text; `arm.source.urdf` of an arm that was read from a URDF or xacro.
    key : str
        The reader, as `ur5check expand --for` takes it.

    Returns
    -------
    text : str
        The rewritten URDF.
    avoided : tuple of KnownIssue
        The known issues that it avoids.

    Raises
    ------
    UsageError
        For a key for which nothing is rewritten.
    ModelError
        For a text that is no URDF, or a name that is taken and that a repair needs.

    Examples
    --------
    >>> import ur5check
    >>> urdf = ur5check.load("erd-ur5").source.urdf
    >>> text, avoided = ur5check.repaired_text(urdf, "mujoco")
    >>> [issue.id for issue in avoided]
    ['mujoco-mass-from-shape']
    """
    instance("urdf", urdf, str, "give the text, `arm.source.urdf`")
    if key not in repairable():
        raise UsageError(
            f"nothing needs to be rewritten for {key!r}; choose {', '.join(repairable())}"
        )
    root = checked_root(urdf.encode(), "URDF text")
    avoided = tuple(issue for issue in known_issues_of(key) if issue.applied(root))
    etree.indent(root)
    return written(root), avoided


def repaired(arm: ArmOrTree, key: str) -> ArmOrTree:
    """The model with its URDF rewritten for a reader; unchanged where nothing is rewritten."""
    if arm.source.urdf is None or key not in repairable():
        return arm
    text, _ = repaired_text(arm.source.urdf, key)
    return replace(arm, source=replace(arm.source, urdf=text))
