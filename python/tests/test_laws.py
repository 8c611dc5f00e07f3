"""Laws and forces of Python: the same bits with every engine, and exceptions that leave the state as it was."""

from __future__ import annotations

import math
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


@daphnis.restitution
def ice(speed: float) -> float:
    return float(min(1.0, 0.6 * speed**-0.234)) if speed > 0 else 1.0


@daphnis.acceleration(potential=lambda spheres, time: 5e-11 * (spheres.mass[:, None] * spheres.position**2).sum(1))
def spring(spheres: daphnis.Spheres, time: float) -> Any:
    return -1e-10 * spheres.position


def test_a_law_of_python_gives_the_same_bits_with_every_engine(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    threads: set[int] = set()

    def law(speed: float) -> float:
        threads.add(threading.get_ident())
        return ice(speed)

    digests = set()
    for engine, count in (("serial", 1), ("horizon", 2), ("islands", 2), ("thread-pool", 2)):
        with daphnis.Simulation(gas, **spheres, engine=engine, threads=count, restitution=law, forces=[spring]) as one:
            digests.add(one.advance(10).digest)
    assert len(digests) == 1
    # A thread that wakes late finds all done by others.
    with daphnis.Simulation(gas, **spheres, engine="thread-pool", threads=2, restitution=law) as one:
        for _ in range(100):
            if len(threads) == 1:
                one.advance(10)
    assert len(threads) > 1, "no engine called the law from a thread of its own"


def test_a_law_of_python_is_that_of_java_when_it_gives_the_same(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    with daphnis.Simulation(gas, **spheres, restitution=lambda speed: 0.9) as python:
        with daphnis.Simulation(gas, **spheres) as java:
            assert python.advance(20).digest == java.advance(20).digest
            assert python.collisions > 100


@pytest.mark.parametrize("engine", ["serial", "horizon", "islands", "thread-pool", "actors"])
def test_an_exception_in_a_law_leaves_the_state_to_the_bit(
    gas: dict[str, Any], spheres: dict[str, Any], engine: str
) -> None:
    broken = False

    def law(speed: float) -> float:
        if broken:
            raise ZeroDivisionError("in the law")
        return 0.9

    threads = 1 if engine == "serial" else 2
    with daphnis.Simulation(gas, **spheres, engine=engine, threads=threads, restitution=law) as simulation:
        digest = simulation.advance(5).digest
        broken = True
        for _ in range(2):
            with pytest.raises(ZeroDivisionError, match="in the law"):
                simulation.advance()
        assert (simulation.digest, simulation.step) == (digest, 5)
        broken = False
        after = simulation.advance(5).digest
    with daphnis.Simulation(gas, **spheres) as undisturbed:
        assert undisturbed.advance(10).digest == after


@pytest.mark.parametrize("value", [1.5, -0.1, float("nan"), "0.5x", None])
def test_a_law_that_gives_no_coefficient_is_refused(gas: dict[str, Any], spheres: dict[str, Any], value: Any) -> None:
    with daphnis.Simulation(gas, **spheres, restitution=lambda speed: value) as simulation:
        with pytest.raises((ValueError, TypeError)) as caught:
            simulation.advance(10)
        if isinstance(value, float):
            assert "it must be in [0, 1]" in str(caught.value)


def test_a_force_sees_the_spheres_in_the_order_of_ids(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    seen: list[Any] = []

    @daphnis.kick
    def look(spheres: daphnis.Spheres, time: float, duration: float) -> Any:
        seen.append((time, duration, spheres.id.copy(), spheres.position.copy(), spheres.mass.copy()))
        assert spheres.radius.shape == (len(spheres),) and not spheres.velocity.flags.writeable
        return np.zeros((len(spheres), 3))

    with daphnis.Simulation(gas, **spheres, forces=[look]) as simulation:
        state = simulation.advance(3).state()
    assert len(seen) == 6 and all(duration == 0.05 for _, duration, *_ in seen)
    assert all(np.array_equal(id, np.arange(1000)) for _, _, id, _, _ in seen)
    assert np.array_equal(seen[-1][3], state.position)


def test_an_acceleration_acts_for_the_whole_step(gas: dict[str, Any]) -> None:
    one = {"position": [[0.0, 0.0, 0.0]], "radius": 0.5}
    with daphnis.Simulation(gas, **one, forces=[daphnis.acceleration(lambda s, t: [[0, 2.0, 0]])]) as simulation:
        state = simulation.advance(5).state()
        assert state.velocity[0] == pytest.approx([0, 1.0, 0]) and state.y[0] == pytest.approx(0.25)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (lambda s, t: np.zeros((3, len(s))), r"it must be \(1000, 3\)"),
        (lambda s, t: 0.0, r"it must be \(1000, 3\)"),
        (lambda s, t: np.full((len(s), 3), np.inf), "it must be finite"),
        (lambda s, t: None, "gives None; it must be an array"),
    ],
)
def test_a_force_that_gives_no_accelerations_is_refused(
    gas: dict[str, Any], spheres: dict[str, Any], given: Any, words: str
) -> None:
    with daphnis.Simulation(gas, **spheres, forces=[daphnis.acceleration(given)]) as simulation:
        digest = simulation.digest
        with pytest.raises(daphnis.InputError, match=words):
            simulation.advance()
        assert simulation.digest == digest and simulation.step == 0


def test_a_force_that_fails_after_the_drift_leaves_the_state(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    calls = 0

    def fails_second(spheres: daphnis.Spheres, time: float) -> Any:
        nonlocal calls
        calls += 1
        if calls == 2:
            raise RuntimeError("after the drift")
        return -spheres.velocity

    with daphnis.Simulation(gas, **spheres, forces=[daphnis.acceleration(fails_second)]) as simulation:
        digest = simulation.digest
        with pytest.raises(RuntimeError, match="after the drift"):
            simulation.advance()
        assert simulation.digest == digest


def test_a_step_within_a_step_is_refused(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    def law(speed: float) -> float:
        simulation.advance()
        return 0.9

    with daphnis.Simulation(gas, **spheres, restitution=law) as simulation:
        with pytest.raises(daphnis.RunError, match="advance\\(\\) was called from within it"):
            simulation.advance(10)


def test_a_run_with_a_law_goes_on_to_the_same_bits_and_with_that_law_only(
    patch: dict[str, Any], tmp_path: Path
) -> None:
    whole = daphnis.run("ring-patch", tmp_path / "whole", set=patch, steps=30, restitution=ice, forces=[spring])
    until = whole.summary["time"]
    asked: dict[str, Any] = {"set": {**patch, "until": until}, "restitution": ice, "forces": [spring]}
    part = daphnis.run("ring-patch", tmp_path / "part", **asked, watch=lambda simulation: simulation.step == 11)
    assert not part.summary["finished"]
    with pytest.raises(daphnis.InputError, match="would make another run"):
        daphnis.resume(part.path, "ring-patch", **{**asked, "restitution": lambda speed: 0.5})
    with pytest.raises(daphnis.InputError, match="only it can continue the run"):
        daphnis.resume(part.path)
    rest = daphnis.resume(part.path, "ring-patch", **asked)
    assert rest.summary["stateDigest"] == whole.summary["stateDigest"]
    assert rest.transport.equals(whole.transport)
    assert not rest.has_scenario and len(rest.last()) == 116
    with pytest.raises(daphnis.InputError, match="laws or forces of Python took part"):
        print(rest.scenario)
    assert np.isfinite(rest.series["potential_energy"]).all()


def test_an_exception_in_a_run_comes_out_and_the_run_goes_on(patch: dict[str, Any], tmp_path: Path) -> None:
    calls: list[float] = []
    limits = [40]

    def law(speed: float) -> float:
        calls.append(speed)
        if len(calls) > limits[0]:
            raise OSError("the law's own")
        return 0.5

    asked: dict[str, Any] = {"set": {**patch, "output.checkpointEvery": 2, "until": 8000.0}, "restitution": law}
    with pytest.raises(OSError, match="the law's own"):
        daphnis.run("ring-patch", tmp_path / "run", **asked)
    limits[0] = 10**9
    assert daphnis.resume(tmp_path / "run", "ring-patch", **asked).summary["finished"]


def test_a_fingerprint_is_of_the_code_and_not_of_its_place() -> None:
    from functools import partial

    from daphnis_sim.laws import fingerprint

    def power(exponent: float) -> Any:
        return lambda speed, factor=1.0: factor * speed**exponent

    def other(speed: float, exponent: float) -> float:
        return speed**exponent

    here = daphnis.restitution(lambda speed: 0.5 if speed > 1 else 1.0)
    there = daphnis.restitution(
        # Elsewhere, the same.
        lambda speed: 0.5 if speed > 1 else 1.0
    )
    assert fingerprint("a", here) == fingerprint("a", there)
    different = [here, lambda speed: 0.6 if speed > 1 else 1.0, power(-0.2), power(-0.3)]
    different += [partial(other, exponent=-0.2), partial(other, exponent=-0.3)]
    # Nested code, whose address differs from run to run, and code without a source.
    different += [lambda v: sum(k for k in (v, 1)), lambda v: sum(k for k in (v, 2)), eval("lambda v: 0.25"), abs]
    assert len({fingerprint(function) for function in different}) == len(different)
    nested = [eval("lambda v: sum(k for k in (v, 1))") for _ in range(2)]
    assert fingerprint(nested[0]) == fingerprint(nested[1])


@pytest.mark.parametrize(
    "given, words", [(None, "gives None .* does it lack a return"), ("x", "gives 'x'"), (1.5, "gives 1.5")]
)
def test_a_law_that_gives_no_coefficient_is_told_in_one_line(
    gas: dict[str, Any], spheres: dict[str, Any], given: Any, words: str
) -> None:
    def law(speed: float) -> Any:
        return given

    with daphnis.Simulation(gas, **spheres, restitution=law) as simulation:
        with pytest.raises(daphnis.InputError, match=f"law: {words}") as caught:
            simulation.advance(5)
    assert "must be in [0, 1]" in str(caught.value) and "\n" not in str(caught.value)


def test_a_force_that_gives_none_is_told_in_one_line(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    @daphnis.acceleration
    def nothing(spheres: daphnis.Spheres, time: float) -> Any:
        return None

    with daphnis.Simulation(gas, **spheres, forces=[nothing]) as simulation:
        with pytest.raises(daphnis.InputError, match="nothing: gives None; it must be an array of shape"):
            simulation.advance(1)


def test_a_law_as_a_table_is_the_law_of_a_file(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    @daphnis.restitution
    def falling(speed: float) -> float:
        return max(0.2, 1 - 0.1 * speed)

    # The law is linear between these, so the table is the law.
    table = falling.table([0.0, 8.0, 100.0])
    assert table == {"type": "table", "points": [[0.0, 1.0], [8.0, pytest.approx(0.2)], [100.0, 0.2]]}
    temperatures = []
    for scenario, law in ((dict(gas, restitution=table), None), (gas, falling)):
        with daphnis.Simulation(scenario, **spheres, restitution=law) as simulation:
            simulation.advance(10)
            temperatures.append(simulation.granular_temperature)
    assert temperatures[0] == pytest.approx(temperatures[1], rel=1e-6)
    for speeds, words in (([0.0, math.nan], "must be finite"), ([-20.0], "must be in"), ([[1.0]], "shape")):
        with pytest.raises(daphnis.InputError, match=words):
            falling.table(speeds)


@daphnis.roughness
def friction(contact: daphnis.Contact) -> float:
    """Walton's law, μ = 0.3 and β₀ = 0.25."""
    q = contact.moment_factor
    assert contact.restitution is not None
    most = 0.3 * ((1 + contact.restitution) * contact.normal_speed) * ((1 + q) / q)
    return min(0.25, most / contact.tangential_speed - 1)


@daphnis.contact_law
def both(contact: daphnis.Contact) -> tuple[float, float]:
    """Of sizes, masses and both speeds."""
    share = contact.normal_speed / (contact.normal_speed + contact.tangential_speed)
    (r1, r2), (m1, m2) = contact.radii, contact.masses
    e = 0.5 + 0.5 * share * r1 / (r1 + 2 * r2)
    return e, share * m1 / (m1 + 2 * m2) - (e if contact.restitution is None else contact.restitution)


# Spheres that spin.
PASSABLE: dict[str, Any] = {"roughness": lambda contact: 0.0}


@pytest.fixture
def unequal(spheres: dict[str, Any]) -> dict[str, Any]:
    random = np.random.default_rng(5)
    spin = random.normal(size=(1000, 3))
    return {**spheres, "radius": random.uniform(0.3, 0.9, 1000), "mass": random.uniform(0.5, 2.0, 1000), "spin": spin}


@pytest.mark.parametrize("guard", [{"type": "floor-speed", "speed": 0.5}, {"type": "none"}])
@pytest.mark.parametrize("given", [{"roughness": friction}, {"contact_law": both}])
def test_laws_of_surfaces_give_the_same_bits_with_every_engine(
    gas: dict[str, Any], unequal: dict[str, Any], given: dict[str, Any], guard: dict[str, Any]
) -> None:
    digests = set()
    for engine, count in (("serial", 1), ("horizon", 2), ("islands", 2), ("thread-pool", 2)):
        with daphnis.Simulation({**gas, "guard": guard}, **unequal, engine=engine, threads=count, **given) as one:
            digests.add(one.advance(10).digest)
            assert one.collisions > 100 and not np.array_equal(one.state().spin, unequal["spin"])
    assert len(digests) == 1


def test_laws_of_surfaces_of_python_are_those_of_java_when_they_give_the_same(
    gas: dict[str, Any], unequal: dict[str, Any]
) -> None:
    named = {**gas, "roughness": {"type": "coulomb", "friction": 0.3, "sticking": 0.25, "momentFactor": 0.3}}
    # In place of what the scenario says, but for the moment of inertia.
    other = {**gas, "roughness": {"type": "smooth", "momentFactor": 0.3}}

    def one(contact: daphnis.Contact) -> tuple[float, float]:
        return 0.9, friction(contact._replace(restitution=contact.restitution or 0.9))

    ways: list[tuple[dict[str, Any], dict[str, Any]]] = [
        (other, {"roughness": friction}),
        (other, {"roughness": friction, "restitution": lambda speed: 0.9}),
        (other, {"contact_law": one}),
        ({**named, "roughness": {**named["roughness"], "friction": 9.0}}, {"contact_law": one}),
    ]
    for guard in ({"type": "floor-speed", "speed": 0.5}, {"type": "none"}):
        with daphnis.Simulation({**named, "guard": guard}, **unequal) as java:
            there = java.advance(20).state()
        for scenario, given in ways:
            with daphnis.Simulation({**scenario, "guard": guard}, **unequal, **given) as python:
                here = python.advance(20).state()
            # Java has 1 + β as such, Python β.
            assert here.velocity == pytest.approx(there.velocity, abs=1e-9), given
            assert here.spin == pytest.approx(there.spin, abs=1e-9), given


def test_a_law_is_told_of_both_spheres_and_asked_for_both_coefficients_at_once(gas: dict[str, Any]) -> None:
    pair = {
        "position": [[-3.0, 0, 0], [0, 0, 0]],
        "velocity": [[4.0, 0.5, 0], [0, 0, 0]],
        "radius": [0.5, 1.0],
        "mass": [2.0, 3.0],
    }
    told: list[daphnis.Contact] = []

    def law(contact: daphnis.Contact) -> tuple[float, float]:
        told.append(contact)
        return 0.75, 0.0

    gas = {**gas, "timeStep": {"type": "fixed", "dt": 1.0}}
    for guard, restitution in (("none", None), ("floor-speed", 1.0)):
        told.clear()
        guards = {"type": guard} if guard == "none" else {"type": guard, "speed": 9.0}
        with daphnis.Simulation({**gas, "guard": guards}, **pair, contact_law=law) as one:
            one.advance()
            assert one.collisions == 1
        # A step that is done again asks again.
        (contact,) = set(told)
        assert contact[2:] == (restitution, 0.4, (0.5, 1.0), (2.0, 3.0), (0, 0))
        assert np.hypot(*contact[:2]) == pytest.approx(np.hypot(4.0, 0.5)) and 3.9 < contact.normal_speed < 4.0
    with daphnis.Simulation(gas, **pair, roughness=lambda contact: told.append(contact) or 0.0) as one:
        one.advance()
    assert told[-1].restitution == 0.9


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"roughness": lambda contact: None}, r"gives None where surfaces slide at .*1\]; does it lack a return"),
        ({"roughness": lambda contact: -1.5}, r"gives -1.5 where surfaces slide at .* must be in \[-1, 1\]"),
        ({"contact_law": lambda contact: None}, r"gives None; it must be a pair, \(ε, β\); does it lack a return"),
        ({"contact_law": lambda contact: 0.5}, r"gives 0.5; it must be a pair"),
        ({"contact_law": lambda contact: (2, 0)}, r"gives 2 as ε at an impact speed of .* must be in \[0, 1\]"),
        ({"contact_law": lambda contact: (1, "x")}, r"gives 'x' as β where surfaces slide at .* \[-1, 1\]"),
    ],
)
def test_what_is_no_coefficient_of_surfaces_is_told_in_one_line(
    gas: dict[str, Any], unequal: dict[str, Any], given: dict[str, Any], words: str
) -> None:
    with daphnis.Simulation(gas, **unequal, **given) as simulation:
        with pytest.raises(daphnis.InputError, match=words) as caught:
            simulation.advance(10)
        step, digest = simulation.step, simulation.digest
        assert "\n" not in str(caught.value)
    with daphnis.Simulation(gas, **unequal, **PASSABLE) as simulation:
        assert simulation.advance(step).digest == digest and simulation.collisions == 0


def test_laws_that_contradict_each_other_or_are_none_are_refused(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    for other in ({"restitution": ice}, {"roughness": friction}):
        with pytest.raises(daphnis.InputError, match="contact_law: gives both coefficients"):
            daphnis.Simulation(gas, **spheres, contact_law=both, **other)
    for name in ("roughness", "contact_law"):
        with pytest.raises(daphnis.InputError, match=f"{name}: is 0.5; it must be a function"):
            daphnis.Simulation(gas, **spheres, **{name: 0.5})
    assert friction(daphnis.Contact(1.0, 1.0, 1.0, 0.4, (1.0, 1.0), (1.0, 1.0), (0, 0))) == 0.25


def test_an_exception_in_a_law_of_surfaces_comes_out_and_leaves_the_state(
    gas: dict[str, Any], unequal: dict[str, Any]
) -> None:
    def fails(contact: daphnis.Contact) -> Any:
        raise ZeroDivisionError("in the law")

    for given in ({"roughness": fails}, {"contact_law": fails}):
        with daphnis.Simulation(gas, **unequal, **given, engine="horizon", threads=2) as simulation:
            with pytest.raises(ZeroDivisionError, match="in the law"):
                simulation.advance(10)
            step, digest = simulation.step, simulation.digest
        with daphnis.Simulation(gas, **unequal, **PASSABLE) as simulation:
            assert simulation.advance(step).digest == digest and simulation.collisions == 0


def test_a_run_with_laws_of_surfaces_goes_on_to_the_same_bits_and_with_these_only(tmp_path: Path) -> None:
    gas = {"particles.count": 100, "box.lengths": [6, 6, 6], "output.checkpointEvery": 5}
    for given, other in (
        ({"roughness": friction}, {"roughness": lambda contact: 0.5}),
        ({"contact_law": both}, {"roughness": both.function}),
    ):
        home = tmp_path / next(iter(given))
        whole = daphnis.run("cooling-gas", home / "whole", set=gas, steps=20, **given)
        assert whole.last().spin.any() and whole.series["rotational_energy"].iloc[-1] > 0
        asked: dict[str, Any] = {"set": {**gas, "until": whole.summary["time"]}, **given}
        part = daphnis.run("cooling-gas", home / "part", **asked, watch=lambda simulation: simulation.step == 11)
        with pytest.raises(daphnis.InputError, match="would make another run"):
            daphnis.resume(part.path, "cooling-gas", set=asked["set"], **other)
        rest = daphnis.resume(part.path, "cooling-gas", **asked)
        assert rest.summary["stateDigest"] == whole.summary["stateDigest"]
