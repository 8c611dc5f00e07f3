"""Sweeps: tasks for any executor, and their tables."""

from __future__ import annotations

import concurrent.futures
import json
import multiprocessing
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis

SMALL: dict[str, Any] = {"particles.count": 60, "until": 2, "restitution.coefficient": [0.5, 0.9]}


def tasks_in(place: Path, **more: Any) -> list[daphnis.Task]:
    return daphnis.sweep("cooling-gas", place, **{"set": SMALL, "seeds": range(1, 3), **more})


def test_tasks_run_in_other_processes_and_are_collected(tmp_path: Path) -> None:
    tasks = tasks_in(tmp_path / "a")
    assert [task.name for task in tasks] == [
        f"coefficient={e},seed={s}" for e in (0.5, 0.9) for s in (1, 2)
    ]
    assert not (tmp_path / "a" / "runs").exists()
    spawn = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=spawn) as executor:
        outcomes = list(executor.map(daphnis.run_task, tasks))
    assert [outcome.name for outcome in outcomes] == [task.name for task in tasks]
    assert all(outcome.finished and outcome.failure is None for outcome in outcomes)
    alone = daphnis.run(
        "cooling-gas", tmp_path / "one", set={**SMALL, "restitution.coefficient": 0.9}, seed=2, threads=1
    )
    assert outcomes[3].digest == alone.summary["stateDigest"]
    found = daphnis.collect(tmp_path / "a")
    assert found.notices == [] and "Sweep" in repr(found)
    assert list(found.runs["run"]) == [task.name for task in tasks]
    means = found.means
    end = means[means["quantity"] == "end_granular_temperature"].set_index("restitution.coefficient")
    column = next(name for name in found.runs if name.startswith("end_granular_temperature"))
    ends = found.runs[column]
    assert end.loc[0.9, "mean"] == pytest.approx(ends[2:].mean(), rel=1e-14)
    assert end.loc[0.9, "standard_error"] == pytest.approx(abs(ends[2] - ends[3]) / 2, rel=1e-9)
    # A finished task is left as it is.
    before = (Path(tasks[0].path) / "summary.json").stat().st_mtime_ns
    assert daphnis.run_task(tasks[0]) == outcomes[0]
    assert (Path(tasks[0].path) / "summary.json").stat().st_mtime_ns == before


def test_tasks_and_outcomes_are_pickled_without_java() -> None:
    task = daphnis.Task("a", "/nowhere/a", "{}", "gas", 2)
    assert pickle.loads(pickle.dumps(task)) == task
    outcome = daphnis.Outcome("a", "/nowhere/a", False, None, "why")
    assert pickle.loads(pickle.dumps(outcome)) == outcome


def test_a_task_that_was_begun_goes_on_to_the_same_bits(tmp_path: Path) -> None:
    task = tasks_in(tmp_path / "a")[1]
    begun = daphnis.run(json.loads(task.scenario), task.path, threads=1, watch=lambda s: s.step == 7)
    assert not begun.finished
    assert task.run().finished
    whole = daphnis.run(json.loads(task.scenario), tmp_path / "whole", threads=1)
    assert daphnis.run_task(task).digest == whole.summary["stateDigest"]


def test_a_run_that_fails_says_why_and_the_others_are_in_the_tables(tmp_path: Path) -> None:
    tasks = tasks_in(tmp_path / "a")
    # The third run's place is taken by a file.
    (tmp_path / "a" / "runs").mkdir()
    Path(tasks[2].path).write_text("mine")
    outcomes = [daphnis.run_task(task) for task in tasks]
    assert [outcome.finished for outcome in outcomes] == [True, True, False, True]
    assert outcomes[2].failure is not None and tasks[2].name in outcomes[2].failure
    with pytest.warns(daphnis.DaphnisWarning, match="coefficient=0.9,seed=1"):
        found = daphnis.collect(tmp_path / "a")
    assert len(found.notices) == 1 and list(found.runs["seed"].dropna()) != []
    with pytest.warns(daphnis.DaphnisWarning, match="is not finished"):
        none = daphnis.collect(tasks_in(tmp_path / "b")[0].path + "/../..")
    with pytest.raises(daphnis.InputError, match="no run of it is finished"):
        _ = none.means


def test_values_are_lists_and_numbers_of_numpy(tmp_path: Path) -> None:
    tasks = daphnis.sweep(
        "cooling-gas",
        tmp_path / "a",
        set={"timeStep.dt": np.array([0.05, 0.1]), "box.lengths": [[20, 20, 20], [24, 24, 24]], "name": "gas"},
        seeds=[3],
        threads=2,
    )
    assert len(tasks) == 4 and {task.threads for task in tasks} == {2}
    lengths = [json.loads(task.scenario)["box"]["lengths"] for task in tasks]
    assert lengths == [[20, 20, 20], [24, 24, 24]] * 2


def test_wrong_sweeps_are_refused_in_one_line(tmp_path: Path) -> None:
    tasks_in(tmp_path / "a")
    for given, why in (
        ({"seeds": range(1, 4)}, "--seeds was 1,2 and is 1..3"),
        ({"set": {**SMALL, "particles.count": 70}}, "particles.count"),
        ({"set": {"particles.cuont": [1, 2]}}, "cuont"),
        ({"set": {"timeStep.dt": [0.1, -1]}}, "timeStep.dt"),
        ({"set": {"timeStep.dt": [0.1, float("nan")]}}, "no scenario can hold"),
        ({"set": {"until": 3}, "seeds": None}, "nothing to sweep"),
        ({"engine": "quick"}, "quick"),
        ({"seeds": "1..3"}, "seeds: is '1..3'"),
    ):
        with pytest.raises(daphnis.InputError) as e:
            tasks_in(tmp_path / "a", **given)
        assert why in str(e.value) and "\n" not in str(e.value)
    with pytest.raises(daphnis.InputError, match="holds no sweep"):
        daphnis.collect(tmp_path)
    with pytest.raises(daphnis.InputError, match="task: is"):
        daphnis.run_task("a")  # type: ignore[arg-type]
