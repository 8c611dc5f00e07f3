"""SIGTERM and SIGHUP: in processes of their own, since they end them."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import pytest

import daphnis_sim as daphnis

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows has no signals to be sent")

RUN = """
import os, signal, sys
import daphnis_sim as daphnis

def strike(simulation):
    if simulation.step == 5:
        os.kill(os.getpid(), signal.{name})

{before}
daphnis.run("ring-patch", sys.argv[1], set={patch!r}, steps=400, watch=strike)
print("went on")
"""


def struck(
    path: Path, patch: dict[str, Any], name: str = "SIGTERM", before: str = ""
) -> subprocess.CompletedProcess[str]:
    program = RUN.format(name=name, patch=patch, before=textwrap.dedent(before))
    # Ignored by those who run tests in the background, perhaps.
    return subprocess.run(
        [sys.executable, "-c", program, str(path)],
        capture_output=True,
        text=True,
        timeout=120,
        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL),
    )


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP"])
def test_a_kill_ends_a_run_with_a_checkpoint_and_then_the_process(
    patch: dict[str, Any], tmp_path: Path, name: str
) -> None:
    ended = struck(tmp_path / "run", patch, name)
    assert ended.returncode == -getattr(signal, name), ended.stderr
    assert f"ended by {name} after step 5; continue with: daphnis.resume(" in ended.stderr
    assert "went on" not in ended.stdout and "SIGSEGV" not in ended.stderr + ended.stdout
    run = daphnis.open(tmp_path / "run")
    assert run.summary["finished"] is False and run.summary["steps"] == 5
    assert run.resume(until=run.last().time * 2).summary["finished"]


def test_a_handler_of_the_program_is_called_between_steps_and_the_run_goes_on(
    patch: dict[str, Any], tmp_path: Path
) -> None:
    before = 'signal.signal(signal.SIGTERM, lambda number, frame: print("heard", number))'
    ended = struck(tmp_path / "run", patch, before=before)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.split("\n")[:2] == [f"heard {int(signal.SIGTERM)}", "went on"]
    assert daphnis.open(tmp_path / "run").summary["finished"] is True


def test_a_handler_that_raises_ends_the_run_with_a_checkpoint_and_comes_out(
    patch: dict[str, Any], tmp_path: Path
) -> None:
    before = """
    def leave(number, frame):
        sys.exit(7)
    signal.signal(signal.SIGTERM, leave)
    """
    ended = struck(tmp_path / "run", patch, before=before)
    assert ended.returncode == 7, ended.stderr
    summary = daphnis.open(tmp_path / "run").summary
    assert summary["finished"] is False and summary["steps"] == 5


def test_what_is_ignored_stays_so(patch: dict[str, Any], tmp_path: Path) -> None:
    ended = struck(tmp_path / "run", patch, before="signal.signal(signal.SIGTERM, signal.SIG_IGN)")
    assert ended.returncode == 0 and "went on" in ended.stdout, ended.stderr


def test_a_kill_while_nothing_runs_ends_the_process_at_once() -> None:
    program = (
        "import os, signal, daphnis_sim as daphnis; daphnis.scenario('ring-patch'); "
        "os.kill(os.getpid(), signal.SIGTERM)"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert ended.returncode == -signal.SIGTERM, ended.stderr
    assert not ended.stderr


def work(path: str, patch: dict[str, Any], begun: Any) -> None:
    """A run that takes longer than a test."""
    daphnis.run("ring-patch", path, set=patch, steps=10**7, watch=lambda simulation: begun.set())


def test_processes_that_were_spawned_end_with_a_checkpoint(patch: dict[str, Any], tmp_path: Path) -> None:
    context = multiprocessing.get_context("spawn")
    events = [context.Event() for _ in range(2)]
    all_of_them = [
        context.Process(target=work, args=(str(tmp_path / f"run-{k}"), patch, event)) for k, event in enumerate(events)
    ]
    for process in all_of_them:
        process.start()
    for event in events:
        assert event.wait(60)
    for process in all_of_them:
        process.terminate()
    for k, process in enumerate(all_of_them):
        process.join(60)
        assert process.exitcode == -signal.SIGTERM
        assert daphnis.open(tmp_path / f"run-{k}").summary["finished"] is False
