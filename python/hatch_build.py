"""Puts the jars of the checkout and the version into the wheel."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

HERE = Path(__file__).resolve().parent
CHECKOUT = HERE.parent
BUILT = HERE / "built"
"""What archives of the sources bring along of the checkout, which is not there any more."""

VERSION = BUILT / "version.txt" if BUILT.is_dir() else CHECKOUT / "core/src/main/resources/daphnis/version.txt"

ONLY_OF_PEKKO = ("agrona-", "asn-one-", "config-", "pekko-", "reactive-streams-", "scala-library-", "ssl-config-core")
"""What only the engine `pekko` and runs on several machines need: more than half of all jars."""


class Version(MetadataHookInterface):
    """The version of the package is that of daphnis."""

    PLUGIN_NAME = "custom"

    def update(self, metadata: dict[str, Any]) -> None:
        metadata["version"] = VERSION.read_text("utf-8").strip()


class Jars(BuildHookInterface):
    """Into a wheel and into an archive of the sources. An editable installation looks them up in the checkout."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        place = BUILT.name if self.target_name == "sdist" else "daphnis_sim"
        for name, file in files().items():
            build_data["force_include"][str(file)] = f"{place}/{name}"


def files() -> dict[str, Path]:
    """What the package has besides its modules, by name."""
    if BUILT.is_dir():
        return {path.relative_to(BUILT).as_posix(): path for path in sorted(BUILT.rglob("*")) if path.is_file()}
    jars = [jar for jar in built_jars() if not jar.name.startswith(ONLY_OF_PEKKO)]
    if not jars:
        raise SystemExit(f"no jars in {CHECKOUT}: build them first, with ./daphnis --version or python/build-wheel")
    return {f"jars/{jar.name}": jar for jar in jars} | {
        "version.txt": VERSION,
        "kotlin.json": CHECKOUT / "docs/notebooks/daphnis.json",
        "LICENSE": CHECKOUT / "LICENSE",
        "third-party.md": CHECKOUT / "docs/third-party.md",
    }


def built_jars() -> list[Path]:
    """Those that the package itself finds in a checkout."""
    return list(_module("_built").built_jars(CHECKOUT))


def _module(name: str) -> ModuleType:
    """A module of the package by itself, since what the package needs is not there while it is built."""
    spec = importlib.util.spec_from_file_location(name, HERE / "src" / "daphnis_sim" / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module
