"""A lazy module is imported at its first use, and behaves as the module from then on."""

from __future__ import annotations

import sys

import pytest

from ur5check._engines.lazy_import import lazy_import


def test_it_is_imported_when_an_attribute_is_read(tmp_path, monkeypatch):
    (tmp_path / "lazily_imported.py").write_text(
        "import warnings\nwarnings.warn('old', DeprecationWarning)\nanswer = 42\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    module = lazy_import("lazily_imported", ignored=DeprecationWarning)
    assert "lazily_imported" not in sys.modules
    assert module.answer == 42
    assert module() is sys.modules.pop("lazily_imported")
    with pytest.raises(AttributeError):
        _ = module.question


def test_a_warning_that_is_not_ignored_is_not_hidden(tmp_path, monkeypatch):
    (tmp_path / "warns_on_import.py").write_text("import warnings\nwarnings.warn('w', UserWarning)")
    monkeypatch.syspath_prepend(tmp_path)
    module = lazy_import("warns_on_import", ignored=DeprecationWarning)
    with pytest.raises(UserWarning, match="w"):
        module()


def test_an_absent_module_is_an_import_error():
    with pytest.raises(ImportError):
        _ = lazy_import("no_such_module").anything
