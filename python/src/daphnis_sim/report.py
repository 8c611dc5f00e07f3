"""What an analysis gives."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import pandas as pd

from . import _arrays
from ._arguments import checked, wrong_type
from ._errors import InputError, noted, translated
from ._jvm import java, java_path
from ._paths import shown_path
from .scenarios import ScenarioLike
from .scenarios import scenario as as_scenario
from .tables import Tables, read_table

_MOST = 100_000
_LAWS = ("lambert", "lommel-seeliger", "tabulated")


class Picture:
    """A picture of a report. A notebook shows it.

    Attributes:
        path: of its PNG; the SVG lies beside it.
    """

    def __init__(self, path: Path) -> None:
        self.path = path

    @property
    def png(self) -> bytes:
        return self.path.read_bytes()

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        return f"<Picture {shown_path(self.path)!r}>"


class Pictures(Mapping[str, Picture]):
    """The pictures that ``analyze`` drew, by name."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory

    def __getitem__(self, name: str) -> Picture:
        if name not in list(self):
            raise KeyError(f"{name!r}: no such picture in {self._directory}; there are {', '.join(self)}")
        return Picture(self._directory / f"{name}.png")

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(path.stem for path in self._directory.glob("*.png")))

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __repr__(self) -> str:
        return f"<pictures in {shown_path(self._directory)!r}: {', '.join(self)}>"


class Report:
    """What ``analyze`` wrote into a directory. A notebook shows its numbers.

    Attributes:
        path: the directory.
        notices: what a reader should know of the files, a line each.
    """

    def __init__(self, path: Path, notices: list[str]) -> None:
        self.path = path
        self.notices = notices

    @property
    def html(self) -> Path:
        """The page, self-contained: ``report.html``."""
        return self.path / "report.html"

    @property
    def numbers(self) -> pd.DataFrame:
        """The numbers of the report, indexed by the keys of docs/reference/numbers.md.

        Columns: ``value``; ``standard_error``, NaN where none can be given; ``unit``; ``reference``, what is published,
        else NaN, and ``reference_bound``, how far off that may be; ``remark``, why there is no error, else empty.
        """
        table = read_table(self.path / "tables" / "numbers.csv").set_index("quantity")
        for name in ("unit", "remark"):
            # As objects, since a column that is empty throughout is read as numbers.
            table[name] = table[name].astype(object).fillna("").astype(str)
        floats = ("value", "standard_error", "reference", "reference_bound")
        return table.astype({name: float for name in floats if name in table})

    @property
    def tables(self) -> Tables:
        """Its tables by name, such as ``report.tables["profile-vertical"]``; units in ``attrs["units"]``."""
        return Tables(self.path / "tables")

    @property
    def pictures(self) -> Pictures:
        """Its pictures by name."""
        return Pictures(self.path / "plots")

    def __getitem__(self, key: str) -> float:
        """The value of a number: ``report["velocity_dispersion"]``."""
        numbers = self.numbers
        if key not in numbers.index:
            raise KeyError(f"{key!r}: no such number in this report; there are {', '.join(numbers.index)}")
        return float(numbers["value"][key])

    def _repr_html_(self) -> str:
        return str(self.numbers.to_html(na_rep="", float_format=lambda value: f"{value:.5g}"))

    def __repr__(self) -> str:
        return f"<Report {shown_path(self.html)!r}>"


class _InDirectory(Protocol):
    """What has a directory: a `Run`."""

    path: Path


@checked
def analyze(
    what: _InDirectory | str | os.PathLike[str],
    *,
    scenario: ScenarioLike | None = None,
    time_step: float | None = None,
    from_: float | None = None,
    slabs: int = 0,
    groups: int = 0,
    elevation: float = 28.0,
    azimuth: float = 0.0,
    cluster_ratio: float | None = None,
    frames: int = 40,
    elevations: Sequence[float] = (),
    azimuths: int = 12,
    footprint: float | Sequence[float] | None = None,
    scan_path: float = 0.0,
    photons: float | None = None,
    observed: str | os.PathLike[str] | None = None,
    brightness: str | None = None,
    albedo: float = 1.0,
    phase_function: str | os.PathLike[str] | None = None,
    light_elevation: float | None = None,
    phase_angle: float | None = None,
    phase_angles: Sequence[float] = (),
    orders: int = 1,
    paths: int = 4096,
    brightness_seed: int = 1,
    observed_brightness: str | os.PathLike[str] | None = None,
    out: str | os.PathLike[str] | None = None,
    accept_loss: bool = False,
) -> Report:
    """Analyses a run or a file of states, as ``daphnis analyze`` does, and writes ``report.html``, tables and pictures.

    Args:
        what: a `Run`, the path of a run directory, or of a file of states (H5MD, extended XYZ, LAMMPS, …).
        scenario: what box, frame and units of a file are, or of a run with laws or forces of Python.
        time_step: time of a step, for a file that has no times.
        from_: averages begin at this time, in units of time; without it after 3/8 of the run, or where it is steady.
        slabs: slabs of azimuth for streamlines; 0 chooses by the number of particles.
        groups: groups of equal count in each; 0 as for `slabs`.
        elevation: of the rays of the occultation above the x-y plane, in degrees, in 0.1..90.
        azimuth: direction in which they climb, from x toward y, in degrees.
        cluster_ratio: spheres up to so many sums of their radii apart are in one cluster, in 1..100; without it those
            that attract each other.
        frames: states that are averaged at most.
        elevations: of a grid of lines of sight along which the transmission is computed, in degrees; none for no grid.
        azimuths: of this grid, so many, evenly over half a turn.
        footprint: of an instrument whose light curves are simulated: the diameter of a disc, or length along the path
            and width across it, in the scenario's unit of length; none without it.
        scan_path: direction of this path in the plane, from x toward y, in degrees.
        photons: mean number of photons per footprint where nothing is in the way; no noise without it.
        observed: path of a CSV of what was observed: elevation, azimuth, optical_depth or transmission, error.
        brightness: law of scattering of the spheres, ``lambert``, ``lommel-seeliger`` or ``tabulated``, for I/F over
            `elevations` and over `azimuths` of a whole turn; no brightness without it.
        albedo: of that law, in 0..1.
        phase_function: path of a CSV of phase_angle, phase_function: of grains with ``lommel-seeliger``, of spheres
            with ``tabulated``.
        light_elevation: of the light, in degrees, below 0 for light from below; that of the eye without it.
        phase_angle: of that grid, in degrees, below 0 with the light at smaller azimuths; the least without it.
        phase_angles: over which I/F is computed at `elevation` and `azimuth`, in degrees; a choice without them.
        orders: of scattering that are computed, in 1..100.
        paths: random paths per state for those from the second on.
        brightness_seed: of these paths.
        observed_brightness: path of a CSV of what was observed: elevation, azimuth, light_elevation, phase_angle,
            i_over_f, error.
        out: where to write; into the run directory without it, beside a file as NAME-analysis.
        accept_loss: whether files that differ from what the run wrote are accepted.

    Raises:
        InputError: something above is wrong.
        FormatError: a file is damaged.
    """
    _check(slabs, groups, elevation, azimuth, frames)
    place = what if isinstance(what, (str, os.PathLike)) else getattr(what, "path", None)
    if not isinstance(place, (str, os.PathLike)):
        raise wrong_type("what", what, "a Run, or a path of a run directory or of a file of states")
    path = Path(place)
    there = java_path(path)
    inputs = java("daphnis.analysis.input.AnalysisInput")
    with translated():
        given = None if scenario is None else as_scenario(scenario)
        if path.is_file():
            step = None if time_step is None else java("java.lang.Double")(time_step)
            source = inputs.ofFile(there, given and given.java, "" if given is None else given.source, step)
            directory = path.with_name(f"{path.name}-analysis")
        elif time_step is not None:
            raise InputError(f"time_step: is {time_step}; it is for files, and runs have times")
        else:
            source = inputs.ofRun(there, accept_loss, given and given.java)
            directory = path
        if out is not None:
            directory = Path(out)
        begin = None if from_ is None else java("java.lang.Double")(from_)
        light = _light(elevations, azimuths, footprint, scan_path, photons, observed)
        bright = None
        if brightness is not None:
            law = _law(brightness, albedo, phase_function)
            seen = (orders, paths, brightness_seed, observed_brightness)
            bright = _brightness(law, light_elevation, phase_angle, phase_angles, *seen)
        elif (
            phase_function is not None
            or light_elevation is not None
            or phase_angle is not None
            or len(phase_angles) > 0
            or (albedo, orders, paths, brightness_seed) != (1.0, 1, 4096, 1)
            or observed_brightness is not None
        ):
            raise InputError("brightness: is not given; albedo, phase angles and the like are given with it")
        kind = java("daphnis.analysis.report.AnalysisOptions")
        near = None if cluster_ratio is None else java("java.lang.Double")(cluster_ratio)
        options = kind(begin, slabs, groups, elevation, frames, azimuth, light, near, bright)
        java("daphnis.analysis.report.Analysis")(source, options).write(java_path(directory))
    notices = [str(notice) for notice in source.getNotices()]
    noted(notices)
    return Report(Path(os.path.abspath(directory)), notices)


def _light(
    elevations: Sequence[float],
    azimuths: int,
    footprint: float | Sequence[float] | None,
    scan_path: float,
    photons: float | None,
    observed: str | os.PathLike[str] | None,
) -> Any:
    """The OccultationOptions of Java."""
    kind = java("daphnis.analysis.occultation.Footprint")
    if footprint is None:
        seen = None
    else:
        sizes = (footprint,) if isinstance(footprint, (int, float)) else footprint
        if len(sizes) not in (1, 2) or not all(0 < size < float("inf") for size in sizes):
            raise InputError(f"footprint: is {footprint}; it must be a length > 0, or two such")
        seen = kind.disc(float(sizes[0])) if len(sizes) == 1 else kind.rectangle(*map(float, sizes))
    table = None
    if observed is not None:
        table = java("daphnis.analysis.occultation.ObservedDepths").read(java_path(Path(observed)))
    number = None if photons is None else java("java.lang.Double")(photons)
    heights = _arrays.doubles(np.array(elevations, float))
    return java("daphnis.analysis.report.OccultationOptions")(heights, azimuths, seen, scan_path, number, table)


def _law(name: str, albedo: float, phase_function: str | os.PathLike[str] | None) -> Any:
    """The ScatteringLaw of Java."""
    laws = java("daphnis.analysis.brightness.ScatteringLaw")
    if name not in _LAWS:
        raise InputError(f"brightness: is {name}; it must be one of {', '.join(_LAWS)}")
    if not 0 <= albedo <= 1:
        raise InputError(f"albedo: is {albedo}; it must be in 0..1")
    if name == "lambert" and phase_function is not None:
        raise InputError(f"phase_function: is {phase_function}; it must be given with lommel-seeliger or tabulated")
    if name == "tabulated" and phase_function is None:
        raise InputError("brightness: is tabulated; it must be given with phase_function")
    tables = java("daphnis.analysis.brightness.PhaseTable")
    table = None if phase_function is None else tables.read(java_path(Path(phase_function)))
    if name == "lambert":
        return laws.lambert(float(albedo))
    if name == "lommel-seeliger":
        return laws.lommelSeeliger(float(albedo), table)
    return laws.ofSpheres(float(albedo), table)


def _brightness(
    law: Any,
    light_elevation: float | None,
    phase_angle: float | None,
    phase_angles: Sequence[float],
    orders: int,
    paths: int,
    seed: int,
    observed: str | os.PathLike[str] | None,
) -> Any:
    """The BrightnessOptions of Java."""
    double = java("java.lang.Double")
    light = None if light_elevation is None else double(light_elevation)
    phase = None if phase_angle is None else double(phase_angle)
    table = None
    if observed is not None:
        table = java("daphnis.analysis.brightness.ObservedBrightness").read(java_path(Path(observed)))
    angles = _arrays.doubles(np.array(phase_angles, float))
    kind = java("daphnis.analysis.report.BrightnessOptions")
    return kind(law, light, phase, angles, orders, paths, seed, table)


def _check(slabs: int, groups: int, elevation: float, azimuth: float, frames: int) -> None:
    for name, value, holds, right in (
        ("slabs", slabs, 0 <= slabs <= _MOST, f"in 1..{_MOST}, or 0"),
        ("groups", groups, 0 <= groups <= _MOST, f"in 1..{_MOST}, or 0"),
        ("elevation", elevation, 0.1 <= elevation <= 90, "in 0.1..90 degrees"),
        ("azimuth", azimuth, -360 <= azimuth <= 360, "in -360..360 degrees"),
        ("frames", frames, frames >= 1, "at least 1"),
    ):
        if not holds:
            raise InputError(f"{name}: is {value}; it must be {right}")
