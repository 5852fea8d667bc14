"""The process in which xacro runs: a request on stdin, an answer on stdout.

Started by `xacro_file.expand_xacro` and by nothing else: it changes xacro's own functions and
confines the process until it ends.  It loads no NumPy, so that it starts quickly.

stdout is a file.  Its first bytes (`note_bytes` of them) say what is being evaluated right now, so
that the parent, if it ends this process, knows which expression did not end; the answer follows.
"""

from __future__ import annotations

import glob
import hashlib
import io
import json
import os
import re
import sys
import types
import unicodedata  # noqa: F401 - Python imports it for a name like größe: too late there
import xml.dom.minidom
from collections.abc import Callable, Iterator
from typing import Any, NoReturn

import xacro
from xacro import substitution_args

from ..._errors import ModelError
from ..._files import read_regular
from ..bounded_process import limit_resources
from ..suggestions import did_you_mean
from ..xml.xml_tree import checked_xml
from .xacro_confinement import check_expression, raise_fence
from .xacro_origins import Origins
from .xacro_packages import PackageFolders

__all__ = ["main"]

_NEVER_ENDS = "the expansion never ends: an include, a macro or an expression calls itself"
_CORRECT = "correct the xacro file"

# A part of xacro's message, and what to do about it.
_FIXES = (
    ("unknown macro name", "define the macro before its call, or include the file that defines it"),
    ("Undefined parameters", "give every parameter that has no default"),
    ("Invalid parameter", "remove it, or add it to the macro's params"),
    ("Undefined block", "pass the block to the macro that inserts it"),
    ("Not enough blocks", "pass the missing block as a child element"),
    ("Unused block", "remove the extra child element"),
    ("circular variable definition", "define the property without itself"),
    ("not a boolean expression", "write true, false, 1 or 0"),
    ("missing attribute", "add the attribute"),
    ("environment variable", "use a xacro:arg: a robot must not depend on who looks at it"),
)

# Errors whose message says it all; others are shown with their type.
_SPEAKING = (xacro.XacroException, substitution_args.SubstitutionException, RuntimeError)


class Arguments(dict[str, str]):
    """The arguments given, which remember the names that the file knows.

    xacro asks `name in arguments` where an argument is declared, and `arguments[name]` where it is
    used.  An argument for which it asks neither has no effect: xacro ignores it, we do not.
    """

    def __init__(self, given: dict[str, str]) -> None:
        super().__init__(given)
        self.given = frozenset(given)
        self.known: set[str] = set()

    def __contains__(self, name: object) -> bool:
        self.known.add(str(name))
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self.known.add(name)
        return super().__getitem__(name)

    def check_all_known(self, file: str) -> None:
        for name in sorted(self.given - self.known):
            raise ModelError(
                f"the file has no argument {name!r}",
                fix=did_you_mean(name, self.known),
                file=file,
                value=f"{name}:={dict.__getitem__(self, name)}",
                rule="XAC102",
            )


class Worker:
    """One expansion."""

    def __init__(self, request: dict[str, Any]) -> None:
        self.robot: str = request["robot"]
        self.packages = PackageFolders(request["packages"])
        self.folders: list[str] = request["folders"]
        self.arguments = Arguments(request["arguments"])
        self.note_bytes: int = request["note_bytes"]
        self.output_bytes: int = request["output_bytes"]
        self.inputs: list[tuple[str, str]] = []
        self.origins = Origins()
        self.said = io.StringIO()  # what xacro prints: its warnings
        self.snippet = ""  # the text that is being evaluated, as the file has it
        self.error_files: list[str] = []  # of an error that was found before

    def expand(self) -> dict[str, Any]:
        """The answer."""
        self._take_over_xacro()
        xacro.init_stacks(self.robot)
        document = xacro.parse(None, self.robot)
        xacro.process_doc(document, mappings=self.arguments)
        self.arguments.check_all_known(self.robot)
        self.packages.check_robot(document)
        # Without xacro's banner: it carries the file's path, which is no part of the robot.
        return {
            "text": document.toprettyxml(indent="  "),
            "origins": self.origins.table(document),
            "inputs": self.inputs,
            "warnings": _warnings(self.said.getvalue()),
        }

    # What replaces functions of xacro.

    def _take_over_xacro(self) -> None:
        unchecked_eval = xacro.safe_eval

        def evaluate(text: str, names: Any, inner: Any = None) -> Any:
            check_expression(text)
            try:
                return unchecked_eval(text, names, inner)
            except NameError as error:
                raise ModelError(
                    f"{error}",
                    fix=f"define the property before it is used; {_near(error, names)}",
                    element=f"${{{text}}}",
                    rule="XAC102",
                ) from None

        def evaluate_substitution(text: str, names: dict[str, Any], inner: Any) -> Any:
            # $(eval …) has all of Python's functions in reach, unless they are taken away.
            check_expression(text)
            return eval(text, {**names, "__builtins__": {}}, inner)  # noqa: S307

        dict.pop(xacro._global_symbols["python"], "vars", None)  # it reaches what names cannot

        index = types.ModuleType("ament_index_python.packages")
        index.get_package_share_directory = self._find  # type: ignore[attr-defined]
        sys.modules["ament_index_python"] = types.ModuleType("ament_index_python")
        sys.modules["ament_index_python.packages"] = index
        substitution_args.eval = evaluate_substitution
        xacro.eval_extension = self._watched(xacro.eval_extension, str)
        xacro.safe_eval = self._watched(evaluate, lambda text: f"${{{text}}}")
        xacro.parse = self._parse
        xacro.handle_macro_call = self.origins.noting_calls(xacro.handle_macro_call)
        xacro.open = self._open  # all that load_yaml reads goes through it
        xacro.glob = types.SimpleNamespace(glob=self._glob)

    def _watched(
        self, function: Callable[..., Any], as_written: Callable[[str], str]
    ) -> Callable[..., Any]:
        """The same function, leaving `snippet` at the text that failed, when it fails."""

        def watched(text: str, *rest: Any) -> Any:
            before = self.snippet
            self._note(as_written(text))
            result = function(text, *rest)
            self._note(before)
            return result

        return watched

    def _find(self, name: str) -> str:
        return self.packages.find(name, self.snippet, list(self._files()))

    def _parse(self, source: None, filename: str) -> xml.dom.minidom.Document:
        """`xacro.parse`, which gets a file's name only, for the robot file and for each include."""
        try:
            data = self._read(filename, "<xacro:include>")
        except OSError as error:
            xacro.filestack.pop()  # as xacro does: the file in charge is the one that includes
            which = "file" if filename == self.robot else "included file"
            reason = f"the {which} cannot be read: {error.strerror}"
            problem = ModelError(
                reason,
                fix="correct the file name, or pass --package NAME=DIR for another folder",
                element="<xacro:include>",
                value=filename,
                rule="XAC101",
            )
            # An optional include may be absent: xacro recognises that by the OSError.
            absent = xacro.XacroException(reason, exc=error)
            absent.explained = problem
            absent.snippet = filename.rpartition(os.sep)[2]
            raise absent from None
        return self.origins.parse(checked_xml(data, filename), self.inputs[-1][0])

    def _glob(self, pattern: str) -> list[str]:
        self.packages.check(pattern)
        return glob.glob(pattern)  # noqa: PTH207

    def _open(self, filename: str) -> io.StringIO:
        try:
            return io.StringIO(self._read(filename, "xacro.load_yaml").decode("utf-8"))
        except UnicodeDecodeError:
            raise ModelError(
                "the file is not UTF-8 text",
                fix="save the file as UTF-8",
                file=filename,
                rule="XAC100",
            ) from None

    def _read(self, filename: str, element: str) -> bytes:
        self.packages.check(filename)
        path = os.path.realpath(self._in_any_folder(filename))
        if not any(path.startswith(folder + os.sep) for folder in self.folders):
            self.snippet = filename.rpartition(os.sep)[2]
            raise ModelError(
                "the file lies outside of the robot file's folder and of every package",
                fix="pass --package NAME=DIR for the folder that holds it, if you trust it",
                element=element,
                value=filename,
                rule="XAC103",
            )
        data = read_regular(path)
        self.inputs.append((path, hashlib.sha256(data).hexdigest()))
        return data

    def _in_any_folder(self, filename: str) -> str:
        """$(find) can only name a package's first folder; the file may lie in another one."""
        absolute = os.path.abspath(filename)  # noqa: PTH100
        if not os.path.lexists(absolute):
            for first, *others in self.packages.packages.values():
                if absolute.startswith(first + os.sep):
                    for other in others:
                        elsewhere = other + absolute[len(first) :]
                        if os.path.lexists(elsewhere):
                            return elsewhere
        return absolute

    # What the process that started this one reads.

    def _note(self, snippet: str) -> None:
        self.snippet = snippet
        note = json.dumps({"snippet": snippet[:500], "files": list(self._files())[:3]}).encode()
        if len(note) <= self.note_bytes:
            os.pwrite(1, note.ljust(self.note_bytes), 0)

    def answer(self, answer: dict[str, Any]) -> NoReturn:
        """Write the answer and end, at once: nothing that the file defined runs any more."""
        data = json.dumps(answer).encode()
        if len(data) > self.output_bytes:
            data = json.dumps(self._too_large()).encode()
        position = self.note_bytes
        while data:
            written = os.pwrite(1, data, position)
            data, position = data[written:], position + written
        os._exit(0)

    def stop(self, tried: str) -> NoReturn:
        """End because the file tried what it may not do."""
        self.answer(
            self._error(
                f"the file tried to {tried[:200]}",
                "remove it, and ask who wrote this file",
                element=self.snippet or None,
                rule="XAC103",
            )
        )

    def explain(self, raised: BaseException) -> dict[str, Any]:
        """What went wrong, as an answer."""
        chain = list(_causes(raised))
        for error in chain:
            explained = (
                error if isinstance(error, ModelError) else getattr(error, "explained", None)
            )
            if explained is not None:
                self.snippet = getattr(error, "snippet", self.snippet)
                self.error_files = getattr(error, "files", [])
                return self._error(
                    explained.problem,
                    explained.fix,
                    file=explained.file,
                    line=explained.line,
                    element=explained.element,
                    value=explained.value,
                    rule=explained.rule,
                )
        root = chain[-1]
        message = (str(root) or repr(root)).splitlines()[0]
        if isinstance(root, RecursionError):
            fix = "end it with xacro:if or xacro:unless"
            return self._error(_NEVER_ENDS, fix, self._macro(), rule="XAC104")
        if isinstance(root, MemoryError):
            return self._error(
                "the expansion needs more memory than it may have",
                _CORRECT,
                self.snippet or None,
                rule="XAC104",
            )
        if isinstance(root, substitution_args.ArgException):
            return self._error(
                f"argument {message!r} has no value",
                f"pass --arg {message}:=VALUE, or declare <xacro:arg> with a default before it is "
                "used: <robot>'s own attributes are read before any declaration in it",
                self.snippet or None,
                rule="XAC102",
            )
        element = self.snippet or self._macro()
        for pattern, written, shown in (
            (r"unknown macro name: (\S+)", "<{}", "<{}>"),
            (r'conditional "([^"]*)"', "{}", "{}"),
            (r'Undefined block "([^"]*)"', 'name="{}"', "<xacro:insert_block>"),
        ):
            named = re.search(pattern, message)
            if named:
                self.snippet, element = written.format(named[1]), shown.format(named[1])
        fix = next((fix for said, fix in _FIXES if said in message), _CORRECT)
        if not isinstance(root, _SPEAKING):
            message = f"{type(root).__name__}: {message}"
        return self._error(message, fix, element)

    def _error(
        self,
        problem: str,
        fix: str,
        element: str | None = None,
        *,
        file: str | None = None,
        line: int | None = None,
        value: object = None,
        rule: str = "XAC100",
    ) -> dict[str, Any]:
        return {
            "error": {
                "problem": " ".join(problem.split()).rstrip("."),
                "fix": fix,
                "file": file,
                "line": line,
                "element": element,
                "value": value if value is None else str(value),
                "rule": rule,
            },
            "snippet": self.snippet,
            "files": list(self._files()),
        }

    def _too_large(self) -> dict[str, Any]:
        return self._error(
            f"the expansion is larger than {self.output_bytes // 2**20} MiB",
            _CORRECT,
            rule="XAC104",
        )

    def _files(self) -> Iterator[str]:
        """Where the text under evaluation may stand: the macro's file, then those being read."""
        yield from self.error_files
        if xacro.macrostack and xacro.macrostack[-1].history:
            yield str(xacro.macrostack[-1].history[-1][-1])
        yield from map(str, reversed(xacro.filestack or [self.robot]))

    def _macro(self) -> str | None:
        if not xacro.macrostack:
            return None
        return f"macro {xacro.macrostack[-1].body.getAttribute('name')!r}"


def _causes(error: BaseException) -> Iterator[BaseException]:
    """The error, what it wraps, and so on: xacro keeps the cause in `exc`."""
    cause: BaseException | None = error
    while cause is not None:
        yield cause
        cause = getattr(cause, "exc", None)


def _near(error: NameError, names: Any) -> str:
    """The file's own properties that are called like the missing one."""
    missing = re.search(r"'([^']*)'", str(error))
    own: set[str] = set()
    while names is not None and getattr(names, "root", names) is not names:
        own.update(key.lstrip("*") for key in dict.keys(names) if not key.startswith("__"))
        names = names.parent
    return did_you_mean(missing[1] if missing else "", own)


def _warnings(said: str) -> list[str]:
    prefix = "warning: "
    return [line[len(prefix) :] for line in said.splitlines() if line.startswith(prefix)]


def main() -> NoReturn:
    request = json.loads(sys.stdin.buffer.read())
    os.environ.clear()
    worker = Worker(request)
    sys.stderr = worker.said
    limit_resources(
        seconds=request["seconds"],
        memory=request["memory_bytes"],
        file_size=request["note_bytes"] + request["output_bytes"],
    )
    raise_fence(worker.folders, worker.stop)
    try:
        answer = worker.expand()
    except Exception as error:  # noqa: BLE001 - whatever it is, the answer must say it
        answer = worker.explain(error)
    worker.answer(answer)
