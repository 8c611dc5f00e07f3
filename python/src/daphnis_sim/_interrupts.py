"""Ctrl-C, and polite kills, while Java computes."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import threading
from typing import Any

from ._errors import Interrupted, PythonFailure


class CtrlC:
    """Notes Ctrl-C instead of raising it, so that a step under way, and what is behind it in Java, ends well.

    An exception could come up in any line of Python that Java calls, also beside a law, where Java would take it for
    a fault and its kind would be lost. The second Ctrl-C raises KeyboardInterrupt all the same, for functions of Python
    which do not end; it is kept in `failure`, so that it comes out of Java as it is.

    Signals reach the main thread only. In another thread it counts as pressed when a Ctrl-C that nobody caught has
    ended the main one, and Python waits for the others. A handler that ignores Ctrl-C stays, and so does
    one that was not installed from Python, since Python could not put it back. With `any_handler` those of others
    make way meanwhile, otherwise only Python's own does.
    """

    def __init__(self, failure: PythonFailure, any_handler: bool) -> None:
        self._noted = False
        self._failure = failure
        self._any_handler = any_handler
        self._before: Any = None

    @property
    def pressed(self) -> bool:
        return self._noted or (not _in_main_thread() and _ended_by_ctrl_c())

    def __enter__(self) -> CtrlC:
        if _in_main_thread():
            before = signal.getsignal(signal.SIGINT)
            if before is signal.default_int_handler or (self._any_handler and callable(before)):
                signal.signal(signal.SIGINT, self._note)
                self._before = before
        return self

    def __exit__(self, *_: object) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
            self._before = None

    def _note(self, *_: object) -> None:
        if self._noted:
            again = KeyboardInterrupt()
            self._failure.keep(again)
            raise again
        self._noted = True


def _in_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def _ended_by_ctrl_c() -> bool:
    """Whether a Ctrl-C that nobody caught has ended the program; at a prompt there is always a next line."""
    if hasattr(sys, "ps1") or sys.flags.interactive:
        return False
    last = getattr(sys, "last_type", None)
    return isinstance(last, type) and issubclass(last, KeyboardInterrupt)


def end_by_signal() -> None:
    """Lets a program that an `Interrupted` ends, which nobody caught, end by SIGINT, so that a loop of a shell ends too.

    Python does so for a KeyboardInterrupt itself only, not for its kinds: it looks at what runs at its top level.
    """
    before = sys.excepthook

    def hook(kind: Any, error: Any, trace: Any) -> None:
        before(kind, error, trace)
        if issubclass(kind, Interrupted) and _ended_by_ctrl_c():
            try:
                ctypes.pythonapi.PyRun_String.restype = ctypes.py_object
                names: Any = ctypes.py_object({})
                ctypes.pythonapi.PyRun_String(b"raise KeyboardInterrupt", _FILE_INPUT, names, names)
            except (AttributeError, KeyboardInterrupt):
                pass

    sys.excepthook = hook


_FILE_INPUT = 257
"""``Py_file_input``: statements."""


class Termination:
    """Lets a run end with a checkpoint when the process is asked to end: by SIGTERM, or by SIGHUP of a closed terminal.

    Where nobody handles the signal it is noted, the run ends after its step, and then the process ends by that signal,
    as it would have at once; the second one ends it at once. A handler of the program itself is called between two
    steps: the run goes on after it, and ends with a checkpoint if it raises, which then comes out of the run. What is
    ignored stays so, and so does a handler that was not installed from Python. Signals reach the main thread only.
    """

    def __init__(self) -> None:
        self.signal: signal.Signals | None = None
        """By which the process is to end; None unless that was asked for and nobody handles it."""
        self._before: dict[int, Any] = {}
        self._pending: list[int] = []
        self._raised: BaseException | None = None

    def __enter__(self) -> Termination:
        if _in_main_thread():
            for number in (signal.SIGTERM, getattr(signal, "SIGHUP", None)):
                before = None if number is None else signal.getsignal(number)
                if number is not None and (before is signal.SIG_DFL or callable(before)):
                    self._before[number] = before
                    signal.signal(number, self._note)
        return self

    def __exit__(self, *_: object) -> None:
        for number, before in self._before.items():
            signal.signal(number, before)
        if self.signal is not None:
            self._end(self.signal)
        self.asked()
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised

    def asked(self) -> bool:
        """Whether the run is to end; calls the handlers of signals that came since. Between two steps only."""
        while self._pending and self._raised is None:
            number = self._pending.pop(0)
            try:
                self._before[number](number, sys._getframe())
            except BaseException as e:
                self._raised = e
        return self.signal is not None or self._raised is not None

    def _note(self, number: int, frame: object) -> None:
        if callable(self._before[number]):
            self._pending.append(number)
        elif self.signal is not None:
            self._end(self.signal)
        else:
            self.signal = signal.Signals(number)

    def _end(self, number: signal.Signals) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)
