"""A simulation in memory, advanced step by step."""

from __future__ import annotations

from collections.abc import Sequence
from types import TracebackType
from typing import Any, NoReturn

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays, laws
from ._arguments import checked
from ._errors import InputError, PythonFailure, RunError, noted, translated
from ._interrupts import CtrlC
from ._jvm import java
from .laws import BothLaw, Force, Law, Surface
from .program import engines, fitted, setup_of, simulation_of
from .scenarios import ScenarioLike, Settings
from .scenarios import scenario as as_scenario
from .states import State


class Simulation:
    """Spheres in memory, advanced one step at a time, without a directory.

    The physics is that of a scenario; the spheres are either those that it describes, or arrays. With arrays the
    scenario needs only ``box``, ``boundary``, ``restitution`` and ``timeStep`` (docs/scenario.md):

        sim = daphnis.Simulation(
            {"box": {"lengths": [20, 20, 20]}, "boundary": {"type": "periodic"},
             "restitution": {"type": "constant", "coefficient": 0.9}, "timeStep": {"type": "fixed", "dt": 0.1}},
            position=position, velocity=velocity, radius=0.5, mass=1.0)
        with sim:
            sim.advance(100)
            print(sim.state().velocity)

    One thread at a time uses a simulation; several simulations may go on at once, each on a thread of its own, since
    Java computes without the lock of Python. After an exception in a step everything is as before it, to the bit, and
    the step may be done again.

    Args:
        scenario: as for `daphnis.scenario`.
        position: centres, shape (n, 3), in units of length; in any order and layout. Copied, like all arrays.
        velocity: shape (n, 3), in units of length per unit of time; at rest without it. In Hill's frame those in the
            rotating frame, whose mean flow is v_y = −(3/2) Ω x.
        spin: angular velocities, shape (n, 3), in radians per unit of time, of a scenario with ``roughness``, or a
            law for it; none without it. In Hill's frame relative to the frame.
        radius: one number, or shape (n,).
        mass: one number, or shape (n,); without it as of ``particles.density``, or 1 per volume.
        id: distinct whole numbers ≥ 0, shape (n,); 0, 1, 2, … without it.
        material: the name of the material of each sphere, or its number in `materials`, shape (n,); none without it.
        materials: names of materials by number, words of letters, digits, _ and -; without them those of the scenario,
            or else those in `material` as they come up.
        set: values for keys of the scenario.
        seed: of the initial state, without arrays.
        time: of the initial state, in units of time; it sets where sliding images and satellites are.
        engine: as for `daphnis.run`; "serial" without it.
        threads: of the engine.
        restitution: a law of Python in place of the scenario's.
        roughness: the same, of surfaces; spheres then have spins.
        contact_law: a law of Python for both coefficients.
        forces: forces of Python beside the scenario's.

    Raises:
        InputError: an array has another shape or type or holds a NaN, spheres overlap or are outside the box, or the
            scenario is wrong.
    """

    @checked
    def __init__(
        self,
        scenario: ScenarioLike,
        *,
        position: ArrayLike | None = None,
        velocity: ArrayLike | None = None,
        spin: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        mass: ArrayLike | None = None,
        id: ArrayLike | None = None,
        material: ArrayLike | None = None,
        materials: Sequence[str] | None = None,
        set: Settings | None = None,
        seed: int | None = None,
        time: float | None = None,
        engine: str | None = None,
        threads: int | None = None,
        restitution: Law | None = None,
        roughness: Surface | None = None,
        contact_law: BothLaw | None = None,
        forces: Sequence[Force] = (),
    ) -> None:
        given = laws.as_laws(restitution, roughness, contact_law)
        begin = None if time is None else float(_arrays.numbers("time", time, ()))
        settings = dict(set or {})
        settings.setdefault("engine.name", "serial")
        if engine is not None:
            settings["engine.name"] = engine
        if threads is not None or engines().isSpecification(str(settings["engine.name"])):
            settings["engine.threads"] = 0 if threads is None else threads
        settings = fitted(scenario, settings, given)
        self.scenario = as_scenario(scenario, set=settings, seed=seed)
        asked = self.scenario.to_dict()
        endless = asked.get("until") is None and asked.get("untilOrbits") is None
        if endless:
            # A simulation in memory ends when its owner says so, but a scenario has to have an end.
            start_time = float((asked.get("placement") or {}).get("time") or 0.0)
            settings["until"] = start_time + max(1.0, abs(start_time))
            self.scenario = as_scenario(scenario, set=settings, seed=seed)
        self._failure = PythonFailure()
        population = None
        if position is None:
            for name, array in (
                ("velocity", velocity),
                ("spin", spin),
                ("radius", radius),
                ("mass", mass),
                ("id", id),
                ("material", material),
                ("materials", materials),
                ("time", time),
            ):
                if array is not None:
                    raise InputError(f"{name}: is given without position")
        else:
            if seed is not None:
                raise InputError("seed: is of an initial state; position is one")
            population = self._population(position, velocity, spin, radius, mass, id)
            if material is not None or materials is not None:
                population = self._made(population, material, materials)
        setup = setup_of(self.scenario, population)
        start = float(setup.getScenario().getStartTime()) if begin is None else begin
        if population is not None:
            _check_inside(population, setup.getBoundary())
        with translated():
            time_step = setup.endlessTimeStep() if endless else setup.getTimeStep()
            stopping = isinstance(time_step, java("daphnis.core.StoppingTimeStep"))
            self._stops = time_step.getStops() if stopping else None
            self._java = simulation_of(
                setup,
                self.scenario.source,
                setup.getPopulation(),
                given,
                forces,
                self._failure,
                records=False,
                time=start,
                time_step=time_step,
            )
            if population is not None:
                self._java.checkStart()
        noted([*map(str, setup.getNotices()), *map(str, java("daphnis.core.scenario.Warnings").of(setup))])
        self._first_body = int(setup.getScenario().getFirstBody())
        self._mine = True

    def _population(self, position: Any, velocity: Any, spin: Any, radius: Any, mass: Any, id: Any) -> Any:
        places = _arrays.numbers("position", position, ("n", 3))
        n = len(places)
        if n == 0:
            raise InputError("position: has no row; there must be one sphere at least")
        speeds = np.zeros((n, 3)) if velocity is None else _arrays.numbers("velocity", velocity, (n, 3))
        if radius is None:
            raise InputError("radius: is missing; give one number, or one for each sphere")
        radii = _arrays.each("radius", radius, n)
        if mass is None:
            density = (self.scenario.to_dict().get("particles") or {}).get("density", 1.0)
            masses = density * 4 / 3 * np.pi * radii**3
        else:
            masses = _arrays.each("mass", mass, n)
        columns = [*places.T, *speeds.T, radii, masses]
        asked = self.scenario.to_dict()
        is_rough = "roughness" in asked or "roughness" in (asked.get("boundary") or {})
        is_rough = is_rough or any("roughness" in contact for contact in asked.get("contacts") or [])
        if spin is not None and not is_rough:
            raise InputError("spin: is of spheres that spin; the scenario needs roughness")
        spins = np.zeros((n, 3)) if spin is None else _arrays.numbers("spin", spin, (n, 3))
        with translated():
            population = java("daphnis.core.population.Population")(
                *[_arrays.doubles(column) for column in columns], _arrays.ints(_arrays.ids(id, n))
            )
            return population.withSpin(*[_arrays.doubles(column) for column in spins.T]) if is_rough else population

    def _made(self, population: Any, material: Any, materials: Sequence[str] | None) -> Any:
        """The spheres with materials."""
        n = int(population.getSize())
        if material is None:
            raise InputError("materials: is given without material")
        given = np.asarray(material)
        if given.shape != (n,):
            raise InputError(f"material: has the shape {given.shape}; it must be ({n},)")
        names = [str(name) for name in (self.scenario.java.getMaterials() if materials is None else materials)]
        if given.dtype.kind in "US":
            words = [str(word) for word in given]
            names = names or list(dict.fromkeys(words))
            unknown = next((word for word in words if word not in names), None)
            if unknown is not None:
                raise InputError(f"material: has {unknown!r}; it must be one of {', '.join(names)}")
            numbers = np.array([names.index(word) for word in words], dtype=np.int32)
        else:
            if given.dtype.kind not in "iu":
                raise InputError(f"material: has the type {given.dtype}; it must be names or whole numbers")
            if not names:
                raise InputError("materials: is missing; give a name for each number in material")
            wrong = given[(given < 0) | (given >= len(names))]
            if len(wrong) > 0:
                raise InputError(f"material: has {wrong[0]}; it must be a number in 0..{len(names) - 1}")
            numbers = given.astype(np.int32)
        with translated():
            return population.withMaterial(_arrays.ints(numbers), java("java.util.ArrayList")(names))

    @classmethod
    def _watched(cls, simulation: Any) -> Simulation:
        """The simulation of a run, to look at."""
        watched = cls.__new__(cls)
        watched._java = simulation
        watched._failure = PythonFailure()
        watched._stops = None
        watched._first_body = 2**31 - 1
        watched._mine = False
        return watched

    @property
    def java(self) -> Any:
        """The ``daphnis.core.Simulation``."""
        return self._java

    def advance(self, steps: int = 1) -> Simulation:
        """Takes `steps` steps. Ctrl-C ends it after a whole step; a second one breaks off a function of Python at once.

        Raises:
            RunError: a step failed, or the simulation is closed; everything is as before that step.
        """
        if isinstance(steps, bool) or not isinstance(steps, (int, np.integer)) or steps < 0:
            raise InputError(f"steps: is {steps!r}; it must be a whole number of at least 0")
        self._require_mine()
        with CtrlC(self._failure, any_handler=False) as ctrl_c:
            for _ in range(steps):
                with translated(self._failure):
                    self._java.advance()
                if ctrl_c.pressed:
                    break
        if ctrl_c.pressed:
            raise KeyboardInterrupt
        return self

    def advance_to(self, time: float) -> Simulation:
        """Takes steps until `time`, in units of time, is reached but for a round-off of 1e-9.

        Where the scenario leaves their length open, the last step ends there; others keep their length.
        """
        end = float(_arrays.numbers("time", time, ()))
        self._require_mine()
        slack = 1e-9 * max(abs(end), abs(self.time))
        before = None if self._stops is None else self._stops.getEnd()
        try:
            if self._stops is not None:
                self._stops.setEnd(end)
            while self.time < end - slack:
                self.advance()
        finally:
            if self._stops is not None:
                self._stops.setEnd(before)
        return self

    def _require_mine(self) -> None:
        if not self._mine:
            raise RunError("a simulation that is watched is advanced by its run")

    @property
    def time(self) -> float:
        """Time at the end of the last step, in units of time."""
        return float(self._java.getTime())

    @property
    def step(self) -> int:
        """Steps since the start."""
        return int(self._java.getStep())

    def __len__(self) -> int:
        return int(self._java.getPopulation().getSize())

    @property
    def collisions(self) -> int:
        """Collisions between two spheres since the start."""
        return int(self._java.getCollisions().getCounters().getCollisions())

    @property
    def kinetic_energy(self) -> float:
        """Σ m v²/2 with the mean flow in it, in units of energy, without round-off."""
        return float(self._java.conserved().getKineticEnergy())

    @property
    def momentum(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Σ m v, shape (3,), without round-off."""
        sums = self._java.conserved()
        return np.array([sums.getMomentumX(), sums.getMomentumY(), sums.getMomentumZ()])

    @property
    def granular_temperature(self) -> float:
        """⟨c²⟩/3, of discs ⟨c²⟩/2, weighted by mass, c the peculiar velocity; in units of speed squared."""
        temperatures = java("daphnis.core.population.GranularTemperature")
        return float(temperatures.within(self._java.getPopulation(), self._java.getBoundary(), self._first_body))

    @property
    def dimensions(self) -> int:
        """3, or 2 for discs in the plane z = 0."""
        return int(self._java.getBoundary().getSpace().getDimensions())

    @property
    def digest(self) -> str:
        """SHA-256 over positions and velocities in the order of ids; equal if every bit is."""
        return str(java("daphnis.core.population.Digest").stateDigest(self._java.getPopulation()))

    def state(self) -> State:
        """A copy of all spheres at the end of the last step, in the order of ids."""
        snapshots = java("daphnis.core.format.Snapshot")
        live = self._java
        units = self.scenario.units if self._mine else None
        return State(snapshots.of(live.getPopulation(), live.getBoundary(), live.getStep(), live.getTime()), units)

    def close(self) -> None:
        """Ends the threads of the engine. Twice is allowed; steps are refused from then on, reading is not."""
        if self._mine:
            with translated():
                self._java.close()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Simulation lives in the Java of its process, it cannot be copied or sent; state() can")

    def __repr__(self) -> str:
        return f"<Simulation of {len(self)} spheres at time {self.time:.10g}, step {self.step}>"


def _check_inside(population: Any, boundary: Any) -> None:
    """Spheres of arrays must be inside the box, like those of a scenario."""
    open_axis = java("daphnis.core.boundary.ContactFaces").OPEN
    box = boundary.getBox()
    identities = _arrays.of_ints(population.getId())
    for axis, name in enumerate("xyz"):
        if boundary.contactFaces(axis) == open_axis:
            continue
        places = _arrays.of_doubles(population.position(axis))
        outside = np.flatnonzero((places < box.lower(axis)) | (places > box.upper(axis)))
        if len(outside):
            k = outside[0]
            limits = f"{name} from {box.lower(axis)} to {box.upper(axis)}"
            raise InputError(f"position: sphere {identities[k]} at {name} = {places[k]} is outside the box, {limits}")
