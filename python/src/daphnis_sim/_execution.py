"""What happens beside a run: Ctrl-C, kills, progress, and a function that watches it."""

from __future__ import annotations

import sys
import time as clock
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jpype

from ._errors import Interrupted, PythonFailure, noted, translated
from ._interrupts import CtrlC, Termination
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
    # From here on, since a run whose start is torn would never be closed.
    with Termination() as termination, CtrlC(failure, any_handler=True) as ctrl_c:
        with translated(failure):
            carried = start()
        notices = [str(notice) for notice in carried.getNotices()]
        try:
            noted(notices)
            execution = _Execution(carried, watch, progress, failure, ctrl_c, termination)
            with execution, translated(failure):
                summary = carried.execute(execution.watcher(), execution.cancelled())
        finally:
            carried.close()
        if termination.signal is not None:
            end = "at its end" if summary.getFinished() else f"after step {summary.getSteps()}"
            way_on = "" if summary.getFinished() else f"; continue with: daphnis.resume({str(directory)!r})"
            print(f"daphnis: ended by {termination.signal.name} {end}{way_on}", file=sys.stderr)
    if ctrl_c.pressed:
        if summary.getFinished():
            raise Interrupted("interrupted at the end: the run is complete, there is nothing to resume", directory)
        way_on = f"continue with: daphnis.resume({str(directory)!r})"
        raise Interrupted(f"interrupted after step {summary.getSteps()}; {way_on}", directory)
    return notices


class _Execution:
    """What happens beside a run: Ctrl-C and kills ask it to end after its step, and progress is shown."""

    def __init__(
        self,
        run: Any,
        watch: Watch | None,
        progress: bool | None,
        failure: PythonFailure,
        ctrl_c: CtrlC,
        termination: Termination,
    ) -> None:
        self._ended = False
        self._run = run
        self._watch = watch
        self._progress = sys.stderr.isatty() if progress is None else progress
        self._shown = 0.0
        self._failure = failure
        self._ctrl_c = ctrl_c
        self._termination = termination

    def __enter__(self) -> None:
        return None

    def __exit__(self, *_: object) -> None:
        if self._progress and self._shown:
            print(file=sys.stderr)

    def cancelled(self) -> Any:
        """Asked before each step."""

        def get_as_boolean() -> bool:
            try:
                if self._progress:
                    self._show()
                return self._termination.asked() or self._ctrl_c.pressed or self._ended
            except BaseException as e:
                self._failure.keep(e)
                raise

        return jpype.JProxy("java.util.function.BooleanSupplier", dict={"getAsBoolean": get_as_boolean})

    def watcher(self) -> Any:
        """Called after each step."""
        watch = self._watch
        simulation = Simulation._watched(self._run.getSimulation())

        def write(_: Any) -> None:
            # The step stands.
            self._failure.forget()
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
