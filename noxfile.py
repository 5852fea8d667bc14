"""The contributor's commands: `nox` runs all checks, `nox -s tests` one, `nox -l` lists them.

All run in the environment that nox runs in, the one with `ur5check[dev]`: one installation of the
engines is enough.
"""

from __future__ import annotations

import nox

nox.options.sessions = ["lint", "types", "tests", "docs"]
nox.options.default_venv_backend = "none"
nox.options.error_on_external_run = False


@nox.session
def format(session: nox.Session) -> None:  # noqa: A001 - the name of the command
    """Format the code and apply the lint fixes that are safe."""
    session.run("ruff", "format", ".")
    session.run("ruff", "check", "--fix", ".")


@nox.session
def lint(session: nox.Session) -> None:
    """Check style and layout without changing a file."""
    session.run("ruff", "check", ".")
    session.run("ruff", "format", "--check", ".")


@nox.session
def types(session: nox.Session) -> None:
    """Check types, strictly."""
    session.run("mypy")
    session.run("mypy", "--config-file", "tests/mypy.ini")


@nox.session
def tests(session: nox.Session) -> None:
    """Run the tests in parallel; arguments after `--` go to pytest."""
    arguments = session.posargs or ["--ignore=tests/docs"]
    session.run("python", "-m", "pytest", "-n", "auto", *arguments)


@nox.session
def docs(session: nox.Session) -> None:
    """Run the commands and code of README and docs, compare generated pages, check links."""
    session.run("python", "-m", "pytest", "-n", "auto", "tests/docs")
