"""Processes of Python end, however they end and whatever is left open: each here in one of its own."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import daphnis_sim as daphnis
from leisure import at_leisure

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
    "at once": ("os._exit(5)", 5),
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


@pytest.mark.parametrize("left_open", at_leisure(LEFT_OPEN, {"view"}))
def test_a_process_ends_with_what_it_left_open(ring: daphnis.Run, tmp_path: Path, left_open: str) -> None:
    done = ended(LEFT_OPEN[left_open] + "print('at its end')", str(ring.path), str(tmp_path / "run"))
    assert (done.returncode, done.stdout) == (0, "at its end\n"), done.stderr


@pytest.mark.skipif(os.name == "nt", reason="Windows has no signals to be sent")
@pytest.mark.parametrize("way", at_leisure(WAYS, {"plain", "ctrl-c"}))
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


@pytest.mark.thorough
def test_a_spawned_pool_that_returns_states_ends(tmp_path: Path) -> None:
    # In the parent Java is first used by the thread of the pool that takes the states in.
    script = tmp_path / "pool.py"
    script.write_text(POOL)
    words = [sys.executable, str(script), str(tmp_path)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout) == (0, "100 100\n"), done.stderr


MANY = """
import concurrent.futures, multiprocessing, os, signal, sys, threading, time
import daphnis_sim as daphnis

kind, method, way, out = sys.argv[1:]

def work(seed):
    def watch(simulation):
        open(f"{out}/begun-{seed}", "w").close()
        if way == "killed":
            os.kill(os.getpid(), signal.SIGTERM)
    settings = {"particles.count": 50}
    steps = 5 if way in ("plain", "forked") else 10**7
    daphnis.run("cooling-gas", f"{out}/run-{seed}", set=settings, steps=steps, seed=seed, watch=watch)
    return seed

def strike():
    while not all(os.path.exists(f"{out}/begun-{seed}") for seed in (1, 2)):
        time.sleep(0.05)
    if way == "raises":
        os.kill(os.getpid(), signal.SIGUSR1)
    # To all of the group, as a terminal and a batch system do.
    if way == "ctrl-c":
        os.killpg(0, signal.SIGINT)
        if kind == "threads":
            time.sleep(1)
            os.killpg(0, signal.SIGINT)
    if way == "sigterm":
        os.killpg(0, signal.SIGTERM)

def raises(*_):
    raise ValueError("of the program")

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGUSR1, raises)
    if way == "forked":
        daphnis.scenarios()
    threading.Thread(target=strike, daemon=True).start()
    if kind == "threads":
        workers = concurrent.futures.ThreadPoolExecutor(2)
    elif kind == "pool":
        workers = multiprocessing.get_context(method).Pool(2)
    else:
        workers = concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(method))
    with workers:
        print(list(workers.map(work, [1, 2])))
"""

ENDINGS = {
    ("pool", "spawn", "ctrl-c"): (-signal.SIGINT, "KeyboardInterrupt", 2),
    ("pool", "spawn", "sigterm"): (-signal.SIGTERM, "", 2),
    ("pool", "spawn", "raises"): (1, "ValueError: of the program", 2),
    ("pool", "fork", "plain"): (0, "", 0),
    ("pool", "fork", "forked"): (1, "JavaError: this process was forked from one with Java", None),
    ("executor", "forkserver", "ctrl-c"): (-signal.SIGINT, "KeyboardInterrupt", 2),
    ("executor", "spawn", "sigterm"): (-signal.SIGTERM, "", 2),
    ("executor", "spawn", "killed"): (1, "BrokenProcessPool", None),
    ("threads", "-", "ctrl-c"): (-signal.SIGINT, "KeyboardInterrupt", 2),
}
"""Kind, method and way: the status, what is said, and how many of two runs have a checkpoint before their end."""


@pytest.fixture(scope="module")
def endings(tmp_path_factory: pytest.TempPathFactory) -> dict[tuple[str, str, str], Any]:
    """All of `ENDINGS`, at once; each program leads a group of its own."""
    folder = tmp_path_factory.mktemp("endings")
    script = folder / "many.py"
    script.write_text(MANY)
    begun = {}
    for case in ENDINGS:
        out = folder / "-".join(case).replace(" ", "")
        out.mkdir()
        words = [sys.executable, str(script), *case, str(out)]
        process = subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
        )
        begun[case] = process, out
    return begun


@pytest.mark.thorough
@pytest.mark.skipif(os.name == "nt", reason="Windows has no signals to be sent")
@pytest.mark.parametrize("case", ENDINGS, ids="-".join)
def test_pools_and_threads_end_with_what_they_run(endings: Any, case: tuple[str, str, str]) -> None:
    process, out = endings[case]
    status, words, unfinished = ENDINGS[case]
    try:
        said, complained = process.communicate(timeout=2 * PATIENCE)
    finally:
        # What of the group is left, if it has failed.
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    assert process.returncode == status and words in complained, said + complained
    assert "SIGSEGV" not in said + complained
    if unfinished is not None:
        finished = [daphnis.open(out / f"run-{seed}").finished for seed in (1, 2)]
        assert finished.count(False) == unfinished
    if unfinished == 2:
        # It goes on, so nothing is torn.
        run = daphnis.open(out / "run-1")
        assert run.resume(until=run.last().time + 1e-3).finished


SWEEP = """
import os, signal, sys
import daphnis_sim as daphnis
signal.signal(signal.SIGINT, signal.default_int_handler)

def strike(simulation):
    if len(sys.argv) > 2 and simulation.step == 3:
        os.kill(os.getpid(), getattr(signal, sys.argv[2]))

for seed in (1, 2, 3):
    out = f"{sys.argv[1]}/{seed}"
    watch = strike if seed == 2 else None
    if not os.path.isdir(out):
        run = daphnis.run("cooling-gas", out, set={"particles.count": 50}, steps=6, seed=seed, watch=watch)
    elif not daphnis.open(out).finished:
        run = daphnis.resume(out)
    else:
        run = daphnis.open(out)
    print(seed, run.summary["stateDigest"])
"""


@pytest.mark.thorough
@pytest.mark.skipif(os.name == "nt", reason="Windows has no signals to be sent")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_sweep_that_is_interrupted_ends_and_goes_on(tmp_path: Path, name: str) -> None:
    def swept(*words: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", SWEEP, *words]
        return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)

    broken = swept(str(tmp_path / "broken"), name)
    assert broken.returncode == -getattr(signal, name), broken.stderr
    assert broken.stdout.startswith("1 ") and broken.stdout.count("\n") == 1
    assert not (tmp_path / "broken" / "3").exists() and not daphnis.open(tmp_path / "broken" / "2").finished
    assert swept(str(tmp_path / "broken")).stdout == swept(str(tmp_path / "whole")).stdout


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
