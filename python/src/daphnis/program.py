"""Laws and forces of Python in a run directory."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import jpype

from . import laws
from ._errors import PythonFailure, translated
from ._jvm import java
from .laws import Force, Restitution
from .scenarios import Scenario, ScenarioLike
from .scenarios import scenario as as_scenario


def engines() -> Any:
    """The ``EngineFactory`` of all engines there are."""
    factory = java("daphnis.core.engine.EngineFactory")
    every = [java("daphnis.core.Engines").factory(), java("daphnis.actors.ActorEngines").factory()]
    return java("daphnis.core.engine.CombinedEngines")(jpype.JArray(factory)(every))


def guarded(scenario: ScenarioLike, settings: dict[str, Any]) -> dict[str, Any]:
    """`settings` with a guard against collapse, if neither they nor `scenario` have one.

    Nobody knows whether a law of Python is elastic at low speed, so the guard is that of a constant coefficient.
    """
    if as_scenario(scenario, set=settings).to_dict().get("guard"):
        return settings
    return {**settings, "guard": {"type": "floor-speed", "relative": 1e-6}}


def setup_of(scenario: Scenario, population: Any = None) -> Any:
    """The ``ScenarioSetup`` of `scenario`, or of `population` in it."""
    with translated():
        setups = java("daphnis.core.scenario.ScenarioSetup")
        if population is None:
            return setups.of(scenario.java, scenario.source)
        return setups.of(scenario.java, scenario.source, population)


def simulation_of(
    setup: Any,
    source: str,
    population: Any,
    law: Restitution | None,
    forces: Sequence[Force],
    failure: PythonFailure,
    *,
    records: bool,
    time: float,
    time_step: Any = None,
) -> Any:
    """The ``Simulation`` of `setup` with `law` and `time_step` in place of its own, and with `forces` besides."""
    resolved = setup.getScenario()
    engine = java("daphnis.core.run.ScenarioEngine").of(resolved, source, engines())
    restitution = setup.getRestitution() if law is None else law.proxy(failure)
    collisions = setup.collisions(engine, records, restitution)
    every = java("java.util.ArrayList")(setup.getForces())
    for force in forces:
        every.add(force.proxy(failure))
    outputs = java("java.util.ArrayList")()
    if time_step is None:
        time_step = setup.getTimeStep()
    return java("daphnis.core.Simulation")(population, setup.getBoundary(), collisions, time_step, every, outputs, time)


class Program:
    """A scenario with a law or forces of Python, as a ``daphnis.core.run.Program``."""

    def __init__(
        self,
        scenario: Scenario,
        law: Restitution | None,
        forces: Sequence[Force],
        failure: PythonFailure,
        until: float | None = None,
    ) -> None:
        self._scenario = scenario
        self._law = law
        self._forces = forces
        self._failure = failure
        # What is relative to the initial state, such as a guard, stays so at a resume.
        self._setup = setup_of(scenario)
        self._until = until
        # What does not change a bit is not part of the version.
        told = {key: value for key, value in scenario.to_dict().items() if key not in _HARMLESS}
        potentials = [force.potential for force in forces if force.potential is not None]
        self._version = laws.fingerprint(told, law, *forces, *potentials)

    def proxy(self) -> Any:
        """What Java calls."""
        resolved = self._setup.getScenario()
        end = resolved.getEnd() if self._until is None else self._until
        output = resolved.getOutput()
        records = bool(output.getCollisionLog() or output.getTransportEvery() > 0)

        def simulation(population: Any) -> Any:
            return simulation_of(
                self._setup,
                self._scenario.source,
                population,
                self._law,
                self._forces,
                self._failure,
                records=records,
                time=resolved.getStartTime(),
            )

        calls = {
            "getName": lambda: self._scenario.name,
            "getVersion": lambda: self._version,
            "getUntil": lambda: end,
            "getOutput": lambda: output,
            "getFirstBody": lambda: resolved.getFirstBody(),
            "population": lambda: self._setup.getPopulation(),
            "simulation": simulation,
            "outputs": lambda: java("java.util.HashMap")(),
        }
        return jpype.JProxy("daphnis.core.run.Program", dict=calls)


_HARMLESS = {"name", "description", "until", "untilOrbits", "engine", "search", "output"}
