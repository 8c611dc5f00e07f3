"""Runs: simulations in a directory, with tables and states."""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time as clock
from pathlib import Path
from typing import Any, Callable, Sequence, Union

import jpype
import pandas as pd

from . import laws, report
from ._errors import FormatError, InputError, Interrupted, PythonFailure, translated
from ._jvm import java
from .laws import Force, Law
from .program import Program, engines
from .report import Report, analyze
from .scenarios import Scenario, ScenarioLike, Settings, scenario as as_scenario
from .simulation import Simulation
from .states import State, States
from .tables import Tables, read_table

Origin = Union["Run", State, str, "os.PathLike[str]"]
Watch = Callable[[Simulation], object]

_OF_STATE = ("seed", "particles", "bodies", "placement", "velocities")


class Run:
    """A run in its directory, finished or still going on. Made by `run`, `resume` and `open`.

    Everything is read when it is asked for, and of a run that goes on it is what is there then.

    Attributes:
        path: the run directory.
        notices: what a user should know about its start, a line each.
    """

    def __init__(self, path: str | os.PathLike[str], notices: Sequence[str] = ()) -> None:
        self.path = Path(path)
        self.notices = list(notices)
        with translated():
            self._java = java("daphnis.core.run.Run").open(java("java.nio.file.Path").of(str(self.path)))
            found = self._java.scenario()
        self._scenario = None if found is None else Scenario(found, str(self.path / "scenario.json"))

    @property
    def java(self) -> Any:
        """The ``daphnis.core.run.RecordedRun``."""
        return self._java

    @property
    def scenario(self) -> Scenario | None:
        """The scenario that is run; None if laws or forces of Python took part, which no scenario knows."""
        return self._scenario

    @property
    def units(self) -> Any:
        """Names of the units of the scenario; None without one."""
        return None if self._scenario is None else self._scenario.units

    @property
    def summary(self) -> dict[str, Any] | None:
        """The entries of ``summary.json``, see docs/guide.md; None while the run has none.

        ``run.summary["stateDigest"]`` is the same for equal bits of all states.
        """
        path = self.path / "summary.json"
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return None
        except (OSError, ValueError) as e:
            raise FormatError(f"{path}: is not a summary of daphnis: {e}") from None
        if not isinstance(found, dict):
            raise FormatError(f"{path}: is not a summary of daphnis")
        return found

    @property
    def series(self) -> pd.DataFrame:
        """``series.csv``: a row every ``output.seriesEvery`` steps; units in ``attrs["units"]``, see docs/guide.md."""
        return self._table("series.csv", "output.seriesEvery")

    @property
    def transport(self) -> pd.DataFrame:
        """``transport.csv``: moments and sums for viscosities, a row every ``output.transportEvery`` steps."""
        return self._table("transport.csv", "output.transportEvery")

    @property
    def impacts(self) -> pd.DataFrame:
        """``impacts.csv``: the distribution of impact speeds since the start."""
        return self._table("impacts.csv", "output.transportEvery")

    @property
    def collisions(self) -> pd.DataFrame:
        """``collisions.csv``: a row for each collision of two spheres."""
        return self._table("collisions.csv", "output.collisionLog")

    def _table(self, name: str, key: str) -> pd.DataFrame:
        path = self.path / name
        if not path.is_file():
            raise InputError(f"{self.path}: has no {name}; run with {key} in set=")
        units = self.units
        return read_table(path, None if units is None else units.of)

    @property
    def tables(self) -> Tables:
        """The tables that `analyze` wrote, by name."""
        return Tables(self.path / "tables")

    @property
    def steps(self) -> list[int]:
        """Steps after which there is a state, ascending."""
        with translated():
            return [int(step) for step in self._java.steps()]

    def states(self) -> States:
        """All states in the order of time, each read when the iteration comes to it; ``states()[-1]`` is the last."""
        return States(self)

    def at(self, time: float | None = None, *, orbits: float | None = None) -> State:
        """The state at `time`, in units of time, or after a number of `orbits`; round-off of 1e-9 is allowed.

        Raises:
            InputError: there is none; the message names those next to it.
        """
        if (time is None) == (orbits is None):
            raise InputError("at: needs one of time and orbits")
        if time is None:
            orbit = None if self._scenario is None else self._scenario.orbit
            if orbit is None or orbits is None:
                raise InputError(f"{self.path}: orbits need a run in Hill's frame; give a time")
            time = orbits * orbit
        with translated():
            return State(self._java.at(float(time)), self.units, self)

    def at_step(self, step: int) -> State:
        """The state after `step` steps. Raises InputError if there is none."""
        with translated():
            return State(self._java.atStep(int(step)), self.units, self)

    def last(self) -> State:
        """The latest state. Raises InputError if there is none."""
        with translated():
            return State(self._java.last(), self.units, self)

    def analyze(self, **options: Any) -> Report:
        """`daphnis.analyze` of this run, with its options."""
        return analyze(self, **options)

    @property
    def report(self) -> Report:
        """What `analyze` wrote before."""
        if not (self.path / "report.html").is_file():
            raise InputError(f"{self.path}: has no report yet; analyze() writes it")
        return report.Report(self.path, [])

    def resume(self, **options: Any) -> "Run":
        """`daphnis.resume` of this run, with its options."""
        return resume(self.path, **options)

    def _repr_html_(self) -> str:
        entries = self.summary or {}
        shown = {name: entries[name] for name in ("scenario", "particles", "steps", "time", "collisions") if name in entries}
        table = pd.DataFrame({"": {"directory": str(self.path), "finished": entries.get("finished", False), **shown}})
        return str(table.to_html(header=False))

    def __repr__(self) -> str:
        return f"<Run {str(self.path)!r}>"


def open(path: str | os.PathLike[str]) -> Run:
    """The run in the directory `path`, finished or still going on. Raises InputError if there is none."""
    return Run(path)


def run(
    scenario: ScenarioLike | None = None,
    out: str | os.PathLike[str] | None = None,
    *,
    set: Settings | None = None,
    seed: int | None = None,
    until: float | None = None,
    steps: int | None = None,
    engine: str | None = None,
    threads: int | None = None,
    from_: Origin | None = None,
    force: bool = False,
    restitution: Law | None = None,
    forces: Sequence[Force] = (),
    watch: Watch | None = None,
    progress: bool | None = None,
) -> Run:
    """Simulates a scenario into a run directory, as ``daphnis run`` does, and gives the run.

    Ctrl-C, or an interrupt of a notebook's kernel, ends it after the current step with a checkpoint and raises
    `Interrupted`; `resume` goes on to the same bits.

    Args:
        scenario: as for `daphnis.scenario`; with `from_` it may be left out for that of the other run.
        out: the run directory; without it ``runs/NAME``, numbered if that exists.
        set: values for keys of the scenario: ``{"particles.opticalDepth": 0.5}``.
        seed: of the initial state.
        until: end at this time, in units of time.
        steps: end after this many steps, instead of `until`.
        engine: "horizon", "islands", "bricks", "thread-pool", "serial", "actors" or "pekko"; all give the same bits.
        threads: of the engine; one per core without it.
        from_: a state from which to start: a `State` of a run, or a `Run` or its path for its last.
        force: whether a run that is in the directory is replaced.
        restitution: a law of Python in place of the scenario's, see `daphnis.restitution`. The scenario's guard holds;
            one without a guard gets a ``floor-speed`` of 1e-6 initial rms speeds.
        forces: forces of Python beside the scenario's.
        watch: called with the `Simulation` after each step; it must not be advanced. True from it ends the run with a
            checkpoint.
        progress: whether a line on the error stream shows the time; without it, on a terminal only.

    Raises:
        InputError: something above is wrong; a directory that holds a run is as it was.
        RunError: the simulation failed, or a file could not be written; the last checkpoint stays.
        Interrupted: after Ctrl-C.
    """
    if until is not None and steps is not None:
        raise InputError("steps: is given together with until; one of the two is enough")
    law = laws.as_law(restitution)
    kicks = laws.as_forces(forces)
    origin = None if from_ is None else _origin(from_)
    if origin is not None:
        _check_state(set, seed)
    if scenario is None:
        scenario = "paper-figure-1" if origin is None else _scenario_of(origin)
    settings = dict(set or {})
    for key, value in (("engine.name", engine), ("engine.threads", threads), ("until", until)):
        if value is not None:
            settings[key] = value
    if steps is not None:
        settings["until"] = _end(scenario, settings, steps, origin)
    if law is not None and not as_scenario(scenario, set=settings).to_dict().get("guard"):
        settings["guard"] = {"type": "floor-speed", "relative": 1e-6}
    asked = as_scenario(scenario, set=settings, seed=seed)
    directory = _free(asked.name) if out is None else Path(out)
    if law is None and not kicks:
        if origin is not None:
            _check_end(asked, origin, until is not None or steps is not None)

        def start() -> Any:
            return java("daphnis.core.run.Run").start(
                asked.java, asked.source, _path(directory), force, engines(), java("java.util.HashMap")(), origin
            )

        return _carried_out(start, directory, PythonFailure(), watch, progress)
    if origin is not None:
        raise InputError("from_: a run with laws or forces of Python starts from its scenario; give placement a file")
    failure = PythonFailure()
    program = Program(asked, law, kicks, failure)
    return _carried_out(
        lambda: java("daphnis.core.run.Run").start(program.proxy(), _path(directory), force),
        directory, failure, watch, progress, program,
    )


def resume(
    path: str | os.PathLike[str],
    scenario: ScenarioLike | None = None,
    *,
    set: Settings | None = None,
    until: float | None = None,
    accept_loss: bool = False,
    restitution: Law | None = None,
    forces: Sequence[Force] = (),
    watch: Watch | None = None,
    progress: bool | None = None,
) -> Run:
    """Continues the run in `path` from its last checkpoint, to the bits of an uninterrupted one.

    Args:
        path: the run directory.
        scenario: of a run with laws or forces of Python, the same as at its start, with the same `set`; the directory
            of any other run has it.
        set: see `scenario`.
        until: a new end, in units of time.
        accept_loss: whether it goes on with damaged tables as they are; ``notices`` tell what is lost.
        restitution: as at the start. Another law is refused: a checkpoint knows the source of its functions.
        forces: as `restitution`.
        watch: as for `run`.
        progress: as for `run`.

    Raises:
        InputError: there is no run, or nothing to go on from, or it would be another run.
        RunError: as for `run`.
        Interrupted: after Ctrl-C.
    """
    directory = Path(path)
    law = laws.as_law(restitution)
    kicks = laws.as_forces(forces)
    if law is None and not kicks:
        if scenario is not None or set is not None:
            raise InputError("scenario: is for runs with laws or forces of Python; others have theirs")

        def start() -> Any:
            end = None if until is None else java("java.lang.Double")(until)
            return java("daphnis.core.run.Run").resume(_path(directory), end, engines(), accept_loss)

        return _carried_out(start, directory, PythonFailure(), watch, progress)
    if scenario is None:
        raise InputError("scenario: is missing; a run with laws or forces of Python is resumed with its scenario")
    settings = dict(set or {})
    if law is not None and not as_scenario(scenario, set=settings).to_dict().get("guard"):
        settings["guard"] = {"type": "floor-speed", "relative": 1e-6}
    failure = PythonFailure()
    program = Program(as_scenario(scenario, set=settings), law, kicks, failure, until)
    return _carried_out(
        lambda: java("daphnis.core.run.Run").resume(program.proxy(), _path(directory), accept_loss),
        directory, failure, watch, progress, program,
    )


def _carried_out(
    start: Callable[[], Any],
    directory: Path,
    failure: PythonFailure,
    watch: Watch | None,
    progress: bool | None,
    program: Program | None = None,
) -> Run:
    """Carries out what `start` makes."""
    with translated(failure):
        carried = start()
    try:
        execution = _Execution(carried, watch, progress, failure)
        with execution, translated(failure):
            summary = carried.execute(execution.watcher(), execution.cancelled())
        notices = [str(notice) for notice in carried.getNotices()]
        if execution.interrupted:
            if summary.getFinished():
                raise Interrupted("interrupted at the end: the run is complete, there is nothing to resume", directory)
            way_on = f"continue with: daphnis.resume({str(directory)!r})"
            raise Interrupted(f"interrupted after step {summary.getSteps()}; {way_on}", directory)
    finally:
        carried.close()
    return Run(directory, notices)


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
        watch = self._watch
        simulation = None if watch is None else Simulation._watched(self._run.getSimulation())

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


def _path(path: Path) -> Any:
    return java("java.nio.file.Path").of(str(path))


def _origin(origin: Origin) -> Any:
    """The ``RunOrigin`` of a state."""
    if isinstance(origin, (str, os.PathLike)):
        origin = Run(origin)
    if isinstance(origin, Run):
        origin = origin.last()
    if not isinstance(origin, State):
        raise InputError(f"from_: is {origin!r}; it must be a State, a Run or the path of one")
    if origin.run is None:
        raise InputError("from_: is a state of no run directory; a Simulation takes its arrays")
    return java("daphnis.core.run.RunOrigin")(origin.run.java, origin.java)


def _check_state(set: Settings | None, seed: int | None) -> None:
    """What makes an initial state has no meaning when that is of another run."""
    if seed is not None:
        raise InputError("seed: is of an initial state; with from_ it is that of the other run")
    for key in set or {}:
        if key.split(".")[0].split("[")[0] in _OF_STATE:
            raise InputError(f"set: {key}: is of an initial state; with from_ it is that of the other run")


def _scenario_of(origin: Any) -> Scenario:
    found = origin.getRun().scenario()
    if found is None:
        raise InputError(f"from_: {origin.getName()} has no scenario; give one for the new run")
    return Scenario(found, f"{origin.getName()}/scenario.json")


def _end(scenario: ScenarioLike, settings: dict[str, Any], steps: int, origin: Any) -> float:
    """The time after `steps` steps."""
    if isinstance(steps, bool) or not isinstance(steps, int) or steps < 1:
        raise InputError(f"steps: is {steps!r}; it must be a whole number >= 1")
    found = as_scenario(scenario, set={**{k: v for k, v in settings.items() if k != "untilOrbits"}, "until": 1.0})
    with translated():
        step = java("daphnis.core.scenario.FrameSetup").times(found.java, found.source).getTimeStep()
    if not isinstance(step, jpype.JClass("daphnis.core.scenario.TimeStepSpec$Fixed")):
        raise InputError("steps: need a fixed time step; give until")
    start = found.java.getStartTime() if origin is None else origin.getState().getTime()
    return float(start + steps * step.getDt())


def _check_end(scenario: Scenario, origin: Any, given: bool) -> None:
    """A state of the end of a run, which is the usual one, leaves nothing to do."""
    start = origin.getState().getTime()
    with translated():
        end = java("daphnis.core.scenario.FrameSetup").times(scenario.java, scenario.source).getEnd()
    if not given and end <= start:
        raise InputError(f"from_: is at time {start}, and the run would end at {end}; give steps or until")


def _free(name: str) -> Path:
    """``runs/NAME``, or the first of NAME-2, NAME-3, … that does not exist."""
    letters = "".join(c if c.isalnum() or c in "-_." else "-" for c in name).strip(".")[:80] or "run"
    path, k = Path("runs") / letters, 1
    while path.exists():
        k += 1
        path = Path("runs") / f"{letters}-{k}"
    return path
