"""Runs in MDAnalysis, where it is installed."""

from __future__ import annotations

import os
import pickle
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


def test_a_universe_has_the_states_in_the_units_of_the_run(
    ring: daphnis.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("h5py")
    pytest.importorskip("MDAnalysis")
    file = tmp_path / "new" / "ring.h5md"
    universe = daphnis.universe(ring, file)
    states = list(ring.states())
    last = states[-1]
    assert np.array_equal(universe.atoms.ids, last.id)
    assert np.allclose(universe.atoms.masses, last.mass) and np.allclose(universe.atoms.radii, last.radius)
    assert len(universe.trajectory) == len(states)
    for frame, state in zip(universe.trajectory, states, strict=True):
        assert frame.time == state.time
        assert np.array_equal(frame.positions, state.position.astype(np.float32))
        assert np.array_equal(frame.velocities, state.velocity.astype(np.float32))
        # Sliding images lean.
        assert np.allclose(np.linalg.det(frame.triclinic_dimensions), 40 * 40 * 20, rtol=1e-5)
    assert set(universe.trajectory.units.values()) == {None}
    # Again, while the first is open, and by its path.
    again = daphnis.universe(str(ring.path), file)
    assert len(again.trajectory) == len(universe.trajectory)
    with pytest.raises(daphnis.InputError, match="no such file or directory"):
        daphnis.universe(tmp_path / "none")
    with monkeypatch.context() as other:
        other.setattr(os, "replace", lambda *_: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            daphnis.universe(ring, file)
    assert [entry.name for entry in file.parent.iterdir()] == ["ring.h5md"]


def test_each_frame_has_its_own_radii_where_spheres_grow(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    pytest.importorskip("MDAnalysis")
    growing = {"particles.count": 60, "particles.sizes": {"type": "equal", "radius": 0.3}, "until": 0.3}
    more = {"growth": {"rate": 0.2}, "output.snapshotInterval": 0.1, "output.transportInterval": 0.1}
    run = daphnis.run("elastic-gas", tmp_path / "run", set={**growing, **more})
    universe = daphnis.universe(run)
    states = list(run.states())
    assert states[-1].radius[0] > 1.05 * states[0].radius[0]
    for order in (1, -1):
        for frame in universe.trajectory[::order]:
            assert np.array_equal(universe.atoms.radii, states[frame.frame].radius)
    again = pickle.loads(pickle.dumps(universe))
    assert again.trajectory[1].frame == 1 and np.array_equal(again.atoms.radii, states[1].radius)
    with h5py.File(run.path / "export" / "trajectory.h5") as file:
        radius = file["particles/all/radius"]
        assert np.array_equal(radius["value"], np.array([state.radius for state in states]))
        assert np.array_equal(radius["time"], [state.time for state in states])
        assert radius["step"] == file["particles/all/position/step"]


def test_a_file_of_a_run_opens_with_one_option(patch: dict[str, Any], tmp_path: Path) -> None:
    pytest.importorskip("h5py")
    mdanalysis = pytest.importorskip("MDAnalysis")
    run = daphnis.run("ring-patch", tmp_path / "run", set=patch, steps=20)
    daphnis.universe(run)
    file = run.path / "export" / "trajectory.h5"
    universe = mdanalysis.Universe.empty(len(run.last()), trajectory=False)
    with pytest.raises(ValueError, match="units"):
        universe.load_new(str(file), format="H5MD")
    assert len(universe.load_new(str(file), format="H5MD", convert_units=False).trajectory) == 2


def test_without_mdanalysis_it_is_said_what_to_install(ring: daphnis.Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "MDAnalysis", None)
    with pytest.raises(daphnis.InputError, match="pip install MDAnalysis h5py"):
        daphnis.universe(ring)
    assert not (ring.path / "export").exists()
