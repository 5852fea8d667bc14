"""A file that is written is the old one or the new one, whole."""

from __future__ import annotations

from pathlib import Path

import pytest

from ur5check._files import draft_of, write_whole


def test_new_content_takes_the_place_of_old(tmp_path: Path) -> None:
    file = tmp_path / "report.txt"
    file.write_bytes(b"old")
    file.chmod(0o640)
    write_whole(file, b"new")
    assert file.read_bytes() == b"new"
    assert file.stat().st_mode & 0o777 == 0o640
    assert list(tmp_path.iterdir()) == [file]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "target")
    write_whole(tmp_path / "link", b"x")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "target").read_bytes() == b"x"


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_an_interruption_leaves_the_old_content_and_nothing_beside_it(
    kind: str, tmp_path: Path
) -> None:
    target = tmp_path / "target"
    target.write_bytes(b"old")
    with pytest.raises(KeyboardInterrupt), draft_of(target) as draft:
        if kind == "file":
            draft.write_bytes(b"half")
        else:
            (draft / "inner").mkdir(parents=True)
        raise KeyboardInterrupt
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_folder_appears_whole(tmp_path: Path) -> None:
    with draft_of(tmp_path / "package") as draft:
        (draft / "launch").mkdir(parents=True)
        (draft / "launch" / "file").write_bytes(b"1")
        assert not (tmp_path / "package").exists()
    assert (tmp_path / "package" / "launch" / "file").read_bytes() == b"1"
    assert [path.name for path in tmp_path.iterdir()] == ["package"]
