"""Scenarios: what a simulation is made of."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Union

import numpy as np

from ._arguments import checked
from ._errors import InputError, translated
from ._jvm import java, java_path

Settings = Mapping[str, Any]
"""Values for keys of a scenario, such as ``{"timeStep.dt": 0.05, "forces[0].massRatio": 1e-11}``."""


class Scenario:
    """A scenario with all its keys. Made by `scenario`; it does not change, and it can be pickled."""

    def __init__(self, java_scenario: Any, source: str) -> None:
        self._java = java_scenario
        self._source = source

    @property
    def name(self) -> str:
        return str(self._java.getName())

    @property
    def json(self) -> str:
        """The whole scenario with every default written out, as a file would hold it."""
        return str(java("daphnis.core.scenario.ScenarioJson").write(self._java))

    def to_dict(self) -> dict[str, Any]:
        """The whole scenario with every default, as Python has it."""
        found: dict[str, Any] = json.loads(self.json)
        return found

    @checked
    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes it as a file, for the command line too. A file of that name is replaced."""
        Path(path).write_text(self.json, encoding="utf-8")

    @property
    def is_hill(self) -> bool:
        """Whether it is in Hill's frame, of which are `omega` and `orbit`."""
        return self._speed() is not None

    @property
    def omega(self) -> float:
        """Angular speed Ω of Hill's frame, in radians per unit of time. Raises InputError where there is none."""
        speed = self._speed()
        if speed is None:
            raise InputError(f"{self._source}: is in no Hill's frame, so it has no omega and no orbit")
        return speed

    @property
    def kappa(self) -> float:
        """Radial frequency κ of epicycles, radians per unit time. Raises InputError where there is no Hill's frame."""
        return self.omega * float(self._frequencies().getRadialFactor())

    @property
    def nu(self) -> float:
        """Vertical frequency ν, radians per unit of time. Raises InputError where there is no Hill's frame."""
        return self.omega * float(self._frequencies().getVerticalFactor())

    @property
    def orbit(self) -> float:
        """Length of an orbit, 2π/Ω, in units of time. Raises InputError where there is no Hill's frame."""
        return 2 * math.pi / self.omega

    def _speed(self) -> float | None:
        frequencies = self._frequencies()
        return None if frequencies is None else float(frequencies.getOmega())

    def _frequencies(self) -> Any:
        with translated():
            return java("daphnis.core.scenario.FrameSetup").frequencies(self._java, self._source)

    @property
    def units(self) -> Units:
        """Names of its units."""
        return Units(self._java.getUnits())

    @property
    def java(self) -> Any:
        """The ``daphnis.core.scenario.Scenario``."""
        return self._java

    @property
    def source(self) -> str:
        """What messages call it."""
        return self._source

    def __reduce__(self) -> tuple[Any, ...]:
        """For ``pickle``: as JSON. Unpickling starts Java."""
        return _parsed, (self.json, self._source)

    def __repr__(self) -> str:
        return f"<Scenario {self.name!r}>"


ScenarioLike = Union[Scenario, str, os.PathLike[str], Mapping[str, Any]]
"""A scenario, the name of a built-in one, the path of a file, or what such a file holds."""


def _parsed(text: str, source: str) -> Scenario:
    """The scenario in the JSON `text`, whose paths are absolute."""
    with translated():
        return Scenario(java("daphnis.core.scenario.ScenarioJson").parse(text, source, _list([])), source)


class Units:
    """Names of units, such as "m" and "m/s"; those without a name are called by what they measure."""

    def __init__(self, java_units: Any) -> None:
        names = java("daphnis.analysis.table.UnitNames")(java_units)
        self.length = str(names.getLength())
        self.time = str(names.getTime())
        self.mass = str(names.getMass())

    def of(self, dimension: str) -> str:
        """The unit of a quantity whose dimension is written with the words length, time and mass."""
        unit = dimension
        for word, name in (("length", self.length), ("time", self.time), ("mass", self.mass)):
            if word not in dimension:
                continue
            if name.startswith("units of "):
                return f"units of {dimension}"
            unit = unit.replace(word, name)
        return unit

    def __repr__(self) -> str:
        return f"<Units length {self.length!r}, time {self.time!r}, mass {self.mass!r}>"


def scenarios() -> list[str]:
    """Names of the built-in scenarios."""
    return [str(name) for name in java("daphnis.core.scenario.BuiltIn").getNames()]


@checked
def scenario(what: ScenarioLike, *, set: Settings | None = None, seed: int | None = None) -> Scenario:
    """A built-in scenario, one of a file, or one of a dict.

    Args:
        what: the name of a built-in scenario, the path of a file, a dict with the same keys, or a `Scenario`. A file
            comes before a built-in scenario of the same name. Files that it names are relative to its own folder,
            those in a dict to the working directory.
        set: values for its keys, as ``--set`` of the command line: ``{"particles.opticalDepth": 0.5}``. NumPy's
            numbers and arrays are taken as well.
        seed: of the initial state.

    Raises:
        InputError: there is no such scenario, or something in it is wrong.
    """
    settings = dict(set or {})
    if seed is not None:
        settings["seed"] = seed
    changes = [f"{path}={_json(value, 'set: ' + str(path))}" for path, value in settings.items()]
    with translated():
        found, source = _read(what, changes)
        told = [change for change in changes if not change.startswith(("output.", "engine."))]
        description = str(found.getDescription())
        if description and told and "description" not in settings:
            # What the report says of the scenario may no longer hold.
            text = f"{description}; changed: {', '.join(told)}"
            found, source = _read(what, [*changes, f"description={json.dumps(text)}"])
    return Scenario(found, source)


def _read(what: ScenarioLike, settings: list[str]) -> tuple[Any, str]:
    parser = java("daphnis.core.scenario.ScenarioJson")
    if isinstance(what, Scenario):
        return (parser.parse(what.json, what.source, _list(settings)) if settings else what.java), what.source
    if isinstance(what, Mapping):
        source = "scenario"
        found = parser.parse(_json(what, source), source, _list(settings))
        return _at_home(found, Path.cwd()), source
    word = os.fspath(what)
    built_in = java("daphnis.core.scenario.BuiltIn")
    if isinstance(what, str) and word in [str(name) for name in built_in.getNames()] and not Path(word).is_file():
        return built_in.scenario(word, _list(settings)), word
    path = Path(word)
    if path.is_dir():
        raise InputError(f"{word}: is a directory; a scenario file or a built-in name is needed")
    if not path.exists():
        # Its message knows the names that there are.
        if os.sep not in word and not word.endswith(".json"):
            return built_in.scenario(word, _list(settings)), word
        raise InputError(f"{word}: no such file")
    return _at_home(parser.read(java_path(word), _list(settings)), path.resolve().parent), word


def _at_home(found: Any, home: Path) -> Any:
    return java("daphnis.core.run.ParticleFile").atHome(found, java_path(home))


def _list(words: list[str]) -> Any:
    return java("java.util.ArrayList")(words)


def _json(value: Any, what: str) -> str:
    try:
        return json.dumps(value, allow_nan=False, default=_plain)
    except (TypeError, ValueError) as e:
        raise InputError(f"{what}: cannot be written as JSON: {e}") from None


def _plain(value: Any) -> Any:
    if np.ma.is_masked(value):
        raise TypeError("it is masked")
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"{type(value).__name__} is not a number, text, list or dict")
