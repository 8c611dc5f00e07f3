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
VERSION = CHECKOUT / "core/src/main/resources/daphnis/version.txt"

ONLY_OF_PEKKO = ("agrona-", "asn-one-", "config-", "pekko-", "reactive-streams-", "scala-library-", "ssl-config-core")
"""What only the engine `pekko` and runs on several machines need: more than half of all jars."""


class Version(MetadataHookInterface):
    """The version of the package is that of daphnis."""

    PLUGIN_NAME = "custom"

    def update(self, metadata: dict[str, Any]) -> None:
        metadata["version"] = VERSION.read_text("utf-8").strip()


class Jars(BuildHookInterface):
    """An editable installation looks the jars up in the checkout, so it gets none."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        jars = [jar for jar in built_jars() if not jar.name.startswith(ONLY_OF_PEKKO)]
        if not jars:
            raise SystemExit(f"no jars in {CHECKOUT}: build them first, with ./daphnis --version or python/build-wheel")
        forced = build_data["force_include"]
        for jar in jars:
            forced[str(jar)] = f"daphnis_sim/jars/{jar.name}"
        forced[str(VERSION)] = "daphnis_sim/version.txt"
        forced[str(CHECKOUT / "docs" / "notebooks" / "daphnis.json")] = "daphnis_sim/kotlin.json"
        forced[str(CHECKOUT / "LICENSE")] = "daphnis_sim/LICENSE"
        forced[str(CHECKOUT / "docs" / "third-party.md")] = "daphnis_sim/third-party.md"


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
