"""States: all spheres at one time."""

from __future__ import annotations

import functools
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _arrays, adapters
from ._errors import InputError, translated
from ._jvm import java, java_path
from ._version import __version__
from .scenarios import Units

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

    from .runs import Run

_VIEWS = {"top": (1, 0, 2, 1), "side": (1, 2, 0, 1), "along": (0, 2, 1, -1)}
"""Axes to the right, upward and along the sight, and the sign with which that points to the reader."""


class State:
    """All spheres at one time, in the order of their ids: of a snapshot, a checkpoint or a simulation.

    Java's arrays lie where Java may move them, so NumPy cannot look at them in place. Each array below is copied once,
    in bulk, when it is first used, and then kept; `x` … `vz` are views of `position` and `velocity` without a copy. The
    arrays are the reader's own: writing to them changes nothing else.

    Attributes:
        units: names of the units of a run's scenario; None where they are not known.
        run: the run of which it is, if it is of a recorded one.
    """

    def __init__(self, snapshot: Any, units: Any = None, run: Run | None = None) -> None:
        self._java = snapshot
        self.units = units
        self.run = run

    @property
    def java(self) -> Any:
        """The ``daphnis.core.format.Snapshot``, of which nothing may be changed."""
        return self._java

    @property
    def time(self) -> float:
        """In units of time."""
        return float(self._java.getTime())

    @property
    def step(self) -> int:
        """Steps since the start of the run."""
        return int(self._java.getStep())

    @property
    def dimensions(self) -> int:
        """2 where all spheres are in the plane z = 0 and stay there, as discs do; else 3."""
        return 2 if self._java.isInPlane() else 3

    def __len__(self) -> int:
        return int(self._java.getSize())

    @functools.cached_property
    def id(self) -> NDArray[np.int32]:
        """Ids, shape (n,), ascending, with gaps where spheres were removed."""
        return _arrays.of_ints(self._java.getId())

    @functools.cached_property
    def position(self) -> NDArray[np.float64]:
        """Centres, shape (n, 3), in units of length; each of the three columns is contiguous."""
        return _arrays.columns(*self._java.getPosition())

    @functools.cached_property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities, shape (n, 3), in units of length per unit of time; in Hill's frame in the rotating frame."""
        return _arrays.columns(*self._java.getVelocity())

    @functools.cached_property
    def spin(self) -> NDArray[np.float64] | None:
        """Angular velocities, shape (n, 3), in radians per unit of time, in Hill's frame relative to the frame.

        None for spheres without spin.
        """
        if not self._java.getHasSpin():
            return None
        return _arrays.columns(self._java.getWx(), self._java.getWy(), self._java.getWz())

    @functools.cached_property
    def material(self) -> NDArray[np.int64] | None:
        """Numbers of materials, shape (n,), of which `materials` has the names; None for spheres without any."""
        if not self._java.getHasMaterials():
            return None
        return _arrays.of_doubles(self._java.getMaterial()).astype(np.int64)

    @property
    def materials(self) -> list[str]:
        """Names of materials by number; empty for spheres without any."""
        return [str(name) for name in self._java.getMaterials()]

    @functools.cached_property
    def radius(self) -> NDArray[np.float64]:
        """Radii, shape (n,), in units of length."""
        return _arrays.of_doubles(self._java.getRadius())

    @functools.cached_property
    def mass(self) -> NDArray[np.float64]:
        """Masses, shape (n,), in units of mass."""
        return _arrays.of_doubles(self._java.getMass())

    @functools.cached_property
    def image(self) -> NDArray[np.int32] | None:
        """Boxes crossed since the start, shape (n, 3); ``position + image @ cell`` is the place without wrapping.

        None where it is not known.
        """
        image = self._java.getImage()
        return None if image is None else np.stack([_arrays.of_ints(axis) for axis in image], axis=1)

    @functools.cached_property
    def box(self) -> NDArray[np.float64]:
        """Edges along x, y and z, shape (3,), in units of length, the box centred on the origin; NaN on open axes."""
        return _arrays.of_doubles(self._java.getLengths())

    @functools.cached_property
    def periodic(self) -> NDArray[np.bool_]:
        """Whether the box repeats along x, y and z, shape (3,)."""
        return np.array([bool(axis) for axis in self._java.getPeriodic()])

    @functools.cached_property
    def cell(self) -> NDArray[np.float64]:
        """Edge vectors of the box by row, shape (3, 3), in units of length; one leans where images slide."""
        return np.stack([_arrays.of_doubles(row) for row in self._java.edges()])

    x = property(lambda self: self.position[:, 0], doc="First column of `position`: radially outward in Hill's frame.")
    y = property(lambda self: self.position[:, 1], doc="Second column of `position`: along the orbit in Hill's frame.")
    z = property(lambda self: self.position[:, 2], doc="Third column of `position`: vertical.")
    vx = property(lambda self: self.velocity[:, 0], doc="First column of `velocity`.")
    vy = property(lambda self: self.velocity[:, 1], doc="Second column of `velocity`.")
    vz = property(lambda self: self.velocity[:, 2], doc="Third column of `velocity`.")

    def to_frame(self) -> pd.DataFrame:
        """All spheres as a table with a row for each, indexed by id; units in ``attrs["units"]``."""
        import pandas as pd

        names = [str(name) for name in self._java.getColumnNames()]
        places = dict(zip(names, [int(place) for place in self._java.getColumnPlaces()], strict=True))
        table = pd.DataFrame(
            {name: _arrays.of_doubles(self._java.column(place)) for name, place in places.items()},
            index=pd.Index(self.id, name="id"),
        )
        if self.units is not None:
            table.attrs["units"] = {
                name: self.units.of(str(self._java.dimension(place))) for name, place in places.items()
            }
        return table

    def to_freud(self) -> tuple[Any, Any]:
        """``(box, points)`` for `freud <https://freud.readthedocs.io>`_, which computes order and structure.

        The box is a ``freud.box.Box`` with its lean and its periodic axes, two-dimensional for discs; points are of
        32 bits, shape (n, 3), in the order of ids. Along an open axis the box is as long as the spheres reach. It needs
        ``pip install freud-analysis``.

        Raises:
            InputError: images have slid along y, as in Hill's frame: a box of freud leans along x only.
        """
        return adapters.to_freud(self)

    def to_ase(self) -> Any:
        """``ase.Atoms`` with positions, velocities, masses, cell and periodic axes, in the order of ids.

        Atoms are of the element X with arrays ``radius`` and ``id``, and ``info["time"]``. All numbers are in the units
        of the scenario: nothing is converted to Å and ASE's units. It needs ``pip install ase``.
        """
        return adapters.to_ase(self)

    def to_ovito(self) -> Any:
        """An ``ovito.data.DataCollection`` with particles and cell, for OVITO's modifiers and pictures.

        Particles are in the order of ids, with their radii, velocities and masses. It needs ``pip install ovito``.
        """
        return adapters.to_ovito(self)

    def plot(self, ax: Axes | None = None, *, view: str = "top", color: Any = None, **keywords: Any) -> Axes:
        """Draws the spheres to scale with matplotlib.

        Args:
            ax: where to draw; a new figure without it.
            view: "top" shows y to the right and x upward, "side" y to the right and z upward, "along" x to the right
                and z upward, as seen along y.
            color: a number for each sphere, shape (n,), in the order of ids. Without it the coordinate toward the
                reader.
            keywords: for matplotlib's ``EllipseCollection``, such as ``cmap``.

        Returns:
            The axes. Their last collection is a mappable for ``colorbar``.
        """
        if view not in _VIEWS:
            raise InputError(f"view: is {view!r}; it must be one of {', '.join(_VIEWS)}")
        from matplotlib import pyplot
        from matplotlib.collections import EllipseCollection

        right, upward, toward, sign = _VIEWS[view]
        depth = sign * self.position[:, toward]
        values = depth if color is None else _arrays.numbers("color", color, (len(self),))
        # What is nearer to the reader lies above.
        order = np.argsort(depth, kind="stable")
        discs = 2 * self.radius[order]
        if ax is None:
            ax = pyplot.subplots()[1]
        drawn = EllipseCollection(
            discs,
            discs,
            np.zeros(len(self)),
            units="xy",
            transOffset=ax.transData,
            offsets=self.position[order][:, (right, upward)],
            array=values[order],
            **keywords,
        )
        ax.add_collection(drawn)
        ax.set_aspect("equal")
        for axis, limit, name in ((right, ax.set_xlim, ax.set_xlabel), (upward, ax.set_ylim, ax.set_ylabel)):
            limit(self._limits(axis))
            name("xyz"[axis] if self.units is None else f"{'xyz'[axis]} [{self.units.length}]")
        return ax

    def _limits(self, axis: int) -> tuple[float, float]:
        """What to show along `axis`: the box where it repeats, else all spheres."""
        if self.periodic[axis]:
            return -self.box[axis] / 2, self.box[axis] / 2
        if len(self) == 0:
            return -1.0, 1.0
        ends = self.position[:, axis]
        return float((ends - self.radius).min()), float((ends + self.radius).max())

    def __copy__(self) -> State:
        """The same arrays."""
        other = State(self._java, self.units, self.run)
        other.__dict__.update(self.__dict__)
        return other

    def __deepcopy__(self, known: dict[int, Any]) -> State:
        """Arrays of its own, with what was written to them."""
        other = self.__copy__()
        arrays = {name: value.copy() for name, value in self.__dict__.items() if isinstance(value, np.ndarray)}
        other.__dict__.update(arrays)
        return other

    def __reduce__(self) -> tuple[Any, ...]:
        """For ``pickle``: all numbers with their bits, and the units, but not the run. Unpickling starts Java."""
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "state.h5"
            with translated():
                java("daphnis.core.format.H5md").write(
                    java("java.util.List").of(self._java), java_path(path), __version__
                )
            return _unpickled, (path.read_bytes(), self.units)

    def __repr__(self) -> str:
        return f"<State of {len(self)} spheres at time {self.time:.10g}, step {self.step}>"


def _unpickled(content: bytes, units: Units | None) -> State:
    """The state in the H5MD file `content`."""
    with tempfile.TemporaryDirectory() as directory:
        path = Path(directory) / "state.h5"
        path.write_bytes(content)
        with translated():
            return State(java("daphnis.core.format.SnapshotFormats").read(java_path(path)).get(0), units)
