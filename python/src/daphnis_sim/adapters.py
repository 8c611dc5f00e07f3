"""States for other programs that analyse particles, each of which is imported only when it is asked for."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError


class Snapshot(Protocol):
    """What the other programs get of a `daphnis_sim.State`, whose words these are."""

    @property
    def time(self) -> float: ...
    @property
    def step(self) -> int: ...
    @property
    def dimensions(self) -> int: ...
    @property
    def id(self) -> NDArray[np.int32]: ...
    @property
    def position(self) -> NDArray[np.float64]: ...
    @property
    def velocity(self) -> NDArray[np.float64]: ...
    @property
    def radius(self) -> NDArray[np.float64]: ...
    @property
    def mass(self) -> NDArray[np.float64]: ...
    @property
    def periodic(self) -> NDArray[np.bool_]: ...
    @property
    def cell(self) -> NDArray[np.float64]: ...
    def __len__(self) -> int: ...


def to_freud(state: Snapshot) -> tuple[Any, Any]:
    """``freud.box.Box`` and points of `state`."""
    try:
        import freud
    except ImportError as e:
        raise InputError(f"to_freud: needs freud: pip install freud-analysis ({e})") from None
    cell = _cell(state)
    _upright(state, "to_freud")
    is_flat = state.dimensions == 2
    # A box of freud leans along x by y and z, and along y by z.
    box = freud.box.Box(
        Lx=cell[0, 0],
        Ly=cell[1, 1],
        Lz=0 if is_flat else cell[2, 2],
        xy=cell[1, 0] / cell[1, 1],
        xz=0 if is_flat else cell[2, 0] / cell[2, 2],
        yz=0 if is_flat else cell[2, 1] / cell[2, 2],
        is2D=is_flat,
    )
    box.periodic = tuple(bool(axis) for axis in state.periodic)
    return box, np.ascontiguousarray(state.position, dtype=np.float32)


def to_ase(state: Snapshot) -> Any:
    """``ase.Atoms`` of `state`."""
    try:
        import ase
    except ImportError as e:
        raise InputError(f"to_ase: needs ASE: pip install ase ({e})") from None
    # ASE says no types.
    make: Any = ase.Atoms
    atoms = make(
        numbers=np.zeros(len(state), int),
        positions=state.position,
        masses=state.mass,
        cell=_cell(state),
        pbc=state.periodic,
    )
    atoms.set_velocities(state.velocity)
    atoms.set_array("radius", state.radius)
    atoms.set_array("id", state.id)
    atoms.info["time"] = state.time
    return atoms


def to_ovito(state: Snapshot) -> Any:
    """``ovito.data.DataCollection`` of `state`."""
    try:
        from ovito.data import DataCollection, Particles, SimulationCell
    except ImportError as e:
        raise InputError(f"to_ovito: needs OVITO: pip install ovito ({e})") from None
    cell = _cell(state)
    # Columns of OVITO's matrix are the edges, and the corner from which they go.
    matrix = np.column_stack([cell.T, -cell.sum(axis=0) / 2])
    data = DataCollection()
    box = SimulationCell(pbc=tuple(bool(axis) for axis in state.periodic), is2D=state.dimensions == 2)
    box[...] = matrix
    data.objects.append(box)
    particles = Particles(count=len(state))
    particles.create_property("Position", data=state.position)
    particles.create_property("Velocity", data=state.velocity)
    particles.create_property("Radius", data=state.radius)
    particles.create_property("Mass", data=state.mass)
    particles.create_property("Particle Identifier", data=state.id)
    data.objects.append(particles)
    data.attributes["Time"] = state.time
    data.attributes["Timestep"] = state.step
    return data


def _cell(state: Snapshot) -> Any:
    """Edges by row; along an open axis as long as the spheres reach, on both sides of the origin."""
    cell = np.array(state.cell, float)
    for axis in range(3):
        if not np.isfinite(cell[axis]).all():
            reach = np.abs(state.position[:, axis]) + state.radius if len(state) else np.zeros(1)
            cell[axis] = 0
            cell[axis, axis] = max(2 * float(reach.max()), 1e-6)
    return cell


def _upright(state: Snapshot, what: str) -> None:
    """Refuses a cell that leans along y by x, as in Hill's frame, which freud cannot say."""
    cell = _cell(state)
    if cell[0, 1] != 0 or cell[0, 2] != 0 or cell[1, 2] != 0:
        raise InputError(f"{what}: a box of freud leans along x, this one leans along y; take to_ase or to_ovito")
