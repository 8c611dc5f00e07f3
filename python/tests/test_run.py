"""Runs: started, read, gone on with, refused."""

from __future__ import annotations

import json
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis


def test_a_run_gives_what_its_directory_holds(ring: daphnis.Run) -> None:
    summary = json.loads((ring.path / "summary.json").read_text())
    assert ring.summary == summary
    assert summary["finished"] and summary["steps"] == 60
    assert ring.steps == [0, 20, 40, 60]
    assert ring.scenario.name == "ring-patch"
    assert "ring-patch" in ring._repr_html_()


def test_series_have_units_and_the_bits_of_the_file(ring: daphnis.Run) -> None:
    series = ring.series
    assert series.attrs["units"]["time"] == "s"
    assert series.attrs["units"]["granular_temperature"] == "m^2/s^2"
    last = (ring.path / "series.csv").read_text().splitlines()[-1].split(",")
    for name, text in zip(series.columns, last, strict=True):
        assert series[name].iloc[-1] == float(text) or np.isnan(series[name].iloc[-1])
    assert series["time"].iloc[-1] == ring.summary["time"]
    assert set(ring.transport.attrs["units"]) == set(ring.transport.columns)
    assert list(ring.modes["mode"]) == 4 * list(range(9)) and ring.modes.attrs["units"]["wavenumber"] == "1/m"
    assert ring.impacts["collisions"].sum() == ring.summary["collisions"]


def test_a_line_that_is_being_written_is_left_out(ring: daphnis.Run, tmp_path: Path) -> None:
    from daphnis_sim.tables import read_table

    text = (ring.path / "series.csv").read_text()
    (tmp_path / "series.csv").write_text(text[:-20])
    assert len(read_table(tmp_path / "series.csv")) == len(ring.series) - 1
    (tmp_path / "series.csv").write_text("")
    assert len(read_table(tmp_path / "series.csv")) == 0
    (tmp_path / "series.csv").write_text(text.replace("time", "tyme", 1))
    with pytest.raises(daphnis.FormatError, match="column 'time' is missing"):
        read_table(tmp_path / "series.csv")


def test_states_are_read_one_by_one_and_by_time(ring: daphnis.Run) -> None:
    states = list(ring.states())
    assert [state.step for state in states] == ring.steps
    assert len(ring.states()) == 4 and ring.states()[-1].step == 60
    found = ring.at(states[2].time)
    assert found.step == 40
    assert np.array_equal(found.position, states[2].position)
    assert ring.scenario.is_hill
    assert ring.scenario.kappa == ring.scenario.nu == ring.scenario.omega
    oblate = daphnis.scenario("ring-patch", set={"frame.radialFactor": 0.9, "frame.verticalFactor": 1.1})
    assert (oblate.kappa, oblate.nu) == (0.9 * oblate.omega, 1.1 * oblate.omega)
    orbits = states[1].time / ring.scenario.orbit
    assert ring.at(orbits=orbits).step == 20
    with pytest.raises(daphnis.InputError, match="next to it are those of step"):
        ring.at(states[1].time * 1.5)
    with pytest.raises(daphnis.InputError, match="has no state after step 7"):
        ring.at_step(7)


def test_a_state_can_be_pickled(ring: daphnis.Run) -> None:
    state = ring.last()
    again = pickle.loads(pickle.dumps(state))
    assert (again.step, again.time, again.run) == (state.step, state.time, None)
    assert again.to_frame().equals(state.to_frame()) and again.to_frame().attrs == state.to_frame().attrs
    assert np.array_equal(again.image, state.image) and np.array_equal(again.cell, state.cell)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(len, [state]) == [len(state)]


def test_arrays_of_a_state_are_the_files(ring: daphnis.Run) -> None:
    state = ring.last()
    n = len(state)
    assert state.position.shape == state.velocity.shape == (n, 3)
    assert state.radius.shape == state.mass.shape == state.id.shape == (n,)
    assert np.shares_memory(state.x, state.position) and state.x.flags.c_contiguous
    assert np.array_equal(state.id, np.arange(n))
    assert list(state.periodic) == [True, True, False]
    assert np.array_equal(state.box, [40, 40, 20])
    assert state.cell.shape == (3, 3) and state.image is not None and state.image.shape == (n, 3)
    # Their own: another read is not changed by writing.
    state.position[:] = 0
    assert ring.last().position.any()
    frame = ring.last().to_frame()
    assert frame.attrs["units"]["vx"] == "m/s" and list(frame.index) == list(range(n))


def test_a_second_run_into_a_directory_is_refused_and_changes_nothing(ring: daphnis.Run, patch: dict[str, Any]) -> None:
    before = ring.summary
    with pytest.raises(daphnis.InputError, match=r"give another directory with out=, or force=True"):
        daphnis.run("ring-patch", ring.path, set=patch, steps=1)
    assert ring.summary == before


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"scenario": "ring-pach"}, "did you mean 'ring-patch'"),
        ({"set": {"particles.opticalDpth": 1}}, "did you mean 'opticalDepth'"),
        ({"set": {"timeStep.dt": float("nan")}}, "set: timeStep.dt: cannot be written as JSON"),
        ({"set": {"": 1}}, "set: =1: must have the form"),
        ({"engine": "horizn"}, "did you mean 'horizon'"),
        ({"threads": 1000}, r"engine\.threads: is 1000"),
        ({"until": -1}, "until: is -1"),
        ({"until": 1, "steps": 1}, "steps: is given together with until"),
        ({"steps": 0}, "steps: is 0"),
        ({"steps": 1.5}, "steps: is 1.5"),
        ({"scenario": "missing/file.json"}, "missing/file.json: no such file"),
        ({"scenario": 3}, "scenario: is 3"),
        ({"from_": 3}, "from_: is 3"),
        ({"from_": "nowhere"}, "nowhere: no such file or directory"),
        ({"forces": [lambda s, t: 0]}, "must be what daphnis.kick"),
        ({"restitution": 0.5}, "restitution: is 0.5; it must be a function"),
    ],
)
def test_wrong_arguments_are_one_line_and_leave_nothing(arguments: dict[str, Any], words: str, tmp_path: Path) -> None:
    with pytest.raises(daphnis.InputError, match=words) as caught:
        daphnis.run(**{"scenario": "ring-patch", "out": tmp_path / "run", **arguments})
    assert "\n" not in str(caught.value)
    assert isinstance(caught.value, ValueError)
    assert not (tmp_path / "run").exists()


def test_what_is_no_run_is_not_opened(tmp_path: Path) -> None:
    with pytest.raises(daphnis.InputError, match="is no run directory"):
        daphnis.open(tmp_path)
    with pytest.raises(daphnis.InputError, match="no such file or directory"):
        daphnis.open(tmp_path / "missing")


def test_a_run_that_was_ended_goes_on_to_the_same_bits(
    ring: daphnis.Run, patch: dict[str, Any], tmp_path: Path
) -> None:
    until = ring.scenario.to_dict()["until"]
    times: list[float] = []

    def watch(simulation: daphnis.Simulation) -> bool:
        times.append(simulation.time)
        with pytest.raises(daphnis.RunError, match="advanced by its run"):
            simulation.advance()
        return simulation.step == 25

    part = daphnis.run("ring-patch", tmp_path / "run", set=patch, until=until, threads=1, watch=watch)
    assert part.summary["steps"] == 25 and not part.summary["finished"]
    assert len(times) == 26 and times == sorted(times)
    whole = part.resume()
    assert whole.summary["stateDigest"] == ring.summary["stateDigest"]
    assert whole.series.equals(ring.series)


def test_an_exception_of_the_watcher_comes_out(patch: dict[str, Any], tmp_path: Path) -> None:
    def watch(simulation: daphnis.Simulation) -> None:
        if simulation.step == 3:
            raise LookupError("seen enough")

    with pytest.raises(LookupError, match="seen enough"):
        daphnis.run("ring-patch", tmp_path / "run", set=patch, steps=5, watch=watch)


def test_a_run_starts_from_a_state_of_another(ring: daphnis.Run, tmp_path: Path) -> None:
    half = ring.at_step(40)
    rest = daphnis.run(from_=half, out=tmp_path / "rest", steps=20)
    assert rest.summary["stateDigest"] == ring.summary["stateDigest"]
    with pytest.raises(daphnis.InputError, match="give steps or until"):
        daphnis.run(from_=ring, out=tmp_path / "none")
    with pytest.raises(daphnis.InputError, match="set: particles.opticalDepth: is of an initial state"):
        daphnis.run(from_=ring, out=tmp_path / "none", steps=1, set={"particles.opticalDepth": 1})


def test_where_a_piston_is_comes_from_the_state(tmp_path: Path) -> None:
    walls = {"type": "walls", "axes": "x", "faces": {"upperX": {"motion": {"type": "piston", "mass": 40}}}}
    settings = {"particles.count": 20, "boundary": walls}
    run = daphnis.run("elastic-gas", tmp_path / "run", set=settings, steps=2)
    for key in ("position", "velocity"):
        setting = {f"boundary.faces.upperX.motion.{key}": 0.1}
        with pytest.raises(daphnis.InputError, match=rf"motion\.{key}: is of an initial state"):
            daphnis.run(from_=run, out=tmp_path / "none", steps=1, set=setting)


def test_a_masked_setting_is_refused() -> None:
    with pytest.raises(daphnis.InputError, match="set: particles.count: .*masked"):
        daphnis.scenario("cooling-gas", set={"particles.count": np.ma.masked})


def test_scenarios_are_named_written_and_taken_as_dicts(tmp_path: Path) -> None:
    assert "ring-patch" in daphnis.scenarios()
    changed = daphnis.scenario("ring-patch", set={"box.lengths": np.array([50, 50, 20]), "seed": np.int64(3)})
    assert changed.to_dict()["box"]["lengths"] == [50, 50, 20]
    assert "changed: box.lengths=[50, 50, 20], seed=3" in changed.to_dict()["description"]
    changed.write(tmp_path / "mine.json")
    assert daphnis.scenario(tmp_path / "mine.json").json == changed.json
    assert daphnis.scenario(changed.to_dict()).json == changed.json
    with pytest.raises(daphnis.InputError, match="box: unknown key|unknown key|missing"):
        daphnis.scenario({"boks": 1})


def test_ctrl_c_ends_a_run_with_a_checkpoint(tmp_path: Path) -> None:
    before = signal.getsignal(signal.SIGINT)
    program = f"""
import os, signal, daphnis_sim as daphnis
# Where these tests run in the background, SIGINT is ignored, and so would be what it sends here.
signal.signal(signal.SIGINT, signal.default_int_handler)
def watch(simulation):
    if simulation.step == 4:
        os.kill(os.getpid(), signal.SIGINT)
try:
    daphnis.run("ring-patch", {str(tmp_path / "run")!r}, set={{"box.lengths": [40, 40, 20]}}, steps=500, watch=watch)
except daphnis.Interrupted as e:
    assert isinstance(e, KeyboardInterrupt) and "daphnis.resume(" in str(e), e
    print(daphnis.open(e.path).summary["steps"], signal.getsignal(signal.SIGINT) is signal.default_int_handler)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, env=os.environ)
    assert done.stdout.split() == ["4", "True"], done.stderr
    assert signal.getsignal(signal.SIGINT) is before


def test_what_a_user_should_know_is_a_warning(patch: dict[str, Any], tmp_path: Path) -> None:
    coarse = {**patch, "timeStep": {"type": "orbit-fraction", "steps": 20}}
    with pytest.warns(daphnis.DaphnisWarning, match="timeStep") as caught:
        run = daphnis.run("ring-patch", tmp_path / "run", set=coarse, steps=2)
    assert [str(warning.message) for warning in caught] == run.notices
    assert caught[0].filename == __file__
    with pytest.warns(daphnis.DaphnisWarning, match="timeStep"):
        daphnis.Simulation("ring-patch", set=coarse).close()


def test_relative_paths_are_of_the_present_working_directory(
    patch: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    daphnis.scenarios()
    monkeypatch.chdir(tmp_path)
    run = daphnis.run("ring-patch", "runs/here", set=patch, steps=1)
    assert run.path == tmp_path / "runs" / "here" and run.path.is_dir()
    assert repr(run) == "<Run 'runs/here'>"
    monkeypatch.chdir("/")
    assert len(run.series) == 1 or run.last().step == 1
    daphnis.scenario("ring-patch", set=patch).write(tmp_path / "mine.json")
    monkeypatch.chdir(tmp_path)
    assert daphnis.scenario("mine.json").name == "ring-patch"


def test_a_forked_process_is_told_to_spawn() -> None:
    daphnis.scenarios()
    child = os.fork()
    if child == 0:
        try:
            daphnis.scenarios()
        except daphnis.JavaError as e:
            os._exit(0 if "spawn" in str(e) else 2)
        os._exit(3)
    assert os.waitpid(child, 0)[1] == 0
