"""Laws and forces of Python in a run directory."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import jpype

from . import laws
from ._errors import PythonFailure, translated
from ._jvm import java
from .laws import Force, Laws
from .scenarios import Scenario, ScenarioLike
from .scenarios import scenario as as_scenario


def engines() -> Any:
    """The ``EngineFactory`` of all engines there are."""
    factory = java("daphnis.core.engine.EngineFactory")
    every = [java("daphnis.core.Engines").factory(), java("daphnis.actors.ActorEngines").factory()]
    return java("daphnis.core.engine.CombinedEngines")(jpype.JArray(factory)(every))


def fitted(scenario: ScenarioLike, settings: dict[str, Any], given: Laws) -> dict[str, Any]:
    """`settings` with what laws of Python need, where neither they nor `scenario` have it.

    Nobody knows whether a law of Python is elastic at low speed, so the guard is that of a constant coefficient. Where
    surfaces are rough, spheres spin.
    """
    needed: dict[str, Any] = {}
    if given.restitution is not None or given.contact is not None:
        needed["guard"] = {"type": "floor-speed", "relative": 1e-6}
    if given.roughness is not None or given.contact is not None:
        needed["roughness"] = {"type": "smooth"}
    if not needed:
        return settings
    asked = as_scenario(scenario, set=settings).to_dict()
    return {**settings, **{key: value for key, value in needed.items() if not asked.get(key)}}


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
    given: Laws,
    forces: Sequence[Force],
    failure: PythonFailure,
    *,
    records: bool,
    time: float,
    time_step: Any = None,
) -> Any:
    """The ``Simulation`` of `setup` with `given` laws and `time_step` in place of its own, and `forces` besides."""
    resolved = setup.getScenario()
    engine = java("daphnis.core.run.ScenarioEngine").of(resolved, source, engines())
    restitution, roughness = setup.getRestitution(), setup.getRoughness()
    if given.restitution is not None:
        restitution = given.restitution.proxy(failure)
    if given.roughness is not None:
        roughness = given.roughness.proxy(failure)
    if given.contact is not None:
        restitution, roughness = given.contact.proxy(failure), None
    collisions = setup.collisions(engine, records, restitution, roughness)
    every = java("java.util.ArrayList")(setup.getForces())
    for force in forces:
        every.add(force.proxy(failure))
    outputs = java("java.util.ArrayList")()
    if time_step is None:
        time_step = setup.getTimeStep()
    parts = (population, setup.getBoundary(), collisions, time_step, every, outputs)
    return java("daphnis.core.Simulation")(*parts, time, 0, None, setup.getSources())


class Program:
    """A scenario with a law or forces of Python, as a ``daphnis.core.run.Program``."""

    def __init__(
        self,
        scenario: Scenario,
        given: Laws,
        forces: Sequence[Force],
        failure: PythonFailure,
        until: float | None = None,
    ) -> None:
        self._scenario = scenario
        self._given = given
        self._forces = forces
        self._failure = failure
        # What is relative to the initial state, such as a guard, stays so at a resume.
        self._setup = setup_of(scenario)
        self._until = until
        # What does not change a bit is not part of the version.
        told = {key: value for key, value in scenario.to_dict().items() if key not in _HARMLESS}
        potentials = [force.potential for force in forces if force.potential is not None]
        self._version = laws.fingerprint(told, *given.parts, *forces, *potentials)

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
                self._given,
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
