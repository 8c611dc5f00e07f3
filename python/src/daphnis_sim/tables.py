"""Tables of runs and of analyses, as pandas has them."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pandas as pd

from ._errors import FormatError, InputError
from ._jvm import java
from ._paths import shown_path

_DECLARED = {
    "series.csv": "daphnis.core.run.SeriesColumns",
    "transport.csv": "daphnis.core.run.TransportColumns",
    "modes.csv": "daphnis.core.run.ModeColumns",
    "impacts.csv": "daphnis.core.run.ImpactColumns",
    "collisions.csv": "daphnis.core.run.CollisionColumns",
}

# From version 3 on pandas reads numbers exactly by itself.
_EXACT: dict[str, Any] = {} if int(pd.__version__.split(".")[0]) >= 3 else {"float_precision": "round_trip"}


def read_table(path: Path, unit: Callable[[str], str] | None = None) -> pd.DataFrame:
    """The table in `path`, of a run or of an analysis; ``attrs["units"]`` has the unit of each column.

    A last line that a run is still writing is left out. Numbers have the bits that were written. An empty cell is NaN.

    Args:
        unit: what the unit of a dimension is called, for a table of a run, which has no units in its header.

    Raises:
        InputError: there is no such file.
        FormatError: it is no such table.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InputError(f"{path}: no such file") from None
    except (OSError, UnicodeDecodeError) as e:
        raise FormatError(f"{path}: cannot be read: {e}") from None
    whole = text[: text.rfind("\n") + 1]
    try:
        table = pd.read_csv(io.StringIO(whole), **_EXACT) if whole else pd.DataFrame()
    except (pd.errors.ParserError, pd.errors.EmptyDataError, ValueError) as e:
        raise FormatError(f"{path}: is not a table: {' '.join(str(e).split())}") from None
    return _declared(path, table, unit) if path.name in _DECLARED else _headed(table)


def _declared(path: Path, table: pd.DataFrame, unit: Callable[[str], str] | None) -> pd.DataFrame:
    """A table of a run, whose columns the library knows; their heads may say their units."""
    table = _headed(table)
    # Columns that only some runs have, such as those of materials, are not among the declared ones.
    units = table.attrs["units"]
    for column in java(_DECLARED[path.name]).INSTANCE.getColumns():
        name = str(column.getName())
        if name in table:
            if not pd.api.types.is_numeric_dtype(table[name]) and len(table):
                raise FormatError(f"{path}: column {name} holds what is not a number")
            units[name] = unit(str(column.getDimension())) if unit else str(column.getDimension())
        elif str(column.getNeed().name()) == "NEEDED" and len(table.columns):
            raise FormatError(f"{path}: column '{name}' is missing")
    table.attrs["units"] = units
    return table


def _headed(table: pd.DataFrame) -> pd.DataFrame:
    """A table with units in its header: `x [m]`."""
    units = {}
    names = []
    for header in table.columns:
        found = re.fullmatch(r"(.*?) \[(.*)\]", str(header))
        name, unit = found.groups() if found else (str(header), "")
        names.append(name)
        units[name] = unit
    table.columns = pd.Index(names)
    table.attrs["units"] = units
    return table


class Tables(Mapping[str, pd.DataFrame]):
    """The tables that ``analyze`` wrote into a directory, by name, each read when it is asked for."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory

    def __getitem__(self, name: str) -> pd.DataFrame:
        if name not in list(self):
            known = ", ".join(self) or "none, before analyze()"
            raise KeyError(f"{name!r}: no such table in {self._directory}; there are {known}")
        return read_table(self._directory / f"{name}.csv")

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(path.stem for path in self._directory.glob("*.csv")))

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __contains__(self, name: Any) -> bool:
        return name in list(self)

    def __repr__(self) -> str:
        return f"<tables in {shown_path(self._directory)!r}: {', '.join(self)}>"
