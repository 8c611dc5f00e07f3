"""Laws of restitution and forces written in Python."""

from __future__ import annotations

import functools
import hashlib
import math
from collections.abc import Callable, Sequence
from types import CodeType
from typing import Any

import jpype
import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays
from ._errors import InputError, PythonFailure
from ._jvm import java


class Spheres:
    """The spheres that a force is given: arrays in the order of ids, whatever their order in memory is.

    So a function of them gives the same bits with every engine and number of threads, sums included. Each attribute is
    fetched at its first use, with one copy, and must not be written to.
    """

    def __init__(self, population: Any) -> None:
        self._population = population
        self._order = _arrays.of_ints(population.indicesById())

    def __len__(self) -> int:
        return len(self._order)

    @functools.cached_property
    def id(self) -> NDArray[np.int32]:
        """Ids, shape (n,), ascending."""
        return _read_only(_arrays.of_ints(self._population.getId())[self._order])

    @functools.cached_property
    def position(self) -> NDArray[np.float64]:
        """Positions, shape (n, 3), in units of length."""
        return self._columns("X", "Y", "Z")

    @functools.cached_property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities, shape (n, 3), in units of length per unit of time; in Hill's frame in the rotating frame."""
        return self._columns("Vx", "Vy", "Vz")

    @functools.cached_property
    def radius(self) -> NDArray[np.float64]:
        """Radii, shape (n,), in units of length."""
        return _read_only(_arrays.of_doubles(self._population.getRadius())[self._order])

    @functools.cached_property
    def mass(self) -> NDArray[np.float64]:
        """Masses, shape (n,), in units of mass."""
        return _read_only(_arrays.of_doubles(self._population.getMass())[self._order])

    def _columns(self, *names: str) -> NDArray[np.float64]:
        arrays = [getattr(self._population, f"get{name}")() for name in names]
        return _read_only(np.ascontiguousarray(_arrays.columns(*arrays)[self._order]))

    def _add(self, change: NDArray[np.float64]) -> None:
        """Adds `change`, shape (n, 3), to the velocities of the population."""
        for axis, name in enumerate(("Vx", "Vy", "Vz")):
            column = getattr(self._population, f"get{name}")()
            values = _arrays.of_doubles(column)
            values[self._order] += change[:, axis]
            column[:] = values


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array


class Restitution:
    """A law of restitution: the coefficient ε in [0, 1] for an impact speed. Made by `restitution`."""

    def __init__(self, function: Callable[[float], float]) -> None:
        if not callable(function):
            raise InputError(f"restitution: is {function!r}; it must be a function of the impact speed")
        self.function = function
        functools.update_wrapper(self, function)

    def __call__(self, impact_speed: float) -> float:
        return self.function(impact_speed)

    def proxy(self, failure: PythonFailure) -> Any:
        """What Java calls."""
        function = self.function

        def coefficient(speed: float) -> float:
            try:
                given = function(float(speed))
                try:
                    value = float(given)
                except (TypeError, ValueError):
                    value = math.nan
                # NaN is in no range.
                if not 0.0 <= value <= 1.0:
                    name = getattr(function, "__name__", "restitution")
                    lost = "; does it lack a return?" if given is None else ""
                    right = f"it must be in [0, 1]{lost}"
                    raise InputError(f"{name}: gives {given!r} at an impact speed of {float(speed)}; {right}")
                return value
            except BaseException as e:
                failure.keep(e)
                raise

        return jpype.JProxy(java("daphnis.core.collision.Restitution"), dict={"coefficient": coefficient})


def _given(name: str, value: Any, shape: tuple[int, ...]) -> Any:
    if value is None:
        raise InputError(f"{name}: gives None; it must be an array of shape {shape}; does it lack a return?")
    return value


class Force:
    """A force that changes velocities. Made by `kick` or `acceleration`."""

    def __init__(
        self,
        function: Callable[..., ArrayLike],
        takes_duration: bool,
        potential: Callable[[Spheres, float], ArrayLike] | None = None,
    ) -> None:
        for what in (function, potential):
            if what is not None and not callable(what):
                raise InputError(f"force: is {what!r}; it must be a function")
        self.function = function
        self.potential = potential
        self._takes_duration = takes_duration
        functools.update_wrapper(self, function)

    def __call__(self, *arguments: Any) -> ArrayLike:
        return self.function(*arguments)

    def change(self, spheres: Spheres, time: float, duration: float) -> NDArray[np.float64]:
        """The change of the velocities in `duration`, shape (n, 3)."""
        name = getattr(self.function, "__name__", "force")
        shape = (len(spheres), 3)
        if self._takes_duration:
            return _arrays.numbers(name, _given(name, self.function(spheres, time, duration), shape), shape)
        return _arrays.numbers(name, _given(name, self.function(spheres, time), shape), shape) * duration

    def energy(self, spheres: Spheres, time: float) -> float:
        """Sum of the potential energies; NaN without a function for them."""
        if self.potential is None:
            return math.nan
        name = getattr(self.potential, "__name__", "potential")
        shape = (len(spheres),)
        return math.fsum(_arrays.numbers(name, _given(name, self.potential(spheres, time), shape), shape))

    def proxy(self, failure: PythonFailure) -> Any:
        """What Java calls."""

        def act(population: Any, time: float, duration: float) -> None:
            """For half of a step of `duration`."""
            try:
                spheres = Spheres(population)
                # Nothing is written before the function has ended well.
                spheres._add(self.change(spheres, float(time), float(duration) / 2))
            except BaseException as e:
                failure.keep(e)
                raise

        def potential_energy(population: Any, boundary: Any, time: float) -> float:
            try:
                return self.energy(Spheres(population), float(time))
            except BaseException as e:
                failure.keep(e)
                raise

        # JPype calls no default method that has arguments, so each is there.
        calls = {
            "beforeDrift": act,
            "afterDrift": act,
            "useLoop": lambda loop: None,
            "potentialEnergy": potential_energy,
        }
        return jpype.JProxy(java("daphnis.core.force.Force"), dict=calls)


Law = Restitution | Callable[[float], float]


def restitution(function: Callable[[float], float]) -> Restitution:
    """Makes a law of restitution of a function.

    ``function(impact_speed)`` is given the normal component of the relative velocity at contact, ≥ 0, in units of speed
    of the scenario, and gives ε in [0, 1]. It must be a pure function. It is called for every collision, from any
    thread of the engine, one at a time, which takes far longer than a law of Java.

    An exception in it comes out of the run or the step as it is, and the state is as before the step.

        @daphnis.restitution
        def ice(v):
            return min(1.0, 0.34 * v**-0.234) if v > 0 else 1.0
    """
    return Restitution(function)


def kick(
    function: Callable[[Spheres, float, float], ArrayLike] | None = None,
    *,
    potential: Callable[[Spheres, float], ArrayLike] | None = None,
) -> Any:
    """Makes a force of a function that gives changes of velocity.

    ``function(spheres, time, duration)`` is given `Spheres`, the time, and how long the force acts, which is half a
    step; it gives the changes of the velocities, shape (n, 3), in units of speed, in the order of ``spheres.id``. It is
    called before and after the drift of each step. It must be a pure function, since a step that fails is done again.

    Args:
        potential: ``potential(spheres, time)`` gives the potential energy of each sphere, shape (n,), in units of
            energy. Without it the energies in the series are NaN.
    """
    if function is None:
        return functools.partial(kick, potential=potential)
    return Force(function, True, potential)


def acceleration(
    function: Callable[[Spheres, float], ArrayLike] | None = None,
    *,
    potential: Callable[[Spheres, float], ArrayLike] | None = None,
) -> Any:
    """Makes a force of a function that gives accelerations.

    As `kick`, but ``function(spheres, time)`` gives accelerations, shape (n, 3), in units of length/time².

        @daphnis.acceleration
        def drag(spheres, time):
            return -0.01 * spheres.velocity
    """
    if function is None:
        return functools.partial(acceleration, potential=potential)
    return Force(function, False, potential)


def as_law(law: Law | None) -> Restitution | None:
    return law if law is None or isinstance(law, Restitution) else Restitution(law)


def as_forces(forces: Sequence[Force]) -> list[Force]:
    if isinstance(forces, Force) or not isinstance(forces, Sequence):
        raise InputError("forces: must be a list of what daphnis.kick or daphnis.acceleration made")
    for force in forces:
        if not isinstance(force, Force):
            raise InputError(f"forces: {force!r} is not what daphnis.kick or daphnis.acceleration made")
    return list(forces)


def fingerprint(*parts: Any) -> str:
    """A word that is another one when a text or the code of a function in `parts` is.

    Where a function stands, and what it is called, changes nothing. Numbers and words that it closes over count. What
    it reads of its module, and what can change by itself, such as a list, is not looked at.
    """
    digest = hashlib.sha256()
    for part in parts:
        digest.update(_described(getattr(part, "function", part)).encode() + b"\0")
    return digest.hexdigest()[:16]


def _described(part: Any) -> str:
    """`part` in words that are the same in every process."""
    if isinstance(part, functools.partial):
        return repr((_described(part.func), *map(_described, part.args), *map(_described, part.keywords.items())))
    if isinstance(part, CodeType):
        return repr((part.co_code.hex(), part.co_names, [_described(constant) for constant in part.co_consts]))
    if isinstance(part, (frozenset, tuple)):
        words = [_described(entry) for entry in part]
        return repr(sorted(words) if isinstance(part, frozenset) else words)
    code = getattr(part, "__code__", None)
    if code is not None:
        cells = [cell.cell_contents for cell in part.__closure__ or ()]
        return repr((_described(code), *map(_described, part.__defaults__ or ()), *map(_described, cells)))
    if callable(part):
        # An object that is called: its code, and those of its values that are plain.
        plain = {name: value for name, value in getattr(part, "__dict__", {}).items() if isinstance(value, _PLAIN)}
        return repr((type(part).__qualname__, _described(getattr(type(part).__call__, "__code__", None)), plain))
    return repr(part) if part is None or isinstance(part, _PLAIN) else type(part).__qualname__


_PLAIN = (bool, bytes, complex, float, int, str)
