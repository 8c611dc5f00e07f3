"""What the tests share. The jars are those of the installed wheel, or of the checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis

GAS: dict[str, Any] = {
    "box": {"lengths": [20, 20, 20]},
    "boundary": {"type": "periodic"},
    "restitution": {"type": "constant", "coefficient": 0.9},
    "timeStep": {"type": "fixed", "dt": 0.1},
}
PATCH = {"box.lengths": [40, 40, 20], "output.snapshotEvery": 20, "output.transportEvery": 5, "output.modesEvery": 20}


@pytest.fixture
def gas() -> dict[str, Any]:
    """Physics of a gas in a box, for arrays."""
    return GAS


@pytest.fixture
def spheres() -> dict[str, Any]:
    """1000 spheres on a lattice with velocities of a seed."""
    edge = np.arange(-9.0, 10.0, 2.0)
    position = np.stack(np.meshgrid(edge, edge, edge), -1).reshape(-1, 3)
    velocity = np.random.default_rng(1).normal(size=position.shape)
    return {"position": position, "velocity": velocity, "radius": 0.5, "mass": 1.0}


@pytest.fixture(scope="session")
def patch() -> dict[str, Any]:
    """Settings that make of `ring-patch` a small one, of 116 spheres."""
    return dict(PATCH)


@pytest.fixture(scope="session")
def ring(tmp_path_factory: pytest.TempPathFactory) -> daphnis.Run:
    """A small ring patch that has been run. Not to be changed."""
    path: Path = tmp_path_factory.mktemp("ring") / "run"
    return daphnis.run("ring-patch", path, set=PATCH, steps=60, threads=1)
