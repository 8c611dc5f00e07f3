"""Sweeps: a scenario for many values and seeds, whose runs any executor can carry out, on any machine."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from ._arguments import checked
from ._errors import DaphnisError, InputError, Interrupted, noted, translated
from ._jvm import java, java_path
from ._paths import shown_path
from .runs import Run
from .scenarios import ScenarioLike
from .scenarios import scenario as as_scenario
from .starting import resume, run


@dataclass(frozen=True, repr=False)
class Task:
    """A run of a sweep, not yet made, or begun, or finished. It can be pickled, without Java.

    Attributes:
        name: of the run, different from all others of the sweep.
        path: its run directory.
        scenario: as JSON, with the values and the seed of this run.
        source: what messages call the scenario.
        threads: of its engine.
    """

    name: str
    path: str
    scenario: str
    source: str
    threads: int = 1

    def run(self, progress: bool | None = None) -> Run:
        """Makes the run, or goes on with it where it was begun; a finished one is left as it is.

        Raises:
            InputError, RunError, Interrupted: as `daphnis.run`; another process that makes this run is an InputError.
        """
        if (Path(self.path) / "scenario.json").exists():
            found = Run(self.path)
            return found if found.finished else resume(self.path, progress=progress)
        return run(json.loads(self.scenario), self.path, threads=self.threads, progress=progress)

    def __repr__(self) -> str:
        return f"<Task {self.name!r}>"


@dataclass(frozen=True, repr=False)
class Outcome:
    """What has come of a task. It can be pickled, without Java.

    Attributes:
        name: of the run.
        path: its run directory.
        finished: whether it has come to its end.
        digest: of its last state, where it is finished.
        failure: why it is not, in a line.
    """

    name: str
    path: str
    finished: bool
    digest: str | None = None
    failure: str | None = None

    def __repr__(self) -> str:
        how = "finished" if self.finished else "not finished" if self.failure is None else "failed"
        return f"<Outcome {self.name!r} {how}>"


class Sweep:
    """A sweep whose tables were made, by `collect`.

    Attributes:
        path: its directory.
        notices: runs that are missing, failed or of another sweep, a line each.
    """

    def __init__(self, path: Path, notices: Sequence[str]) -> None:
        self.path = path
        self.notices = list(notices)

    @property
    def means(self) -> pd.DataFrame:
        """``sweep.csv``: a row for each combination of values and each number, with mean and standard error."""
        return self._table("sweep.csv")

    @property
    def runs(self) -> pd.DataFrame:
        """``runs.csv``: a row for each finished run, with values, seed and all its numbers."""
        return self._table("runs.csv")

    def _table(self, name: str) -> pd.DataFrame:
        if not (self.path / name).is_file():
            raise InputError(f"{self.path}: has no {name}: no run of it is finished")
        return pd.read_csv(self.path / name)

    def __repr__(self) -> str:
        return f"<Sweep {shown_path(self.path)!r}>"


@checked
def sweep(
    scenario: ScenarioLike,
    out: str | os.PathLike[str] | None = None,
    *,
    set: Mapping[str, Any] | None = None,
    seeds: Sequence[int] | None = None,
    engine: str | None = None,
    threads: int = 1,
) -> list[Task]:
    """The runs of a scenario for all combinations of values, each with all seeds: tasks, of which none is begun.

    The directory is that of ``daphnis sweep``, which may go on with it, and the other way round. Each task runs by
    `Task.run` or `run_task`, here or in another process, on any machine that sees the directory.

    Args:
        scenario: as for `daphnis.scenario`.
        out: the directory of the sweep, new or with the same one; without it ``runs/NAME-sweep``.
        set: for each key one value, or a list of values; a value that is a list itself stands in a list:
            ``{"particles.opticalDepth": [0.1, 0.5], "box.lengths": [[100, 100, 20]]}``.
        seeds: such as ``range(1, 9)``; without it the scenario's alone.
        engine: as for `run`.
        threads: of each run. Many runs at a time do best with one each.

    Raises:
        InputError: something above is wrong, or the directory holds something else.
    """
    found = as_scenario(scenario)
    directory = Path("runs") / f"{found.name}-sweep" if out is None else Path(out)
    settings = java("java.util.ArrayList")()
    for key, values in (set or {}).items():
        listed = values if isinstance(values, (list, tuple)) or hasattr(values, "tolist") else [values]
        settings.add(f"{key}={','.join(_json(key, value) for value in listed)}")
    words = None if seeds is None else ",".join(str(seed) for seed in seeds)
    with translated():
        folder = java("daphnis.app.SweepFolder").make(
            found.java, found.source, settings, words, engine, java_path(directory)
        )
        write = java("daphnis.core.scenario.ScenarioJson").write
        return [
            Task(
                str(task.getName()),
                os.path.abspath(str(task.getDirectory())),
                str(write(task.getScenario())),
                found.source,
                threads,
            )
            for task in folder.getTasks()
        ]


def _json(key: str, value: Any) -> str:
    try:
        return json.dumps(value.item() if hasattr(value, "item") else value, allow_nan=False)
    except (TypeError, ValueError):
        raise InputError(f"set: {key}: is {value!r}, which no scenario can hold") from None


@checked
def run_task(task: Task) -> Outcome:
    """Makes the run of a `task` and says what has come of it: for ``executor.map(daphnis.run_task, tasks)``.

    A run that fails does not end the others: its outcome says why. Only Ctrl-C and a kill are raised.

    Processes have to be started anew, not forked from one that has used daphnis: with ``concurrent.futures`` by
    ``mp_context=multiprocessing.get_context("spawn")``.
    """
    try:
        done = task.run(progress=False)
        digest = str(done.summary["stateDigest"]) if done.finished else None
        return Outcome(task.name, task.path, done.finished, digest, None if digest else "ended before its end")
    except Interrupted:
        raise
    except DaphnisError as e:
        return Outcome(task.name, task.path, finished=False, failure=str(e))


@checked
def collect(out: str | os.PathLike[str], from_: float | None = None) -> Sweep:
    """Makes the tables and plots of the finished runs of the sweep in the directory `out`, as ``daphnis sweep`` does.

    Runs that are missing, failed or of another sweep are named in `Sweep.notices`, and as warnings.

    Args:
        out: the directory.
        from_: averages begin at this time, in the scenario's unit; without it after 3/8 of each run.

    Raises:
        InputError: there is no sweep, or another process makes its tables.
    """
    with translated():
        start = None if from_ is None else java("java.lang.Double")(float(from_))
        notices = [str(line) for line in java("daphnis.app.SweepFolder").open(java_path(Path(out))).collect(start)]
    noted(notices)
    return Sweep(Path(os.path.abspath(out)), notices)
