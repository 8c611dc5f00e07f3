"""Runs that are started, and runs that go on."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Union

import jpype

from . import laws
from ._arguments import checked
from ._errors import InputError, PythonFailure, translated
from ._execution import Watch, carried_out
from ._jvm import java, java_path
from ._resuming import resumed
from .laws import BothLaw, Force, Law, Surface
from .program import Program, engines, fitted
from .runs import Run
from .scenarios import Scenario, ScenarioLike, Settings
from .scenarios import scenario as as_scenario
from .states import State

Origin = Union[Run, State, str, "os.PathLike[str]"]


@checked
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
    roughness: Surface | None = None,
    contact_law: BothLaw | None = None,
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
        engine: "horizon", "islands", "thread-pool", "serial" or "actors"; all give the same bits.
        threads: of the engine; one per core without it.
        from_: a state from which to start: a `State` of a run, or a `Run` or its path for its last.
        force: whether a run that is in the directory is replaced.
        restitution: a law of Python in place of the scenario's, see `daphnis.restitution`. The scenario's guard holds;
            one without a guard gets a ``floor-speed`` of 1e-6 initial rms speeds.
        roughness: a law of Python in place of the scenario's, see `daphnis.roughness`.
        contact_law: one for both coefficients, see `daphnis.contact_law`; guards are as for `restitution`.
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
    given = laws.as_laws(restitution, roughness, contact_law)
    origin = None if from_ is None else _origin(from_)
    if origin is not None:
        _check_state(set, seed, origin)
    if scenario is None:
        scenario = "paper-figure-1" if origin is None else _scenario_of(origin)
    settings = dict(set or {})
    for key, value in (("engine.name", engine), ("engine.threads", threads), ("until", until)):
        if value is not None:
            settings[key] = value
    if steps is not None:
        settings["until"] = _end(scenario, settings, steps, origin)
    settings = fitted(scenario, settings, given)
    asked = as_scenario(scenario, set=settings, seed=seed)
    directory = _free(asked.name) if out is None else Path(out)
    if not given and not forces:
        if origin is not None:
            _check_end(asked, origin, until is not None or steps is not None)

        def start() -> Any:
            return java("daphnis.core.run.Run").start(
                asked.java, asked.source, java_path(directory), force, engines(), java("java.util.HashMap")(), origin
            )

        return _carried(start, directory, PythonFailure(), watch, progress)
    if origin is not None:
        raise InputError("from_: a run with laws or forces of Python starts from its scenario; give placement a file")
    failure = PythonFailure()
    program = Program(asked, given, forces, failure)
    return _carried(
        lambda: java("daphnis.core.run.Run").start(program.proxy(), java_path(directory), force),
        directory,
        failure,
        watch,
        progress,
    )


@checked
def resume(
    path: str | os.PathLike[str],
    scenario: ScenarioLike | None = None,
    *,
    set: Settings | None = None,
    until: float | None = None,
    accept_loss: bool = False,
    restitution: Law | None = None,
    roughness: Surface | None = None,
    contact_law: BothLaw | None = None,
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
        restitution: as at the start. Another law is refused: the run knows the code of its functions.
        roughness: as `restitution`.
        contact_law: as `restitution`.
        forces: as `restitution`.
        watch: as for `run`.
        progress: as for `run`.

    Raises:
        InputError: there is no run, or nothing to go on from, or it would be another run.
        RunError: as for `run`.
        Interrupted: after Ctrl-C.
    """
    given = dict(locals())
    return Run(path, resumed(**given))


def _carried(
    start: Callable[[], Any],
    directory: Path,
    failure: PythonFailure,
    watch: Watch | None,
    progress: bool | None,
) -> Run:
    """The run that `start` makes, carried out."""
    return Run(directory, carried_out(start, directory, failure, watch, progress))


def _origin(origin: Origin) -> Any:
    """The ``RunOrigin`` of a state."""
    if isinstance(origin, (str, os.PathLike)):
        origin = Run(origin)
    if isinstance(origin, Run):
        origin = origin.last()
    if origin.run is None:
        raise InputError("from_: is a state of no run directory; a Simulation takes its arrays")
    return java("daphnis.core.run.RunOrigin")(origin.run.java, origin.java)


def _check_state(set: Settings | None, seed: int | None, origin: Any) -> None:
    """What makes an initial state has no meaning when that is of another run."""
    if seed is not None:
        raise InputError("seed: is of an initial state; with from_ it is that of the other run")
    for key in set or {}:
        if origin.isOfState(key):
            raise InputError(f"set: {key}: is of an initial state; with from_ it is that of the other run")


def _scenario_of(origin: Any) -> Scenario:
    found = origin.getRun().scenario()
    if found is None:
        raise InputError(f"from_: {origin.getName()} has no scenario; give one for the new run")
    return Scenario(found, f"{origin.getName()}/scenario.json")


def _end(scenario: ScenarioLike, settings: dict[str, Any], steps: int, origin: Any) -> float:
    """The time after `steps` steps."""
    if isinstance(steps, bool) or not isinstance(steps, int) or steps < 1:
        raise InputError(f"steps: is {steps!r}; it must be a whole number of at least 1")
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
