"""The version: that of the wheel, or of the checkout."""

from __future__ import annotations

from pathlib import Path


def _read() -> str:
    own = Path(__file__).parent / "version.txt"
    if own.is_file():
        return own.read_text("utf-8").strip()
    for above in Path(__file__).resolve().parents:
        path = above / "core/src/main/resources/daphnis/version.txt"
        if path.is_file():
            return path.read_text("utf-8").strip()
    return "0"


__version__ = _read()
