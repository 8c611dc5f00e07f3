"""Runs: simulations in a directory, with tables and states."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from ._arguments import checked
from ._errors import FormatError, InputError, translated
from ._execution import Watch
from ._jvm import java, java_path
from ._paths import shown_path
from ._resuming import resumed
from .laws import BothLaw, Force, Law, Surface
from .report import Report
from .report import analyze as _analyze
from .scenarios import Scenario, ScenarioLike, Settings, Units
from .states import State
from .tables import Tables, read_table
from .view import View


class Run:
    """A run in its directory, finished or still going on. Made by `run`, `resume` and `open`.

    Everything is read when it is asked for, and of a run that goes on it is what is there then.

    Attributes:
        path: the run directory.
        notices: what a user should know about its start, a line each.
    """

    @checked
    def __init__(self, path: str | os.PathLike[str], notices: Sequence[str] = ()) -> None:
        self.path = Path(os.path.abspath(path))
        self.notices = list(notices)
        with translated():
            self._java = java("daphnis.core.run.Run").open(java_path(self.path))
            found = self._java.scenario()
        self._scenario = None if found is None else Scenario(found, str(self.path / "scenario.json"))

    @property
    def java(self) -> Any:
        """The ``daphnis.core.run.RecordedRun``."""
        return self._java

    @property
    def has_scenario(self) -> bool:
        """Whether it is a run of a scenario: without laws or forces of Python, which no scenario knows."""
        return self._scenario is not None

    @property
    def scenario(self) -> Scenario:
        """The scenario that is run. Raises InputError if laws or forces of Python took part, see `has_scenario`."""
        if self._scenario is None:
            raise InputError(f"{self.path}: has no scenario, since laws or forces of Python took part in the run")
        return self._scenario

    @property
    def units(self) -> Units:
        """Names of the units of the scenario. Raises InputError as `scenario`."""
        return self.scenario.units

    @property
    def _known_units(self) -> Units | None:
        return None if self._scenario is None else self._scenario.units

    @property
    def finished(self) -> bool:
        """Whether it has come to its end. False while it goes on, and after it was interrupted."""
        entries = self._entries()
        return entries is not None and entries.get("finished") is True

    @property
    def summary(self) -> dict[str, Any]:
        """The entries of ``summary.json``, see docs/runs.md. Raises InputError while the run has none.

        ``run.summary["stateDigest"]`` is the same for equal bits of all states.
        """
        entries = self._entries()
        if entries is None:
            raise InputError(f"{self.path}: has no summary.json; a run writes it when it ends")
        return entries

    def _entries(self) -> dict[str, Any] | None:
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
        """``series.csv``: a row every ``output.seriesEvery`` steps; units in ``attrs["units"]``.

        docs/reference/columns.md says what the columns of this and the other tables are.
        """
        return self._table("series.csv", "output.seriesEvery")

    @property
    def transport(self) -> pd.DataFrame:
        """``transport.csv``: moments and sums for viscosities, a row every ``output.transportEvery`` steps."""
        return self._table("transport.csv", "output.transportEvery")

    @property
    def modes(self) -> pd.DataFrame:
        """``modes.csv``: Fourier modes along x, a row for each mode every ``output.modesEvery`` steps."""
        return self._table("modes.csv", "output.modesEvery")

    @property
    def impacts(self) -> pd.DataFrame:
        """``impacts.csv``: the distribution of impact speeds since the start."""
        return self._table("impacts.csv", "output.transportEvery")

    @property
    def bodies(self) -> pd.DataFrame:
        """``bodies.csv``: for each body and time its orbit and what pushed it."""
        return self._table("bodies.csv", "output.bodiesEvery")

    @property
    def collisions(self) -> pd.DataFrame:
        """``collisions.csv``: a row for each collision of two spheres; of rough ones with tangential impulses.

        With interactions also events at edges, whose separation is longer than the sum of the radii.
        """
        return self._table("collisions.csv", "output.collisionLog")

    def _table(self, name: str, key: str) -> pd.DataFrame:
        path = self.path / name
        if not path.is_file():
            raise InputError(f"{self.path}: has no {name}; run with {key} in set=")
        units = self._known_units
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

    @checked
    def at(self, time: float | None = None, *, orbits: float | None = None) -> State:
        """The state at `time`, in units of time, or after a number of `orbits`; round-off of 1e-9 is allowed.

        Raises:
            InputError: there is none; the message names those next to it.
        """
        if (time is None) == (orbits is None):
            raise InputError("at: needs one of time and orbits")
        if time is None:
            if self._scenario is None or not self._scenario.is_hill or orbits is None:
                raise InputError(f"{self.path}: orbits need a run in Hill's frame; give a time")
            time = orbits * self._scenario.orbit
        with translated():
            return State(self._java.at(float(time)), self._known_units, self)

    @checked
    def at_step(self, step: int) -> State:
        """The state after `step` steps. Raises InputError if there is none."""
        with translated():
            return State(self._java.atStep(int(step)), self._known_units, self)

    def last(self) -> State:
        """The latest state. Raises InputError if there is none."""
        with translated():
            return State(self._java.last(), self._known_units, self)

    analyze = _analyze

    @property
    def report(self) -> Report:
        """What `analyze` wrote before."""
        if not (self.path / "report.html").is_file():
            raise InputError(f"{self.path}: has no report yet; analyze() writes it")
        return Report(self.path, [])

    @checked
    def view(self, height: int = 850) -> View:
        """A page that shows the states in 3-D, as ``daphnis view`` does, in a frame of `height` pixels.

        Of a run that goes on, new states show up as they are written. Raises InputError if there is no state.
        """
        with translated():
            return View(java("daphnis.app.live.ViewPage").inNotebook(self._java), height)

    @checked
    def resume(
        self,
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
        """`daphnis.resume` of this run, with its arguments."""
        given = {name: value for name, value in locals().items() if name != "self"}
        return Run(self.path, resumed(self.path, **given))

    def _repr_html_(self) -> str:
        entries = self._entries() or {}
        shown = ("finished", "scenario", "particles", "steps", "time", "collisions", "stateDigest")
        column = pd.Series(
            {"directory": shown_path(self.path), **{name: entries[name] for name in shown if name in entries}}
        )
        return str(column.to_frame().to_html(header=False))

    def __reduce__(self) -> tuple[Any, ...]:
        """For ``pickle``: by its path, since everything is in its directory. Unpickling starts Java."""
        return Run, (str(self.path), self.notices)

    def __repr__(self) -> str:
        return f"<Run {shown_path(self.path)!r}>"


class States:
    """The states of a run, each read when it is come to. Going through them again sees what was written since."""

    def __init__(self, run: Run) -> None:
        self._run = run

    def __iter__(self) -> Iterator[State]:
        with translated():
            # The class of the object has no name, under which JPype would find its methods; Java itself does.
            method = java("java.lang.Class").forName("java.lang.Iterable").getMethod("iterator")
            iterator = method.invoke(self._run.java.states())
        while True:
            with translated():
                if not iterator.hasNext():
                    return
                snapshot = iterator.next()
            yield State(snapshot, self._run._known_units, self._run)

    def __len__(self) -> int:
        return len(self._run.steps)

    @checked
    def __getitem__(self, k: int) -> State:
        return self._run.at_step(self._run.steps[k])

    def __repr__(self) -> str:
        return f"<{len(self)} states of {shown_path(self._run.path)!r}>"


@checked
def open(path: str | os.PathLike[str]) -> Run:
    """The run in the directory `path`, finished or still going on. Raises InputError if there is none."""
    return Run(path)
