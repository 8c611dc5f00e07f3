"""Runs that go on from their last checkpoint."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import laws
from ._errors import InputError, PythonFailure
from ._execution import Watch, carried_out
from ._jvm import java, java_path
from .laws import BothLaw, Force, Law, Surface
from .program import Program, engines, fitted
from .scenarios import ScenarioLike, Settings
from .scenarios import scenario as as_scenario


def resumed(
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
) -> list[str]:
    """Continues the run in the directory `path` as `daphnis.resume` says, and gives its notices."""
    directory = Path(path)
    given = laws.as_laws(restitution, roughness, contact_law)
    if not given and not forces:
        if scenario is not None or set is not None:
            raise InputError("scenario: is for runs with laws or forces of Python; others have theirs")

        def start() -> Any:
            end = None if until is None else java("java.lang.Double")(until)
            return java("daphnis.core.run.Run").resume(java_path(directory), end, engines(), accept_loss)

        return carried_out(start, directory, PythonFailure(), watch, progress)
    if scenario is None:
        raise InputError("scenario: is missing; a run with laws or forces of Python is resumed with its scenario")
    settings = dict(set or {})
    settings = fitted(scenario, settings, given)
    failure = PythonFailure()
    program = Program(as_scenario(scenario, set=settings), given, forces, failure, until)
    return carried_out(
        lambda: java("daphnis.core.run.Run").resume(program.proxy(), java_path(directory), accept_loss),
        directory,
        failure,
        watch,
        progress,
    )
