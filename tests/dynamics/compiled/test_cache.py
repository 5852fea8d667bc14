"""Generated code is kept by what it was made from, whole, and out of others' reach."""

from __future__ import annotations

import pytest

import ur5check as ur5
from ur5check._dynamics.compiled.fingerprint import fingerprint
from ur5check._dynamics.compiled.kernel_cache import cache_folder, kept
from ur5check._errors import UsageError


@pytest.fixture
def folder(tmp_path, monkeypatch):
    place = tmp_path / "cache"
    monkeypatch.setenv("UR5CHECK_CACHE", str(place))
    return place


def test_code_is_made_once(folder):
    made = []

    def make():
        made.append(1)
        return b"two\nlines"

    assert [kept("once.o", make) for _ in range(2)] == [b"two\nlines"] * 2
    assert made == [1]
    assert [file.name for file in folder.iterdir()] == ["once.o"]


@pytest.mark.parametrize("spoil", [b"41", b"", b"42 "])
def test_a_spoiled_file_is_made_again(folder, spoil):
    kept("spoiled.o", lambda: b"42")
    (file,) = folder.iterdir()
    head = file.read_bytes().partition(b"\n")[0]
    file.write_bytes(head + b"\n" + spoil)
    assert kept("spoiled.o", lambda: b"43") == b"43"
    assert kept("spoiled.o", lambda: b"44") == b"43"


def test_a_folder_that_others_may_write_is_refused(folder):
    folder.mkdir(mode=0o700)
    folder.chmod(0o777)
    with pytest.raises(UsageError, match="chmod 700"):
        cache_folder()


def test_a_folder_that_cannot_be_made_is_said(folder, monkeypatch):
    folder.parent.joinpath("file").touch()
    monkeypatch.setenv("UR5CHECK_CACHE", str(folder.parent / "file" / "cache"))
    with pytest.raises(UsageError, match="UR5CHECK_CACHE"):
        cache_folder()


def test_a_new_folder_is_for_the_user_only(folder):
    assert cache_folder().stat().st_mode & 0o777 == 0o700


def test_a_fingerprint_knows_every_number_and_no_name():
    arm = ur5.load("paper")
    known = fingerprint([arm], "tau")
    heavier = [link.inertia for link in arm.links]
    heavier[3] = heavier[3] + heavier[3]
    others = [
        fingerprint([arm], "M"),
        fingerprint([arm.with_gravity((0, 0, -9.8))], "tau"),
        fingerprint([arm.with_armature([0.1] * 6)], "tau"),
        fingerprint([arm.with_inertias(heavier)], "tau"),
        fingerprint([ur5.load("paper-listing")], "tau"),
        fingerprint([arm, arm], "tau"),
    ]
    assert len({known, *others}) == 7
    assert fingerprint([ur5.load("paper")], "tau") == known


def test_a_fingerprint_knows_the_code_that_generates(monkeypatch):
    arm = ur5.load("paper")
    known = fingerprint([arm], "tau")
    monkeypatch.setattr(
        "ur5check._dynamics.compiled.fingerprint._generator_hash", lambda: "another recursion"
    )
    assert fingerprint([arm], "tau") != known
