"""``python -m daphnis_sim.kotlin``: a descriptor for notebooks with the Kotlin kernel, with the jars here."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from ._errors import JavaError
from ._jvm import jars

_OF_KERNEL = ("kotlin-stdlib", "kotlin-reflect", "annotations-", "slf4j-")
"""What the kernel brings itself."""


def descriptor() -> dict[str, Any]:
    """``docs/notebooks/daphnis.json`` with the jars of this installation in place of those of a repository."""
    own = Path(__file__).parent / "kotlin.json"
    checkout = Path(__file__).resolve().parents[3] / "docs" / "notebooks" / "daphnis.json"
    found: dict[str, Any] = json.loads((own if own.is_file() else checkout).read_text("utf-8"))
    found.pop("properties", None)
    found.pop("repositories", None)
    found["dependencies"] = [str(jar) for jar in jars() if not jar.name.startswith(_OF_KERNEL)]
    return found


if __name__ == "__main__":
    try:
        json.dump(descriptor(), sys.stdout, indent=2)
        print()
    except JavaError as e:
        sys.exit(f"daphnis: {e}")
