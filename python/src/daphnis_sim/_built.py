"""The jars that Maven or Gradle built in a checkout."""

from __future__ import annotations

import zipfile
from pathlib import Path

_MAIN = "daphnis.app.MainKt"


def built_jars(checkout: Path) -> list[Path]:
    """The jars that Maven or Gradle built in `checkout`, whatever they are called; empty without any.

    They are the jar whose manifest names the main class and, from Maven, what its `Class-Path` lists; from Gradle, its
    whole folder. So what an earlier build left in the folder of libraries is not among them.
    """
    for jar in sorted((checkout / "target").glob("*.jar"), key=lambda path: -path.stat().st_mtime):
        manifest = _manifest(jar)
        if manifest.get("Main-Class") == _MAIN:
            return [jar] + [jar.parent / entry for entry in manifest.get("Class-Path", "").split()]
    return sorted((checkout / "build" / "install").glob("*/lib/*.jar"))


def _manifest(jar: Path) -> dict[str, str]:
    try:
        with zipfile.ZipFile(jar) as archive:
            text = archive.read("META-INF/MANIFEST.MF").decode("utf-8")
    except (OSError, KeyError, zipfile.BadZipFile):
        return {}
    # A long line goes on in the next, after a space.
    lines = text.replace("\r\n", "\n").replace("\n ", "").split("\n")
    return dict(line.split(": ", 1) for line in lines if ": " in line)
