"""Paths as a reader sees them."""

from __future__ import annotations

from pathlib import Path


def shown_path(path: Path) -> str:
    """`path` as it is written from the working directory, if it lies in it."""
    return str(path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path)
