"""States of a run for MDAnalysis."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._arguments import checked
from ._errors import InputError, translated
from ._jvm import java, java_path
from ._version import __version__
from .runs import Run

if TYPE_CHECKING:
    from MDAnalysis import Universe


@checked
def universe(run: Run | str | os.PathLike[str], file: str | os.PathLike[str] | None = None) -> Universe:
    """An ``MDAnalysis.Universe`` of all states of a run, through an H5MD file that is written for it.

    Atoms are the spheres in the order of ids, with ``ids``, ``masses`` and ``radii``, which are those of the present
    frame where spheres grow; frames are the states, with positions, velocities and the box. **All numbers are in the units of the scenario**, whatever MDAnalysis calls them:
    its own lengths are in Å and times in ps, it knows no metre, and so nothing is converted.

    MDAnalysis and h5py must be installed. MDAnalysis keeps numbers of 32 bits; the file has those of 64 bits. All
    states are in memory while it is written, and are read one by one afterwards.

    Args:
        run: the run or its path.
        file: the H5MD file; ``export/trajectory.h5`` in the run directory without it. One that is there is replaced.

    Raises:
        InputError: the run has no state, or spheres were removed, so that the atoms would not stay the same.
    """
    try:
        import MDAnalysis
        import MDAnalysis.coordinates.H5MD  # noqa: F401
    except ImportError as e:
        raise InputError(f"universe: needs MDAnalysis and h5py: pip install MDAnalysis h5py ({e})") from None
    if not isinstance(run, Run):
        run = Run(run)
    path = run.path / "export" / "trajectory.h5" if file is None else Path(os.path.abspath(file))
    path.parent.mkdir(parents=True, exist_ok=True)
    # A file that a Universe of before still reads stays what it is.
    new = path.with_name(f".{path.name}.{os.getpid()}")
    states = list(run.states())
    snapshots = java("java.util.ArrayList")([state.java for state in states])
    try:
        with translated():
            java("daphnis.core.format.H5md").write(snapshots, java_path(new), __version__)
        os.replace(new, path)
    finally:
        new.unlink(missing_ok=True)
    last = states[-1]
    atoms: Any = MDAnalysis.Universe.empty(len(last), trajectory=False)
    for name, values in (("ids", last.id), ("masses", last.mass), ("radii", last.radius)):
        # A copy: the Universe writes into what it is given.
        atoms.add_TopologyAttr(name, values.copy())
    universe: Universe = atoms.load_new(str(path), format="H5MD", convert_units=False)
    if any((state.radius != last.radius).any() for state in states):
        universe.trajectory.add_transformations(_Radii(universe, [state.radius for state in states]))
    return universe


class _Radii:
    """Gives the atoms of a Universe the radii of the frame that is read."""

    def __init__(self, universe: Universe, radii: list[Any]) -> None:
        self.universe = universe
        self.radii = radii

    def __call__(self, frame: Any) -> Any:
        self.universe.atoms.radii = self.radii[frame.frame]
        return frame
