"""Processes of Python end, however they end and whatever is left open: each here in one of its own."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import daphnis_sim as daphnis

PATIENCE = 120
"""Seconds for what takes some three on an idle machine; a process that waits for a thread never ends."""

VIEW = """
import urllib.request
view = daphnis.open(sys.argv[1]).view()
watched = urllib.request.urlopen(view.address + "changes")
watched.readline()
"""
SIMULATION = """
simulation = daphnis.Simulation("cooling-gas", set={"particles.count": 500}, engine="islands", threads=2)
simulation.advance(2)
"""
THREAD = """
first = threading.Thread(target=lambda: daphnis.scenario("cooling-gas"))
first.start()
first.join()
"""
DAEMON = """
begun = threading.Event()
def work():
    daphnis.run("cooling-gas", sys.argv[2], set={"particles.count": 500}, steps=10**7, watch=lambda _: begun.set())
threading.Thread(target=work, daemon=True).start()
assert begun.wait(60)
"""
LEFT_OPEN = {"view": VIEW, "simulation": SIMULATION, "thread": THREAD, "daemon": DAEMON}

WAYS = {
    "plain": ("", 0),
    "exception": ("raise ValueError('mine')", 1),
    "exit": ("sys.exit(7)", 7),
    "ctrl-c": ("os.kill(os.getpid(), signal.SIGINT); time.sleep(60)", -signal.SIGINT),
    "sigterm": ("os.kill(os.getpid(), signal.SIGTERM); time.sleep(60)", -signal.SIGTERM),
}


def ended(program: str, *words: str) -> subprocess.CompletedProcess[str]:
    head = "import os, signal, sys, threading, time\nimport daphnis_sim as daphnis\n"
    default = "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
    done = subprocess.run(
        [sys.executable, "-c", head + default + program, *words], capture_output=True, text=True, timeout=PATIENCE
    )
    assert "SIGSEGV" not in done.stdout + done.stderr
    return done


@pytest.mark.parametrize("left_open", LEFT_OPEN)
def test_a_process_ends_with_what_it_left_open(ring: daphnis.Run, tmp_path: Path, left_open: str) -> None:
    done = ended(LEFT_OPEN[left_open] + "print('at its end')", str(ring.path), str(tmp_path / "run"))
    assert (done.returncode, done.stdout) == (0, "at its end\n"), done.stderr


@pytest.mark.skipif(os.name == "nt", reason="Windows has no signals to be sent")
@pytest.mark.parametrize("way", WAYS)
def test_a_process_ends_in_each_way_with_all_of_it_open(ring: daphnis.Run, tmp_path: Path, way: str) -> None:
    end, status = WAYS[way]
    program = THREAD + VIEW + SIMULATION + DAEMON
    done = ended(f"{program}\nprint('at its end', flush=True)\n{end}", str(ring.path), str(tmp_path / "run"))
    assert (done.returncode, done.stdout) == (status, "at its end\n"), done.stderr


POOL = """
import multiprocessing, sys
import daphnis_sim as daphnis

def last(seed):
    settings = {"particles.count": 100}
    return daphnis.run("cooling-gas", f"{sys.argv[1]}/{seed}", set=settings, steps=3, seed=seed).last()

if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        states = pool.map(last, [1, 2])
    print(*[len(state.position) for state in states])
"""


def test_a_spawned_pool_that_returns_states_ends(tmp_path: Path) -> None:
    # In the parent Java is first used by the thread of the pool that takes the states in.
    script = tmp_path / "pool.py"
    script.write_text(POOL)
    words = [sys.executable, str(script), str(tmp_path)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout) == (0, "100 100\n"), done.stderr


def test_a_notebook_ends_with_an_open_view(ring: daphnis.Run) -> None:
    client = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    source = f"import daphnis_sim as daphnis\ndaphnis.open({str(ring.path)!r}).view()"
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source)])
    kernel = client.NotebookClient(notebook, timeout=PATIENCE, kernel_name="python3", shutdown_kernel="graceful")
    manager = kernel.create_kernel_manager()
    killed = []

    def noted(name: str) -> Any:
        end = getattr(manager, name)

        async def call(*_: object, **__: object) -> None:
            killed.append(name)
            await end()

        return call

    for name in ("_async_send_kernel_sigterm", "_async_kill_kernel"):
        setattr(manager, name, noted(name))
    kernel.execute()
    (output,) = notebook.cells[0].outputs
    assert "<iframe" in output["data"]["text/html"]
    assert not killed, "the kernel did not end by itself"
