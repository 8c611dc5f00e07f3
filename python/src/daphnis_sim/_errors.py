"""What goes wrong, as exceptions of Python with one line each."""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import jpype


class DaphnisError(Exception):
    """Whatever daphnis raises.

    Attributes:
        java: the exception of Java, whose ``stacktrace()`` says where; None if it did not come from there.
    """

    java: Any = None

    def __reduce__(self) -> Any:
        """For ``pickle``, which brings it out of the process of a pool: without the exception of Java."""
        rest = {name: value for name, value in self.__dict__.items() if name != "java"}
        return type(self), self.args, rest


class JavaError(DaphnisError, RuntimeError):
    """Java is missing, too old, does not start, or has no memory left."""


class InputError(DaphnisError, ValueError):
    """The input is wrong: one line names the file or argument, the key, the value and what would be right."""


class ArgumentTypeError(InputError, TypeError):
    """An argument is of another type than it may be, or there is none of its name."""


class FormatError(DaphnisError, ValueError):
    """A file is damaged, or does not agree with its format."""


class RunError(DaphnisError, RuntimeError):
    """A run or a step failed. A step is as if it had not begun; a run goes on from its last checkpoint."""


class DaphnisWarning(UserWarning):
    """What a user should know about a run or a file, in one line."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended a run after its step, with a checkpoint.

    Attributes:
        path: its directory, for ``daphnis.resume``.
    """

    def __init__(self, message: str, path: Any) -> None:
        super().__init__(message)
        self.path = path

    def __reduce__(self) -> Any:
        return type(self), (*self.args, self.path)


def noted(notices: list[str]) -> None:
    """Warns of each of `notices`, at the line outside of this package that called it."""
    depth = 1
    frame = sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").startswith("daphnis_sim."):
        frame, depth = frame.f_back, depth + 1  # type: ignore[assignment]
    for notice in notices:
        warnings.warn(notice, DaphnisWarning, stacklevel=depth)


class PythonFailure:
    """The first exception of a Python function that Java called in a step, to come out of the call as it is."""

    def __init__(self) -> None:
        self.error: BaseException | None = None

    def keep(self, error: BaseException) -> None:
        if self.error is None:
            self.error = error

    def forget(self) -> None:
        """A step ended well, whatever was tried on the way."""
        self.error = None


_MOST_CAUSES = 1000
"""Causes may be a circle."""

_ARGUMENTS = {"settings": "set", "from": "from_"}
_WAYS_OUT = {
    "ANOTHER_DIRECTORY": "give another directory with out=",
    "REPLACE_RUN": "give another directory with out=, or force=True to replace the run in it",
    "ONLY_RUNS_ARE_REPLACED": "force=True replaces runs only",
    "RESUME_WITH_LOSS": "bring the file back, or continue with what is there: accept_loss=True",
    "BEGIN_ANEW": "bring one back, or run it again from its start: accept_loss=True",
    "ANALYSE_WITH_LOSS": "bring it back, or accept what is there: accept_loss=True",
    "WRITE_SNAPSHOTS": 'run with set={"output.snapshotEvery": 10}, for example',
}


@contextmanager
def translated(failure: PythonFailure | None = None) -> Iterator[None]:
    """Passes exceptions of Java on as those of Python, and those of Python functions in `failure` as they are."""
    if failure is not None:
        failure.forget()
    try:
        yield
    except jpype.JException as e:
        # What Java wrapped on its way. Its own failures stay its own, whatever a function did before.
        if failure is not None and failure.error is not None and _is_of_python(e):
            raise failure.error from None
        raise of(e) from None
    finally:
        if failure is not None:
            failure.forget()


def _is_of_python(e: Any) -> bool:
    """Whether an exception of Python is among the causes of the Java exception `e`."""
    left, seen = [e], 0
    while left and seen < _MOST_CAUSES:
        one = left.pop()
        seen += 1
        if str(one.getClass().getName()) == "org.jpype.PyExceptionProxy":
            return True
        left += [other for other in (*one.getSuppressed(), one.getCause()) if other is not None]
    return False


def of(e: Any) -> DaphnisError:
    """The exception for the Java exception `e`."""
    name = str(e.getClass().getName())
    message = str(e.getMessage() or "")
    error: DaphnisError
    if name == "daphnis.core.input.InputException":
        error = InputError(_in_words(e))
    elif name == "daphnis.core.format.FormatException":
        error = FormatError(message)
    elif name.startswith("daphnis."):
        error = RunError(message)
    elif name == "java.lang.IllegalArgumentException":
        error = InputError(message)
    elif name == "java.nio.file.InvalidPathException":
        error = InputError(f"{e.getInput()}: cannot be a path here: {e.getReason()}")
    elif name == "java.lang.IllegalStateException":
        error = RunError(message)
    elif name == "java.lang.OutOfMemoryError":
        error = JavaError("Java has not enough memory; raise it with daphnis.start('-Xmx…') or JAVA_OPTS=-Xmx…")
    elif name == "java.lang.NoClassDefFoundError" and message.startswith(
        ("org/apache/pekko/", "com/typesafe/", "scala/")
    ):
        error = InputError("the package for Python has no Pekko; any other engine gives the same bits")
    elif isinstance(e, jpype.JClass("java.io.IOException")):
        error = RunError(f"{_last(name)}: {message}")
    else:
        error = RunError(
            f"unexpected {_last(name)}: {message}; this is a fault of daphnis, .java.stacktrace() says where"
        )
    # Numbers as they are typed in Python: 1e12, not 1.0E12.
    text = re.sub(r"(?<![\w.])(\d+(?:\.\d*[1-9])?)(?:\.0)?E(-?\d+)\b", r"\1e\2", str(error))
    error.args = (" ".join(text.split("\n")),)
    error.java = e
    return error


def _in_words(e: Any) -> str:
    """The message with the names that arguments have in Python."""
    source = str(e.getSource())
    if e.isArgument():
        source = _ARGUMENTS.get(source, re.sub("[A-Z]", lambda letter: "_" + letter.group().lower(), source))
    way_out = e.getWayOut()
    return str(
        e.message(source, None if way_out is None else _WAYS_OUT.get(str(way_out.name()), str(way_out.getWords())))
    )


def _last(name: str) -> str:
    return name.rsplit(".", 1)[-1]
