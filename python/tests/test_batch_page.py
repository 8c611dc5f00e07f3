"""What docs/batch.md shows is run: its program, its workflows, and the tasks with each executor that it names."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from textwrap import dedent, indent

import pytest

import daphnis_sim as daphnis

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "batch.md").read_text("utf-8")
GAS = "cooling-gas --set particles.count=60 --set until=2 --set restitution.coefficient=0.5,0.9 --seeds 1..2 --quiet"
SMALL = {"particles.count": 60, "until": 2, "restitution.coefficient": [0.5, 0.9]}


def block(language: str) -> str:
    (text,) = re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.M | re.S)
    return str(text)


def shortened(text: str, *changes: tuple[str, str]) -> str:
    """The text with each of the `changes`, of which none may be in vain."""
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


def small(text: str) -> str:
    """A workflow of the page, with a sweep of four small runs."""
    (words,) = set(re.findall(r"ring-patch .*?--seeds 1\.\.8", text))
    return shortened(text, (words, GAS))


def done(words: list[str], place: Path, **variables: str) -> str:
    """What a program says that runs in `place` and has to end well."""
    found = subprocess.run(
        words, cwd=place, env={**os.environ, **variables}, capture_output=True, text=True, timeout=300
    )
    assert found.returncode == 0, found.stdout + found.stderr
    return found.stdout


def program(place: Path) -> None:
    """Puts ./daphnis into `place`, which notes what it was called with."""
    call = f'echo "$@" >> called\nexec "{sys.executable}" -m daphnis_sim "$@"'
    (place / "daphnis").write_text(f"#!/bin/sh\n{call}\n")
    (place / "daphnis").chmod(0o755)


def ends(place: Path) -> list[str]:
    """Digests of the runs of the sweep in `place`, in the order of its tables."""
    names = daphnis.collect(place).runs["run"]
    return [str(daphnis.Run(place / "runs" / name).summary["stateDigest"]) for name in names]


@pytest.fixture(scope="session")
def digests(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Of the four runs of GAS and SMALL, made one after the other."""
    tasks = daphnis.sweep("cooling-gas", tmp_path_factory.mktemp("gas") / "a", set=SMALL, seeds=range(1, 3))
    return [daphnis.run_task(task).digest or "" for task in tasks]


def test_the_program_runs(tmp_path: Path) -> None:
    text = shortened(
        block("python"),
        ("[0.1, 0.5, 1]", "[0.1, 0.2]"),
        ("[[100, 100, 20]]", "[[40, 40, 20]]"),
        ('"untilOrbits": 20', '"untilOrbits": 0.1'),
        ("range(1, 9)", "range(1, 3)"),
        ("ProcessPoolExecutor(", "ProcessPoolExecutor(2, "),
    )
    (tmp_path / "program.py").write_text(text)
    said = done([sys.executable, "program.py"], tmp_path)
    found = daphnis.collect(tmp_path / "runs/tasks")
    assert found.notices == []
    names = [f"opticalDepth={depth},seed={seed}" for depth in (0.1, 0.2) for seed in (1, 2)]
    assert said.splitlines()[:4] == [
        f"{name} {digest}" for name, digest in zip(names, ends(tmp_path / "runs/tasks"), strict=True)
    ]
    # The means, which it prints.
    assert "particles.opticalDepth" in said and "standard_error" in (tmp_path / "runs/tasks/sweep.csv").read_text()


def test_the_snakefile_makes_the_tables(tmp_path: Path, digests: list[str]) -> None:
    pytest.importorskip("snakemake")
    program(tmp_path)
    (tmp_path / "Snakefile").write_text(shortened(small(block("snakemake")), ("PARTS = 8", "PARTS = 2")))
    done([sys.executable, "-m", "snakemake", "--cores", "1"], tmp_path)
    assert (tmp_path / "runs/depths/sweep.csv").exists()
    assert sorted(path.name for path in (tmp_path / "parts").iterdir()) == ["1", "2"]
    lines = (tmp_path / "called").read_text().splitlines()
    called = [line.removeprefix(f"sweep {GAS} --out runs/depths ") for line in lines]
    assert sorted(called[:2]) == ["--part 1/2", "--part 2/2"] and called[2:] == ["--collect"]
    assert ends(tmp_path / "runs/depths") == digests


def test_the_workflow_of_row_makes_the_runs(tmp_path: Path, digests: list[str]) -> None:
    row = shutil.which("row")
    # Others have that name too.
    if row is None or "workflows on HPC" not in subprocess.run([row, "--help"], capture_output=True, text=True).stdout:
        pytest.skip("no row here")
    program(tmp_path)
    (tmp_path / "workflow.toml").write_text(shortened(small(block("toml")), ("{directory}/8", "{directory}/2")))
    (folders,) = re.findall(r"`(mkdir [^`]*)`", PAGE)
    done(["sh", "-c", shortened(folders, (" 8)", " 2)"))], tmp_path)
    submit = [row, "submit", "--cluster", "none", "--yes"]
    done(submit, tmp_path)
    assert ends(tmp_path / "runs/depths") == digests
    assert "no eligible" in subprocess.run(submit, cwd=tmp_path, capture_output=True, text=True).stderr


# What the page says of each, what the program begins with, and what makes `outcomes` of `tasks` in it.
EXECUTORS = {
    "distributed": (
        "client.map(daphnis.run_task, tasks)",
        "from dask.distributed import Client",
        """
        with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
            outcomes = client.gather(client.map(daphnis.run_task, tasks))
        """,
    ),
    "ray": (
        "ray.remote(daphnis.run_task)",
        "import ray\nif __name__ == '__main__':\n    ray.init(num_cpus=2, include_dashboard=False)",
        """
        make = ray.remote(daphnis.run_task)
        outcomes = ray.get([make.remote(task) for task in tasks])
        """,
    ),
    "submitit": (
        "executor.map_array(daphnis.run_task, tasks)",
        "import submitit",
        """
        executor = submitit.AutoExecutor("jobs", cluster="local")
        executor.update_parameters(timeout_min=5)
        outcomes = [job.result() for job in executor.map_array(daphnis.run_task, tasks)]
        """,
    ),
    "joblib": (
        "delayed(daphnis.run_task)",
        "from joblib import Parallel, delayed",
        """
        outcomes = Parallel(n_jobs=2)(delayed(daphnis.run_task)(task) for task in tasks)
        """,
    ),
    "pyspark": (
        "sc.parallelize(tasks, len(tasks)).map(daphnis.run_task)",
        "from pyspark import SparkContext",
        """
        with SparkContext("local[2]") as sc:
            outcomes = sc.parallelize(tasks, len(tasks)).map(daphnis.run_task).collect()
        """,
    ),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", EXECUTORS)
def test_tasks_run_with(name: str, tmp_path: Path, digests: list[str]) -> None:
    shown, head, body = EXECUTORS[name]
    assert f"`{shown}`" in " ".join(PAGE.split()) and shown in body
    pytest.importorskip(name)
    if name == "pyspark" and shutil.which("java") is None and "JAVA_HOME" not in os.environ:
        pytest.skip("no Java here for Spark itself")
    (tmp_path / "program.py").write_text(
        f"""
{head}
import daphnis_sim as daphnis

if __name__ == "__main__":
    tasks = daphnis.sweep("cooling-gas", "sweep", set={SMALL}, seeds=range(1, 3))
{indent(dedent(body), "    ")}
    for outcome in outcomes:
        print(outcome.name, outcome.digest or outcome.failure)
"""
    )
    said = done([sys.executable, "program.py"], tmp_path, PYSPARK_PYTHON=sys.executable)
    found = [line for line in said.splitlines() if line.startswith("coefficient=")]
    assert [line.split()[1] for line in found] == digests and len(found) == 4
    assert ends(tmp_path / "sweep") == digests
