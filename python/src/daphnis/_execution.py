"""What happens beside a run: Ctrl-C, progress, and a function that watches it."""

from __future__ import annotations

import signal
import sys
import threading
import time as clock
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jpype

from ._errors import Interrupted, PythonFailure, noted, translated
from .simulation import Simulation

Watch = Callable[[Simulation], object]
"""Called with the simulation of a run after each step; True ends the run with a checkpoint."""


def carried_out(
    start: Callable[[], Any],
    directory: Path,
    failure: PythonFailure,
    watch: Watch | None,
    progress: bool | None,
) -> list[str]:
    """Carries out the ``daphnis.core.run.Run`` that `start` makes, and gives its notices."""
    with translated(failure):
        carried = start()
    notices = [str(notice) for notice in carried.getNotices()]
    try:
        noted(notices)
        execution = _Execution(carried, watch, progress, failure)
        with execution, translated(failure):
            summary = carried.execute(execution.watcher(), execution.cancelled())
        if execution.interrupted:
            if summary.getFinished():
                raise Interrupted("interrupted at the end: the run is complete, there is nothing to resume", directory)
            way_on = f"continue with: daphnis.resume({str(directory)!r})"
            raise Interrupted(f"interrupted after step {summary.getSteps()}; {way_on}", directory)
    finally:
        carried.close()
    return notices


class _Execution:
    """What happens beside a run: Ctrl-C asks it to end after its step, and progress is shown."""

    def __init__(self, run: Any, watch: Watch | None, progress: bool | None, failure: PythonFailure) -> None:
        self.interrupted = False
        self._ended = False
        self._run = run
        self._watch = watch
        self._progress = sys.stderr.isatty() if progress is None else progress
        self._shown = 0.0
        self._failure = failure
        self._before: Any = None

    def __enter__(self) -> None:
        # Signals reach the main thread only; elsewhere Ctrl-C is not ours.
        if threading.current_thread() is threading.main_thread():
            self._before = signal.getsignal(signal.SIGINT)
            signal.signal(signal.SIGINT, self._interrupt)

    def __exit__(self, *_: object) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
        if self._progress and self._shown:
            print(file=sys.stderr)

    def _interrupt(self, *_: object) -> None:
        self.interrupted = True

    def cancelled(self) -> Any:
        """Asked before each step."""

        def get_as_boolean() -> bool:
            try:
                if self._progress:
                    self._show()
                return self.interrupted or self._ended
            except BaseException as e:
                self._failure.keep(e)
                raise

        return jpype.JProxy("java.util.function.BooleanSupplier", dict={"getAsBoolean": get_as_boolean})

    def watcher(self) -> Any:
        """Called after each step."""
        watch = self._watch
        simulation = Simulation._watched(self._run.getSimulation())

        def write(_: Any) -> None:
            try:
                if watch is not None and watch(simulation) is True:
                    self._ended = True
            except BaseException as e:
                self._failure.keep(e)
                raise

        # JPype calls no default method that has arguments, so each is there.
        nothing = dict.fromkeys(("open", "finish", "save", "restore", "close"), lambda *_: None)
        return jpype.JProxy("daphnis.core.Output", dict={"write": write, **nothing})

    def _show(self) -> None:
        now = clock.monotonic()
        if now - self._shown < 0.5:
            return
        self._shown = now
        simulation = self._run.getSimulation()
        text = f"time {simulation.getTime():.6g} of {self._run.getUntil():.6g}, step {simulation.getStep()}"
        print(f"\rdaphnis: {text}", end="", file=sys.stderr, flush=True)
