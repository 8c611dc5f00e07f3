"""Laws of impacts and forces written in Python."""

from __future__ import annotations

import functools
import hashlib
import math
import sys
import threading
from collections.abc import Callable
from types import CodeType
from typing import Any, NamedTuple, overload

import jpype
import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays
from ._arguments import wrong_type
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

    def __repr__(self) -> str:
        return f"<Spheres: {len(self)}>"

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


class Contact(NamedTuple):
    """An impact as a law of surfaces sees it. Of two spheres the one with the lower id is the first.

    Attributes:
        normal_speed: normal component of the relative velocity before the impact, ≥ 0, in units of speed.
        tangential_speed: speed with which the surfaces slide on one another, ≥ 0; > 0 where only β is asked for.
        restitution: ε of this impact, 1 where a guard has made it elastic; None where it is asked for.
        moment_factor: moment of inertia over mass · radius², of every sphere.
        radii: of both, in units of length.
        masses: of both, in units of mass.
        materials: numbers of both, 0 where spheres have no materials.
    """

    normal_speed: float
    tangential_speed: float
    restitution: float | None
    moment_factor: float
    radii: tuple[float, float]
    masses: tuple[float, float]
    materials: tuple[int, int]

    @classmethod
    def _of(cls, contact: Any, is_asked: bool) -> Contact:
        """Of a ``SurfaceContact``, in which ε is asked for or known."""
        return cls(
            float(contact.getNormalSpeed()),
            float(contact.getTangentialSpeed()),
            None if is_asked else float(contact.getRestitution()),
            float(contact.getMomentFactor()),
            (float(contact.getFirstRadius()), float(contact.getSecondRadius())),
            (float(contact.getFirstMass()), float(contact.getSecondMass())),
            (int(contact.getFirstMaterial()), int(contact.getSecondMaterial())),
        )


def _coefficient(function: Any, given: Any, least: int, where: str) -> float:
    """`given` as a coefficient in [`least`, 1]."""
    try:
        value = float(given)
    except (TypeError, ValueError):
        value = math.nan
    # NaN is in no range.
    if not least <= value <= 1.0:
        name = getattr(function, "__name__", "restitution")
        lost = "; does it lack a return?" if given is None else ""
        raise InputError(f"{name}: gives {given!r} {where}; it must be in [{least}, 1]{lost}")
    return value


def _kept(failure: PythonFailure, function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """`function`, whose exceptions are kept for the caller of the step."""

    def call(argument: Any) -> Any:
        try:
            return function(argument)
        except BaseException as e:
            failure.keep(e)
            raise

    return call


class _OfFunction:
    """What a function of Python does in the physics."""

    def _parts(self) -> tuple[Any, ...]:
        """What its class is called with."""
        return (self.__dict__["function"],)

    def __reduce__(self) -> Any:
        """For ``pickle``: by its name, where a decorator has put it in the place of its function in a module."""
        found: Any = sys.modules.get(self.__module__) if self.__module__ != "__main__" else None
        for name in getattr(self, "__qualname__", "<none>").split("."):
            found = getattr(found, name, None)
        return self.__qualname__ if found is self else (type(self), self._parts())

    def __repr__(self) -> str:
        function = self._parts()[0]
        return f"<{type(self).__name__} {getattr(function, '__name__', type(function).__name__)}>"


class Restitution(_OfFunction):
    """A law of restitution: the coefficient ε in [0, 1] for an impact speed. Made by `restitution`."""

    def __init__(self, function: Callable[[float], float]) -> None:
        if not callable(function):
            raise wrong_type("restitution", function, "a function of the impact speed")
        self.function = function
        functools.update_wrapper(self, function)

    def __call__(self, impact_speed: float) -> float:
        return self.function(impact_speed)

    def table(self, speeds: ArrayLike) -> dict[str, Any]:
        """The law as a ``restitution`` of a scenario, which computes at the speed of Java's own.

        Between `speeds`, in cm/s and ascending, ε is linear, and constant below and beyond. The function is called with
        each of them, so it must take cm/s too. Where the scenario's unit of speed is another, its key
        ``units.speedInCmPerSecond`` says how many it is.

        Raises:
            InputError: a speed is not finite, or ε is not in [0, 1].
        """
        points = _arrays.numbers("speeds", speeds, ("n",)).tolist()
        function = self.function
        given = [[v, _coefficient(function, function(v), 0, f"at an impact speed of {v}")] for v in points]
        return {"type": "table", "points": given}

    def proxy(self, failure: PythonFailure) -> Any:
        """What Java calls."""
        function = self.function

        def coefficient(speed: float) -> float:
            speed = float(speed)
            return _coefficient(function, function(speed), 0, f"at an impact speed of {speed}")

        # JPype calls no default method that has arguments, so each is there.
        calls = {
            "coefficient": _kept(failure, coefficient),
            "restitution": _kept(failure, lambda contact: coefficient(contact.getNormalSpeed())),
        }
        return jpype.JProxy(java("daphnis.core.surface.Restitution"), dict=calls)


class Roughness(_OfFunction):
    """A law of tangential restitution: the coefficient β in [−1, 1] of a `Contact`. Made by `roughness`."""

    def __init__(self, function: Callable[[Contact], float]) -> None:
        if not callable(function):
            raise wrong_type("roughness", function, "a function of the contact")
        self.function = function
        functools.update_wrapper(self, function)

    def __call__(self, contact: Contact) -> float:
        return self.function(contact)

    def proxy(self, failure: PythonFailure) -> Any:
        """What Java calls."""
        function = self.function

        def coefficient(contact: Any) -> float:
            seen = Contact._of(contact, is_asked=False)
            return _coefficient(function, function(seen), -1, f"where surfaces slide at {seen.tangential_speed}")

        calls = {
            "coefficient": _kept(failure, coefficient),
            "change": _kept(failure, lambda contact: 1.0 + coefficient(contact)),
        }
        return jpype.JProxy(java("daphnis.core.surface.Roughness"), dict=calls)


class ContactLaw(_OfFunction):
    """A law of both coefficients, (ε, β) of a `Contact`. Made by `contact_law`."""

    def __init__(self, function: Callable[[Contact], tuple[float, float]]) -> None:
        if not callable(function):
            raise wrong_type("contact_law", function, "a function of the contact")
        self.function = function
        functools.update_wrapper(self, function)

    def __call__(self, contact: Contact) -> tuple[float, float]:
        return self.function(contact)

    def _both(self, contact: Contact) -> tuple[float, float]:
        given = self.function(contact)
        try:
            e, b = given
        except (TypeError, ValueError):
            name = getattr(self.function, "__name__", "contact_law")
            lost = "; does it lack a return?" if given is None else ""
            raise InputError(f"{name}: gives {given!r}; it must be a pair, (ε, β){lost}") from None
        return (
            _coefficient(self.function, e, 0, f"as ε at an impact speed of {contact.normal_speed}"),
            _coefficient(self.function, b, -1, f"as β where surfaces slide at {contact.tangential_speed}"),
        )

    def proxy(self, failure: PythonFailure) -> Any:
        """What Java calls: for ε first, and then in the same thread for β, if surfaces slide."""
        known: dict[int, tuple[Contact, float]] = {}

        def restitution(contact: Any) -> float:
            seen = Contact._of(contact, is_asked=True)
            e, b = self._both(seen)
            known[threading.get_ident()] = seen, b
            return e

        def roughness(contact: Any) -> float:
            seen = Contact._of(contact, is_asked=False)
            asked, b = known.pop(threading.get_ident(), (None, 0.0))
            # Where a guard made the impact elastic, nobody has asked for ε.
            return b if asked == seen._replace(restitution=None) else self._both(seen)[1]

        calls = {
            "isRough": lambda: True,
            "restitution": _kept(failure, restitution),
            "roughness": _kept(failure, roughness),
            "change": _kept(failure, lambda contact: 1.0 + roughness(contact)),
        }
        return jpype.JProxy(java("daphnis.core.surface.ContactLaw"), dict=calls)


class Laws(NamedTuple):
    """The laws of Python that take the place of the scenario's."""

    restitution: Restitution | None
    roughness: Roughness | None
    contact: ContactLaw | None

    def __bool__(self) -> bool:
        return any(law is not None for law in self)

    @property
    def parts(self) -> list[Any]:
        """What a `fingerprint` is taken of."""
        named = {"roughness": self.roughness, "contact_law": self.contact}
        return [self.restitution, *(part for word, law in named.items() if law is not None for part in (word, law))]


def _given(name: str, value: Any, shape: tuple[int, ...]) -> Any:
    if value is None:
        raise InputError(f"{name}: gives None; it must be an array of shape {shape}; does it lack a return?")
    return value


class Force(_OfFunction):
    """A force that changes velocities. Made by `kick` or `acceleration`."""

    def __init__(
        self,
        function: Callable[..., ArrayLike],
        takes_duration: bool,
        potential: Callable[[Spheres, float], ArrayLike] | None = None,
    ) -> None:
        for what in (function, potential):
            if what is not None and not callable(what):
                raise wrong_type("force", what, "a function")
        self.function = function
        self.potential = potential
        self._takes_duration = takes_duration
        functools.update_wrapper(self, function)

    def __call__(self, *arguments: Any) -> ArrayLike:
        return self.function(*arguments)

    def _parts(self) -> tuple[Any, ...]:
        return self.function, self._takes_duration, self.potential

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


Law = Callable[[float], float]
Surface = Callable[[Contact], float]
BothLaw = Callable[[Contact], "tuple[float, float]"]


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


def roughness(function: Callable[[Contact], float]) -> Roughness:
    """Makes a law of roughness of a function.

    ``function(contact)`` is given a `Contact`, with its ``restitution``, and gives the coefficient of tangential
    restitution β in [−1, 1]: −1 is smooth, 1 perfectly rough. Spheres then have spins. Otherwise as `restitution`.

        @daphnis.roughness
        def friction(contact):
            # Walton's law with μ = 0.3 and β₀ = 0.
            q = contact.moment_factor
            most = 0.3 * (1 + contact.restitution) * contact.normal_speed * (1 + q) / q
            return min(0.0, most / contact.tangential_speed - 1)
    """
    return Roughness(function)


def contact_law(function: Callable[[Contact], tuple[float, float]]) -> ContactLaw:
    """Makes a law of both coefficients of a function.

    ``function(contact)`` is given a `Contact` and gives (ε, β), ε in [0, 1] and β in [−1, 1]. The contact's
    ``restitution`` is None, or 1 where a guard has made the impact elastic: then only β counts. Spheres then have
    spins. Otherwise as `restitution`.

        @daphnis.contact_law
        def dusty(contact):
            r1, r2 = contact.radii
            return 0.9 if r1 + r2 > 1 else 0.5, 0.2
    """
    return ContactLaw(function)


@overload
def kick(
    function: Callable[[Spheres, float, float], ArrayLike],
    *,
    potential: Callable[[Spheres, float], ArrayLike] | None = None,
) -> Force: ...
@overload
def kick(
    function: None = None, *, potential: Callable[[Spheres, float], ArrayLike] | None = None
) -> Callable[[Callable[[Spheres, float, float], ArrayLike]], Force]: ...
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


@overload
def acceleration(
    function: Callable[[Spheres, float], ArrayLike], *, potential: Callable[[Spheres, float], ArrayLike] | None = None
) -> Force: ...
@overload
def acceleration(
    function: None = None, *, potential: Callable[[Spheres, float], ArrayLike] | None = None
) -> Callable[[Callable[[Spheres, float], ArrayLike]], Force]: ...
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


def as_laws(restitution: Law | None, roughness: Surface | None, contact: BothLaw | None) -> Laws:
    if contact is not None and (restitution is not None or roughness is not None):
        raise InputError("contact_law: gives both coefficients; restitution and roughness must be left out")
    return Laws(
        restitution if restitution is None or isinstance(restitution, Restitution) else Restitution(restitution),
        roughness if roughness is None or isinstance(roughness, Roughness) else Roughness(roughness),
        contact if contact is None or isinstance(contact, ContactLaw) else ContactLaw(contact),
    )


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
