"""Ctrl-C while Java computes."""

from __future__ import annotations

import signal
import threading
from typing import Any

from ._errors import PythonFailure


class CtrlC:
    """Notes Ctrl-C instead of raising it, so that a step under way, and what is behind it in Java, ends well.

    An exception could come up in any line of Python that Java calls, also beside a law, where Java would take it for
    a fault and its kind would be lost. The second Ctrl-C raises KeyboardInterrupt all the same, for functions of Python
    which do not end; it is kept in `failure`, so that it comes out of Java as it is.

    Signals reach the main thread only, so elsewhere nothing is noted. A handler that ignores Ctrl-C stays, and so does
    one that was not installed from Python, since Python could not put it back. With `any_handler` those of others
    make way meanwhile, otherwise only Python's own does.
    """

    def __init__(self, failure: PythonFailure, any_handler: bool) -> None:
        self.pressed = False
        self._failure = failure
        self._any_handler = any_handler
        self._before: Any = None

    def __enter__(self) -> CtrlC:
        if threading.current_thread() is threading.main_thread():
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
        if self.pressed:
            again = KeyboardInterrupt()
            self._failure.keep(again)
            raise again
        self.pressed = True
