"""Arguments of a wrong type or name, and what is pickled, copied and shown."""

from __future__ import annotations

import copy
import inspect
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import daphnis_sim as daphnis
from daphnis_sim._jvm import java
from daphnis_sim.scenarios import Units
from daphnis_sim.view import View

FUNCTIONS: dict[str, tuple[Callable[..., Any], tuple[Any, ...]]] = {
    "run": (daphnis.run, ("ring-patch",)),
    "resume": (daphnis.resume, ("x",)),
    "analyze": (daphnis.analyze, ("x",)),
    "scenario": (daphnis.scenario, ("ring-patch",)),
    "Simulation": (daphnis.Simulation, ("ring-patch",)),
    "open": (daphnis.open, ()),
    "Run": (daphnis.Run, ("x",)),
    "universe": (daphnis.universe, ("x",)),
    "start": (daphnis.start, ()),
}
EVERY = [
    (name, word)
    for name, (function, first) in FUNCTIONS.items()
    for k, (word, hint) in enumerate(
        (word, hint)
        for word, hint in inspect.signature(function).parameters.items()
        if hint.kind is not hint.VAR_POSITIONAL
    )
    # Arrays of a simulation are looked at one by one.
    if k >= len(first) and "ArrayLike" not in str(hint.annotation)
]


@pytest.mark.parametrize(("name", "word"), EVERY)
def test_every_argument_of_a_wrong_type_is_named_at_once(name: str, word: str) -> None:
    function, first = FUNCTIONS[name]
    with pytest.raises(TypeError, match=f"^{word}: is .*; it must be .") as caught:
        function(*first, **{word: object()})
    assert isinstance(caught.value, daphnis.InputError)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"watch": 5}, "watch: is 5; it must be a function or None"),
        ({"set": "a=1"}, r"set: is 'a=1'; it must be a dict such as {'until': 10} or None"),
        ({"set": {5: 1}}, r"set: has a key that is no text: \[5\]"),
        ({"threads": "2"}, "threads: is '2'; it must be a whole number or None"),
        ({"steps": True}, "steps: is True; it must be a whole number"),
        ({"seed": 1.5}, "seed: is 1.5; it must be a whole number"),
        ({"until": "9"}, "until: is '9'; it must be a number"),
        ({"force": "no"}, "force: is 'no'; it must be True or False"),
        ({"forces": 5}, "forces: is 5; it must be a list of what daphnis.kick or daphnis.acceleration made"),
        ({"unitl": 5}, "run: has no argument 'unitl'; did you mean until?"),
        ({"zzz": 5}, "run: has no argument 'zzz'; there are scenario, out, set"),
    ],
)
def test_what_it_may_be_is_said(options: dict[str, Any], words: str, tmp_path: Path) -> None:
    with pytest.raises(TypeError, match=words):
        daphnis.run("ring-patch", tmp_path / "run", **options)
    assert not (tmp_path / "run").exists()


def test_methods_look_at_their_arguments_too(ring: daphnis.Run) -> None:
    calls: dict[str, Callable[[], Any]] = {
        "frames": lambda: ring.analyze(frames="3"),  # type: ignore[arg-type]
        "frmes": lambda: ring.analyze(frmes=3),  # type: ignore[call-arg]
        "untl": lambda: ring.resume(untl=3),  # type: ignore[call-arg]
        "time": lambda: ring.at("3"),  # type: ignore[arg-type]
        "step": lambda: ring.at_step(1.5),  # type: ignore[arg-type]
        "height": lambda: ring.view(height="9"),  # type: ignore[arg-type]
        "path": lambda: ring.scenario.write(5),  # type: ignore[arg-type]
        "k": lambda: ring.states()["a"],  # type: ignore[index]
        "restitution": lambda: daphnis.restitution(5),  # type: ignore[arg-type]
        "force": lambda: daphnis.kick(5),  # type: ignore[call-overload]
    }
    for word, call in calls.items():
        with pytest.raises(TypeError, match=f"{word}'?[:;]"):
            call()


def test_numbers_of_numpy_are_taken(ring: daphnis.Run) -> None:
    assert ring.at_step(np.int64(20)).step == 20  # type: ignore[arg-type]
    assert ring.at(np.float32(0)).step == 0  # type: ignore[arg-type]
    assert len(ring.states()[-1]) == len(ring.last())


def test_a_method_of_a_run_has_the_arguments_of_the_function() -> None:
    for name in ("analyze", "resume"):
        function = list(inspect.signature(getattr(daphnis, name)).parameters.values())[1:]
        method = list(inspect.signature(getattr(daphnis.Run, name)).parameters.values())[1:]
        assert method == function


MACHINES = {"bind", "cluster", "config", "host", "insecure", "nodes", "secret-file"}
ELSEWHERE = {
    # `run.view()` is the page.
    "run": {"quiet", "live", *MACHINES},
    "resume": {"quiet", "live", "threads", *MACHINES},
    # `scenario=daphnis.scenario(…, set=…)`
    "analyze": {"quiet", "set"},
}
OF_PYTHON = {"restitution", "roughness", "contact_law", "forces", "watch", "progress"}


@pytest.mark.parametrize("name", ELSEWHERE)
def test_functions_have_the_options_of_the_command_line(name: str) -> None:
    command = java(f"daphnis.app.{name.capitalize()}Command")()
    options = {str(word).lstrip("-") for option in command.registeredOptions() for word in option.getNames()}
    assert options > ELSEWHERE[name]
    known = {word.replace("-", "_") for word in options - ELSEWHERE[name]}
    known = {"from_" if word == "from" else word for word in known}
    keywords = {word for word, p in inspect.signature(getattr(daphnis, name)).parameters.items()}
    arguments = {"run": {"scenario"}, "resume": {"path", "scenario", "set"}, "analyze": {"what"}}[name]
    assert keywords - OF_PYTHON - arguments == known


WRONG = """
import daphnis_sim as daphnis
run = daphnis.open("x")
daphnis.analyze("x", frmes=3)
run.analyze(frmes=3)
run.resume(untl=3)
daphnis.run("x", watch=5)
daphnis.run("x", set="a=1")
daphnis.Simulation("x", threads="2")
run.analyze(frames=3, footprint=(5, 4), elevations=[20.0]).numbers
run.resume(until=3).last()
"""


def test_a_checker_of_types_sees_what_is_wrong(tmp_path: Path) -> None:
    api = pytest.importorskip("mypy.api")
    file = tmp_path / "wrong.py"
    file.write_text(WRONG, "utf-8")
    found, problem, _ = api.run(["--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path / "c"), str(file)])
    lines = [int(line.split(":")[1]) for line in found.splitlines() if " error: " in line]
    assert lines == [4, 5, 6, 7, 8, 9], found + problem


def falling(speed: float) -> float:
    return 0.9


@daphnis.restitution
def ice(speed: float) -> float:
    return 0.5


@daphnis.acceleration
def drag(spheres: daphnis.Spheres, time: float) -> Any:
    return -spheres.velocity


def same(a: Any, b: Any) -> bool:
    if isinstance(a, daphnis.State):
        return a.time == b.time and bool((a.position == b.position).all())
    if isinstance(a, (daphnis.Restitution, daphnis.Force)):
        return bool(a.function is b.function)
    for word in ("json", "path", "length"):
        if hasattr(a, word):
            return bool(getattr(a, word) == getattr(b, word))
    return list(a) == list(b) if not isinstance(a, daphnis.States) else len(a) == len(b)


def test_what_is_sent_through_pools_is_pickled_and_copied(ring: daphnis.Run, tmp_path: Path) -> None:
    report = ring.analyze(out=tmp_path, from_=0.0, frames=2)
    sent = [ring, ring.scenario, ring.units, ring.last(), ring.states(), report, report.tables, report.pictures]
    sent += [report.pictures[next(iter(report.pictures))], ice, drag, daphnis.restitution(falling)]
    for thing in sent:
        for other in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
            assert type(other) is type(thing) and same(thing, other), thing
    assert pickle.loads(pickle.dumps(ring)).notices == ring.notices
    again = pickle.loads(pickle.dumps(daphnis.scenario("moonlet", set={"until": 5})))
    assert again.to_dict()["until"] == 5 and again.source == "moonlet"


def test_a_copy_of_a_state_has_arrays_of_its_own_and_the_run(ring: daphnis.Run) -> None:
    state = ring.last()
    state.position[0] = 7
    deep, flat = copy.deepcopy(state), copy.copy(state)
    assert deep.run is flat.run is ring and deep.position[0, 0] == 7
    deep.position[0] = 8
    assert state.position[0, 0] == 7
    assert flat.position is state.position


def test_what_lives_in_its_process_says_so(ring: daphnis.Run) -> None:
    view = ring.view()
    with daphnis.Simulation("cooling-gas", set={"particles.count": 10}) as simulation:
        for thing, way in ((simulation, r"state\(\) can"), (view, "its address can")):
            for act in (pickle.dumps, copy.copy, copy.deepcopy):
                with pytest.raises(TypeError, match=way):
                    act(thing)
    view.close()


def test_errors_come_out_of_a_pool_as_they_are() -> None:
    with pytest.raises(daphnis.InputError) as caught:
        daphnis.scenario("ring-patch", set={"particles.opticalDeth": 1})
    assert caught.value.java is not None
    other = pickle.loads(pickle.dumps(caught.value))
    assert type(other) is type(caught.value) and str(other) == str(caught.value) and other.java is None
    ended = pickle.loads(pickle.dumps(daphnis.Interrupted("interrupted", Path("x"))))
    assert (str(ended), ended.path) == ("interrupted", Path("x"))


def test_every_public_class_says_in_a_line_what_it_is(ring: daphnis.Run, tmp_path: Path) -> None:
    report = ring.analyze(out=tmp_path, from_=0.0, frames=2)
    seen: list[daphnis.Spheres] = []

    @daphnis.kick
    def looking(spheres: daphnis.Spheres, time: float, duration: float) -> Any:
        seen.append(spheres)
        return np.zeros((len(spheres), 3))

    @daphnis.contact_law
    def both(contact: daphnis.Contact) -> tuple[float, float]:
        return 0.5, 0.0

    @daphnis.roughness
    def rough(contact: daphnis.Contact) -> float:
        return 0.0

    simulation = daphnis.Simulation("cooling-gas", set={"particles.count": 10}, forces=[looking]).advance()
    view = ring.view()
    contact = daphnis.Contact(1.0, 0.0, 0.5, 0.4, (1.0, 1.0), (1.0, 1.0), (0, 0))
    shown: list[Any] = [ring, ring.scenario, ring.units, ring.states(), ring.last(), report, report.tables, view]
    shown += [report.pictures, report.pictures[next(iter(report.pictures))], simulation, seen[0], contact]
    shown += [ice, looking, both, rough]
    shown += [daphnis.Task("a", "/nowhere", "{}", "gas"), daphnis.Outcome("a", "/nowhere", True)]
    shown += [daphnis.Sweep(tmp_path / "gone", [])]
    known = {getattr(daphnis, name) for name in daphnis.__all__} | {View, Units}
    classes = {one for one in known if isinstance(one, type) and not issubclass(one, BaseException)}
    assert classes <= {type(one) for one in shown}
    for one in shown:
        text = repr(one)
        assert "\n" not in text and " at 0x" not in text and len(text) < 400, text
    assert repr(ring.units) == "<Units length 'm', time 's', mass 'kg'>"
    assert (repr(ice), repr(looking)) == ("<Restitution ice>", "<Force looking>")
    simulation.close()
    view.close()
    assert repr(simulation).startswith("<Simulation of 10 spheres")


def test_a_report_without_its_files_is_still_shown(tmp_path: Path) -> None:
    assert repr(daphnis.Report(tmp_path / "gone", [])).startswith("<Report ")


NEWEST = os.environ.get("JDK25_HOME") or next(map(str, sorted(Path("/usr/lib/jvm").glob("*25*"))), None)
"""As in ./check."""


@pytest.mark.skipif(not NEWEST, reason="no JDK with the vector unit here")
def test_the_vector_unit_is_in_use_without_a_line_and_other_lines_come_through() -> None:
    program = """
import sys, daphnis_sim as daphnis, jpype
daphnis.scenarios()
print(jpype.JClass("java.lang.ModuleLayer").boot().findModule("jdk.incubator.vector").isPresent())
"""
    options = {**os.environ, "JAVA_HOME": str(NEWEST), "DAPHNIS_VECTOR": ""}

    def done(java_opts: str) -> subprocess.CompletedProcess[str]:
        words = [sys.executable, "-c", program]
        return subprocess.run(words, capture_output=True, text=True, env={**options, "JAVA_OPTS": java_opts})

    plain = done("")
    assert (plain.stdout, plain.stderr) == ("True\n", "")
    # Java ends the process, before anything of Python sees it.
    ended = done("-Xlog:os=info:stderr -Xmx4k")
    assert ended.returncode == 1 and "[os]" in ended.stderr and "Too small" in ended.stdout
