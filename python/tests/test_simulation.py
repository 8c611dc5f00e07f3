"""Simulations in memory: arrays of every kind, two at once, closed."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


def advanced(gas: dict[str, Any], spheres: dict[str, Any], **others: Any) -> str:
    with daphnis.Simulation(gas, **{**spheres, **others}) as simulation:
        return simulation.advance(20).digest


@pytest.fixture
def digest(gas: dict[str, Any], spheres: dict[str, Any]) -> str:
    return advanced(gas, spheres)


def test_order_layout_type_and_engine_of_arrays_change_no_bit(
    gas: dict[str, Any], spheres: dict[str, Any], digest: str
) -> None:
    position, velocity = spheres["position"], spheres["velocity"]
    n = len(position)
    mixed = np.random.default_rng(2).permutation(n)
    wide = np.zeros((n, 6))
    wide[:, ::2] = position
    backward = np.ascontiguousarray(position[::-1])[::-1]
    frozen = velocity.copy()
    frozen.flags.writeable = False
    same = [
        {"position": position[mixed], "velocity": velocity[mixed], "id": mixed},
        {"position": np.asfortranarray(position), "velocity": frozen},
        {"position": wide[:, ::2], "radius": np.full(n, 0.5, np.float32), "mass": np.ones(n, np.int8)},
        {"position": backward.astype(">f8"), "id": np.arange(n, dtype=np.uint64)},
        {"position": position.tolist(), "engine": "horizon", "threads": 2},
        {"engine": "islands", "threads": 2},
    ]
    assert [advanced(gas, spheres, **others) for others in same] == [digest] * len(same)


def test_the_arrays_given_are_copied(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    before = spheres["position"].copy()
    with daphnis.Simulation(gas, **spheres) as simulation:
        simulation.advance(3)
        assert np.array_equal(spheres["position"], before)
        spheres["position"][:] = np.nan
        assert np.isfinite(simulation.state().position).all()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"position": np.zeros((3, 1000))}, r"position: has shape \(3, 1000\); it must be \(n, 3\)"),
        ({"position": np.zeros(3)}, r"position: has shape \(3,\)"),
        ({"position": [[1, 2, 3], [1, 2]]}, "rows differ in length"),
        ({"position": np.empty((0, 3))}, "position: has no row"),
        ({"position": "abc"}, "position: holds <U3"),
        ({"velocity": np.zeros((999, 3))}, r"velocity: has shape \(999, 3\); it must be \(1000, 3\)"),
        ({"velocity": np.zeros((1000, 3), complex)}, "velocity: holds complex128"),
        ({"radius": None}, "radius: is missing"),
        ({"radius": [0.5, 0.5]}, r"radius: has shape \(2,\); it must be \(1000,\)"),
        ({"radius": -0.5}, "radius of particle 0 is -0.5; it must be > 0"),
        ({"mass": np.nan}, "mass is nan; it must be finite"),
        ({"mass": 0}, "mass of particle 0 is 0.0"),
        ({"radius": 1.5}, "overlap by"),
        ({"id": np.zeros(1000, int)}, "id 0 occurs twice"),
        ({"id": np.arange(1000) - 1}, "ids must be in 0"),
        ({"id": np.arange(1000.0)}, "id: holds float64"),
        ({"id": np.arange(999)}, r"id: has shape \(999,\)"),
        ({"time": np.inf}, "time is inf"),
        ({"seed": 3}, "seed: is of an initial state"),
        ({"position": None}, "velocity: is given without position"),
    ],
)
def test_wrong_arrays_are_refused(
    gas: dict[str, Any], spheres: dict[str, Any], change: dict[str, Any], words: str
) -> None:
    with pytest.raises(daphnis.InputError, match=words) as caught:
        daphnis.Simulation(gas, **{**spheres, **change})
    assert "\n" not in str(caught.value)


def test_a_nan_is_named_by_its_place(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    spheres["velocity"][7, 2] = np.nan
    with pytest.raises(daphnis.InputError, match=r"velocity\[7, 2\] is nan; it must be finite"):
        daphnis.Simulation(gas, **spheres)


def test_masked_entries_are_named(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    n = len(spheres["position"])
    plain = daphnis.Simulation(gas, **spheres)
    for name in ("position", "velocity"):
        masked = np.ma.array(spheres[name])
        masked[7, 2] = np.ma.masked
        with pytest.raises(daphnis.InputError, match=rf"{name}\[7, 2\] is masked"):
            daphnis.Simulation(gas, **{**spheres, name: masked})
        whole = np.ma.array(spheres[name], mask=False)
        assert daphnis.Simulation(gas, **{**spheres, name: whole}).digest == plain.digest
    with pytest.raises(daphnis.InputError, match=r"id\[3\] is masked"):
        daphnis.Simulation(gas, **spheres, id=np.ma.array(range(n), mask=[k == 3 for k in range(n)]))


def test_a_sphere_outside_the_box_is_named(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    spheres["position"][5, 1] = 11
    with pytest.raises(daphnis.InputError, match="sphere 5 at y = 11.0 is outside the box, y from -10.0 to 10.0"):
        daphnis.Simulation(gas, **spheres)


def test_elastic_spheres_keep_energy_and_momentum(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    with daphnis.Simulation(gas, **spheres, set={"restitution.coefficient": 1}) as simulation:
        energy, momentum = simulation.kinetic_energy, simulation.momentum
        assert energy == pytest.approx((spheres["velocity"] ** 2).sum() / 2, rel=1e-14)
        simulation.advance_to(2.0)
        assert simulation.time == pytest.approx(2.0) and simulation.step == 20 and simulation.collisions > 100
        assert simulation.kinetic_energy == pytest.approx(energy, rel=1e-12)
        assert np.allclose(simulation.momentum, momentum, atol=1e-11)
        assert simulation.granular_temperature == pytest.approx(2 * energy / 3000, rel=0.01)


@pytest.fixture
def free(gas: dict[str, Any]) -> dict[str, Any]:
    """The gas, with steps that are chosen."""
    return {key: value for key, value in gas.items() if key != "timeStep"}


def test_chosen_steps_know_no_end_in_memory(free: dict[str, Any], spheres: dict[str, Any]) -> None:
    # A unit of time in which nothing happens: one as long as a step would end there.
    slow = {**spheres, "velocity": spheres["velocity"] * 1e-6}
    with daphnis.Simulation(free, **slow) as simulation:
        simulation.advance(4)
        assert simulation.time > 1e4
    with daphnis.Simulation(daphnis.scenario(free), **slow, time=1e9) as simulation:
        assert simulation.advance().time > 1e9 + 1e3
    with daphnis.Simulation(free, position=spheres["position"], radius=0.5) as simulation:
        assert simulation.advance(3).time == 3.0, "a gas at rest"


def test_chosen_steps_end_at_the_time_that_is_asked_for(free: dict[str, Any], spheres: dict[str, Any]) -> None:
    with daphnis.Simulation(free, **spheres) as simulation:
        for time in (0.3, 1.0, 7.7):
            assert simulation.advance_to(time).time == time
        assert simulation.advance().time > 7.7
    with daphnis.Simulation({**free, "until": 0.01}, **spheres) as simulation:
        assert simulation.advance_to(0.5).time == 0.5
        assert simulation.java.getTime() == 0.5
    with daphnis.Simulation({**free, "until": 0.01}, **spheres) as simulation:
        assert simulation.advance(2).time == 0.01, "a scenario's own end"
    with daphnis.Simulation({**free, "until": 2.05}, **spheres) as simulation:
        simulation.advance_to(0.5)
        while simulation.time < 2.05:
            simulation.advance()
        assert simulation.time == 2.05, "its own end holds afterwards"


def test_a_placed_state_may_be_late(gas: dict[str, Any], tmp_path: Path) -> None:
    particles = {"count": 50, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1}
    moving = {"particles": particles, "velocities": {"type": "gaussian", "sigma": 1.0}}
    made = {**gas, **moving, "until": 0.1, "output": {"snapshotEvery": 1}}
    daphnis.run(made, tmp_path / "run")
    file = sorted((tmp_path / "run" / "snapshots").iterdir())[-1]
    late = {**gas, "placement": {"type": "file", "path": str(file), "time": 50.0}}
    with daphnis.Simulation(late) as simulation:
        assert simulation.time == 50.0
        assert simulation.advance(2).time == pytest.approx(50.2)


def test_a_scenario_is_simulated_in_memory_as_in_a_directory(ring: daphnis.Run, patch: dict[str, Any]) -> None:
    with daphnis.Simulation("ring-patch", set=patch) as simulation:
        simulation.advance(60)
        assert simulation.digest == ring.summary["stateDigest"]
        assert simulation.state().units.length == "m"
        assert np.array_equal(simulation.state().position, ring.last().position)


def test_closed_simulations_are_read_but_not_advanced(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    simulation = daphnis.Simulation(gas, **spheres)
    simulation.advance(2)
    simulation.close()
    simulation.close()
    with pytest.raises(daphnis.RunError, match="the simulation is closed"):
        simulation.advance()
    assert simulation.step == 2 and len(simulation.state()) == 1000
    for steps in (-1, 1.5, True):
        with pytest.raises(daphnis.InputError, match="steps: is"):
            simulation.advance(steps)  # type: ignore[arg-type]


def test_two_simulations_go_on_at_once(gas: dict[str, Any], spheres: dict[str, Any], digest: str) -> None:
    found: list[str] = []
    workers = [threading.Thread(target=lambda: found.append(advanced(gas, spheres))) for _ in range(2)]
    for worker in workers:
        worker.start()
    with daphnis.Simulation(gas, **spheres) as one, daphnis.Simulation(gas, **spheres) as other:
        for _ in range(20):
            one.advance()
            other.advance()
        assert one.digest == other.digest == digest
    for worker in workers:
        worker.join()
    assert found == [digest, digest]


def test_rough_spheres_have_spins(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    rough = {**gas, "roughness": {"type": "constant", "coefficient": 1.0}, "restitution": {**gas["restitution"]}}
    rough["restitution"]["coefficient"] = 1.0
    spin = np.random.default_rng(2).normal(size=(1000, 3))
    with daphnis.Simulation(rough, **spheres, spin=spin) as simulation:
        assert np.array_equal(simulation.state().spin, spin)
        energy = simulation.kinetic_energy + 0.4 * 0.25 * (spin**2).sum() / 2
        simulation.advance_to(2.0)
        after = simulation.state()
        assert simulation.collisions > 100 and not np.array_equal(after.spin, spin)
        assert simulation.kinetic_energy + 0.4 * 0.25 * (after.spin**2).sum() / 2 == pytest.approx(energy, rel=1e-13)
        assert np.array_equal(after.to_frame()["omegay"], after.spin[:, 1])
    with daphnis.Simulation(rough, **spheres) as simulation:
        assert not simulation.state().spin.any()
    with daphnis.Simulation(gas, **spheres) as simulation:
        assert simulation.state().spin is None and "omegax" not in simulation.state().to_frame()
    with pytest.raises(daphnis.InputError, match="spin: is of spheres that spin; the scenario needs roughness"):
        daphnis.Simulation(gas, **spheres, spin=spin)
    with pytest.raises(daphnis.InputError, match="spin: has shape"):
        daphnis.Simulation(rough, **spheres, spin=spin[:5])


def test_a_run_has_the_spins_of_its_states(tmp_path: Any) -> None:
    ice = daphnis.restitution(lambda speed: 0.9)
    rough = {"particles.count": 100, "box.lengths": [6, 6, 6]}
    one = daphnis.run("rough-gas", tmp_path / "one", set=rough, steps=20)
    two = daphnis.run("rough-gas", tmp_path / "two", set=rough, steps=20, restitution=ice)
    assert one.last().spin.any() and np.array_equal(one.last().spin, two.last().spin)
    assert one.series["rotational_energy"].iloc[-1] > 0
    assert one.series.attrs["units"]["mean_spin_x"] == "units of 1/time"


def test_spheres_have_materials(gas: dict[str, Any], spheres: dict[str, Any], tmp_path: Any) -> None:
    sticky = {"type": "constant", "coefficient": 0.3}
    mixed = {**gas, "contacts": [{"between": ["ice", "rock"], "restitution": sticky}]}
    words = ["ice", "rock"] * 500
    ends = []
    for material, materials in ((words, None), (np.arange(1000) % 2, ["ice", "rock"]), (words, ["ice", "rock"])):
        with daphnis.Simulation(mixed, **spheres, material=material, materials=materials) as simulation:
            state = simulation.advance_to(2.0).state()
            assert state.materials == ["ice", "rock"]
            assert state.material is not None and np.array_equal(state.material, np.arange(1000) % 2)
            assert np.array_equal(state.to_frame()["material"], state.material)
            ends.append(simulation.digest)
    assert len(set(ends)) == 1
    with daphnis.Simulation(gas, **spheres) as simulation:
        state = simulation.advance_to(2.0).state()
        assert state.material is None and state.materials == [] and "material" not in state.to_frame()
        assert simulation.digest != ends[0]
    for wrong, message in (
        ({"material": words[:5]}, "material: has the shape"),
        ({"material": [0.5] * 1000}, "material: has the type float64; it must be names or whole numbers"),
        ({"material": [0] * 1000}, "materials: is missing"),
        ({"material": [2] * 1000, "materials": ["ice", "rock"]}, "material: has 2; it must be a number in 0..1"),
        ({"material": ["ice", "sand"] * 500, "materials": ["ice", "rock"]}, "material: has 'sand'"),
        ({"materials": ["ice"]}, "materials: is given without material"),
        ({"material": ["ice", "a b"] * 500}, "must be a word of at most 64 letters"),
    ):
        with pytest.raises(daphnis.InputError, match=message):
            daphnis.Simulation(mixed, **spheres, **wrong)
    run = daphnis.run("mixture", tmp_path / "run", set={"particles.count": 200, "box.lengths": [20, 20, 20]}, steps=20)
    last = run.last()
    assert last.materials == ["heavy", "light"] and np.bincount(last.material).tolist() == [100, 100]
    assert set(last.mass[last.material == 0]) == {8.0}
    assert run.series["temperature_heavy"].iloc[-1] > 0
    units = run.series.attrs["units"]
    assert set(units) == set(run.series.columns)
    assert units["temperature_heavy"] == units["kinetic_energy"] != ""
