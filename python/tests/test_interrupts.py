"""Ctrl-C, and failures of functions beside those of Java."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jpype
import pytest

import daphnis_sim as daphnis
from daphnis_sim._errors import PythonFailure, translated
from daphnis_sim._jvm import java

MANY = 100_000


@pytest.fixture(autouse=True)
def handler() -> Iterator[Any]:
    """Python's own handler, before each test and after it, also where SIGINT is ignored, as in the background."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    left = signal.signal(signal.SIGINT, before)
    assert left is signal.default_int_handler


def press() -> None:
    os.kill(os.getpid(), signal.SIGINT)


@pytest.mark.parametrize("engine", ["serial", "horizon"])
def test_ctrl_c_in_a_law_ends_the_step_well(gas: dict[str, Any], spheres: dict[str, Any], engine: str) -> None:
    calls = 0

    def law(speed: float) -> float:
        nonlocal calls
        calls += 1
        if calls == 20:
            press()
        return 0.9

    with daphnis.Simulation(gas, **spheres, engine=engine, threads=1, restitution=law) as simulation:
        with pytest.raises(KeyboardInterrupt):
            simulation.advance(1000)
        step = simulation.step
        assert 0 < step < 1000
        after = simulation.advance(2).digest
    with daphnis.Simulation(gas, **spheres) as undisturbed:
        assert undisturbed.advance(step + 2).digest == after


def test_a_second_ctrl_c_breaks_off_a_law_that_does_not_end(gas: dict[str, Any], spheres: dict[str, Any]) -> None:
    broken = True

    def law(speed: float) -> float:
        for _ in range(MANY if broken else 0):
            press()
        return 0.9

    with daphnis.Simulation(gas, **spheres, restitution=law) as simulation:
        with pytest.raises(KeyboardInterrupt):
            simulation.advance_to(5.0)
        broken = False
        step = simulation.step
        assert simulation.time < 5.0
        after = simulation.advance(2).digest
    with daphnis.Simulation(gas, **spheres) as undisturbed:
        assert undisturbed.advance(step + 2).digest == after


def test_ctrl_c_in_the_law_of_a_run_is_not_lost(patch: dict[str, Any], tmp_path: Path) -> None:
    calls = 0

    def law(speed: float) -> float:
        nonlocal calls
        calls += 1
        if calls == 30:
            press()
        return 0.5

    with pytest.raises(daphnis.Interrupted, match="daphnis.resume") as caught:
        daphnis.run("ring-patch", tmp_path / "run", set=patch, steps=5000, restitution=law)
    assert not daphnis.open(caught.value.path).summary["finished"]


def test_a_second_ctrl_c_breaks_off_a_run(patch: dict[str, Any], tmp_path: Path) -> None:
    def law(speed: float) -> float:
        # Signals that come one upon another may be heard as one.
        for _ in range(MANY):
            press()
        return 0.5

    with pytest.raises(KeyboardInterrupt) as caught:
        daphnis.run("ring-patch", tmp_path / "run", set=patch, steps=500, threads=1, engine="serial", restitution=law)
    assert not isinstance(caught.value, daphnis.Interrupted)
    again = {"set": {**patch, "engine.name": "serial", "engine.threads": 1}, "steps": 1, "force": True}
    # Its lock is gone.
    assert daphnis.run("ring-patch", tmp_path / "run", **again).summary["finished"]


def test_ctrl_c_while_a_run_starts_ends_it_with_a_checkpoint(
    patch: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from daphnis_sim import _execution

    def noted(notices: list[str]) -> None:
        press()

    monkeypatch.setattr(_execution, "noted", noted)
    with pytest.raises(daphnis.Interrupted, match="interrupted after step 0") as caught:
        daphnis.run("ring-patch", tmp_path / "run", set=patch, steps=50)
    monkeypatch.undo()
    assert daphnis.resume(caught.value.path).summary["finished"]


def test_a_handler_that_python_could_not_restore_stays(
    gas: dict[str, Any], spheres: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`getsignal` gives None for one that was not installed from Python."""

    def replaced(*_: object) -> None:
        raise AssertionError("replaced")

    with monkeypatch.context() as other:
        other.setattr(signal, "getsignal", lambda _: None)
        other.setattr(signal, "signal", replaced)
        daphnis.run("ring-patch", tmp_path / "run", set={"box.lengths": [40, 40, 20]}, steps=1)
        with daphnis.Simulation(gas, **spheres) as simulation:
            simulation.advance()


def test_ctrl_c_that_is_ignored_stays_so_and_handlers_of_others_are_put_back(
    gas: dict[str, Any], spheres: dict[str, Any], patch: dict[str, Any], tmp_path: Path
) -> None:
    pressed: list[int] = []

    def other(number: int, frame: object) -> None:
        pressed.append(number)

    def watch(simulation: daphnis.Simulation) -> None:
        if simulation.step == 2:
            press()

    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        run = daphnis.run("ring-patch", tmp_path / "ignored", set=patch, steps=4, watch=watch)
        assert run.summary["finished"]
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
        signal.signal(signal.SIGINT, other)
        with pytest.raises(daphnis.Interrupted):
            daphnis.run("ring-patch", tmp_path / "other", set=patch, steps=40, watch=watch)
        assert signal.getsignal(signal.SIGINT) is other and not pressed
        law = daphnis.restitution(lambda speed: (press(), 0.9)[1])
        with daphnis.Simulation(gas, **spheres, restitution=law) as simulation:
            simulation.advance(3)
        assert pressed, "a program's own handler is called while it advances a simulation"
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def test_a_failure_of_java_is_not_taken_for_an_earlier_one_of_a_function() -> None:
    failure = PythonFailure()
    with pytest.raises(daphnis.RunError, match="IndexOutOfBounds"):
        with translated(failure):
            failure.keep(ValueError("in a part of a step that was done again"))
            java("java.util.ArrayList")().get(0)
    assert failure.error is None


def test_a_failure_within_a_step_that_ended_well_is_forgotten() -> None:
    from daphnis_sim._execution import _Execution
    from daphnis_sim._interrupts import CtrlC, Termination

    class Halted:
        def getSimulation(self) -> None:
            return None

    java("daphnis.core.Output")
    failure = PythonFailure()
    execution = _Execution(Halted(), None, False, failure, CtrlC(failure, True), Termination())
    with translated(failure):
        failure.keep(ValueError("stale"))
        jpype.JObject(execution.watcher(), java("daphnis.core.Output")).write(None)
        assert failure.error is None
