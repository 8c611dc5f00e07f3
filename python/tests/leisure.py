"""Which cases of a test `./check` alone leaves to `./check --all`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterable


def at_leisure(values: Iterable[Any], quick: set[str]) -> list[Any]:
    """All `values`, those that are not in `quick` with the mark `thorough`; a path goes by its name."""

    def is_quick(value: Any) -> bool:
        return (value.stem if isinstance(value, Path) else value) in quick

    return [value if is_quick(value) else pytest.param(value, marks=pytest.mark.thorough) for value in values]
