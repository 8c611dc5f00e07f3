"""States for freud, ASE and OVITO, where they are installed."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


def sheared(gas: dict[str, Any], spheres: dict[str, Any]) -> daphnis.State:
    """A state whose images have slid along x."""
    physics = {**gas, "boundary": {"type": "lees-edwards", "shearRate": 0.3}, "timeStep": {"type": "fixed", "dt": 0.05}}
    with daphnis.Simulation(physics, **spheres) as simulation:
        return simulation.advance(10).state()


@pytest.fixture
def states(gas: dict[str, Any], spheres: dict[str, Any]) -> Iterator[list[daphnis.State]]:
    with daphnis.Simulation(gas, **spheres) as simulation:
        yield [simulation.advance(5).state(), sheared(gas, spheres)]


def neighbours(state: daphnis.State, reach: float) -> set[tuple[int, int]]:
    """Pairs up to `reach` apart, through the faces, by a search in all images."""
    found = set()
    shifts = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3), -1).reshape(-1, 3) @ state.cell
    for k, at in enumerate(state.position):
        for shift in shifts:
            near = np.linalg.norm(state.position + shift - at, axis=1) < reach
            found |= {(k, int(j)) for j in np.flatnonzero(near) if j != k}
    return found


def test_freud_finds_the_pairs_of_upright_and_of_leaning_boxes(states: list[daphnis.State]) -> None:
    freud = pytest.importorskip("freud")
    for state in states:
        box, points = state.to_freud()
        assert np.allclose(points, state.position, atol=1e-5) and tuple(box.periodic) == (True, True, True)
        query = freud.locality.AABBQuery(box, points)
        pairs = query.query(points, {"r_max": 1.7, "exclude_ii": True}).toNeighborList()
        assert {(int(i), int(j)) for i, j in pairs[:]} == neighbours(state, 1.7)


def test_ase_has_cell_velocities_and_distances(states: list[daphnis.State]) -> None:
    pytest.importorskip("ase")
    from ase.neighborlist import neighbor_list

    for state in states:
        atoms = state.to_ase()
        assert np.array_equal(atoms.positions, state.position) and np.array_equal(atoms.cell[:], state.cell)
        assert np.allclose(atoms.get_velocities(), state.velocity, rtol=1e-14)
        assert np.array_equal(atoms.arrays["radius"], state.radius) and np.array_equal(atoms.arrays["id"], state.id)
        i, j = neighbor_list("ij", atoms, 1.7)
        assert set(zip(i.tolist(), j.tolist(), strict=True)) == neighbours(state, 1.7)


def test_ovito_has_particles_and_cell(states: list[daphnis.State]) -> None:
    ovito = pytest.importorskip("ovito.data")
    for state in states:
        data = state.to_ovito()
        assert np.array_equal(data.particles["Position"][...], state.position)
        assert np.array_equal(data.particles["Radius"][...], state.radius)
        assert np.array_equal(data.particles["Particle Identifier"][...], state.id)
        assert np.allclose(data.cell[:, :3].T, state.cell) and all(data.cell.pbc)
        # The corner: the box is centred on the origin.
        assert np.allclose(data.cell[:, 3] + data.cell[:, :3].sum(axis=1) / 2, 0)
        assert data.attributes["Time"] == state.time
        finder = ovito.CutoffNeighborFinder(1.7, data)
        found = {(k, int(n.index)) for k in range(len(state)) for n in finder.find(k)}
        assert found == neighbours(state, 1.7)


def test_open_axes_and_frames_that_lean_along_y(ring: daphnis.Run) -> None:
    pytest.importorskip("ase")
    last = ring.last()
    atoms = last.to_ase()
    assert atoms.pbc.tolist() == [True, True, False] and np.isfinite(atoms.cell[:]).all()
    assert atoms.cell[2, 2] >= 2 * np.abs(last.z).max()
    pytest.importorskip("freud")
    assert last.cell[0, 1] != 0
    with pytest.raises(daphnis.InputError, match="leans along y; take to_ase or to_ovito"):
        last.to_freud()


def test_discs_have_a_flat_box() -> None:
    pytest.importorskip("freud")
    discs = daphnis.scenario("hard-discs", set={"particles.count": 100, "box.lengths": [20, 20]})
    with daphnis.Simulation(discs) as simulation:
        box, points = simulation.state().to_freud()
    assert box.is2D and (points[:, 2] == 0).all()


@pytest.mark.parametrize(
    ("module", "method", "package"),
    [("freud", "to_freud", "freud-analysis"), ("ase", "to_ase", "ase"), ("ovito.data", "to_ovito", "ovito")],
)
def test_a_library_that_is_missing_is_named_in_one_line(
    ring: daphnis.Run, monkeypatch: pytest.MonkeyPatch, module: str, method: str, package: str
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(daphnis.InputError, match=f"^{method}: needs .*pip install {package}") as error:
        getattr(ring.last(), method)()
    assert "\n" not in str(error.value)
