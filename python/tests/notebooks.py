"""Runs the notebooks of docs, or those named: python python/tests/notebooks.py [NAME...], in place, some ten minutes.

Beside what a notebook shows, each of its cells keeps what it shows in the short form (DAPHNIS_NOTEBOOK_SHORT), as
`short_form` in its metadata. `test_docs.py` does the short form again: where the code now gives other numbers or rows,
what the notebook shows is of another version.
"""

from __future__ import annotations

import ast
import contextlib
import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parents[2] / "docs" / "notebooks"
NOTEBOOKS = sorted(HERE.glob("*.ipynb"))
NUMBER = re.compile(r"[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def cells_of(path: Path) -> list[dict[str, Any]]:
    """The cells of code of the notebook."""
    return [cell for cell in json.loads(path.read_text("utf-8"))["cells"] if cell["cell_type"] == "code"]


def short_form(path: Path) -> list[str]:
    """What each cell of code shows in the short form, as words: what it prints, and its last value without tags."""
    known: dict[str, Any] = {}
    where = os.getcwd()
    os.environ["DAPHNIS_NOTEBOOK_SHORT"] = "yes"
    # readline, which pytest imports, sets it for the programs that are started, whose lines it would break.
    os.unsetenv("COLUMNS")
    try:
        return [shown("".join(cell["source"]), known, str(path)) for cell in cells_of(path)]
    finally:
        del os.environ["DAPHNIS_NOTEBOOK_SHORT"]
        os.chdir(where)


def shown(source: str, known: dict[str, Any], name: str) -> str:
    """Does the cell as a notebook does, in the names `known`."""
    body = ast.parse(source, name).body
    last = body.pop() if isinstance(body[-1], ast.Expr) and not source.rstrip().endswith(";") else None
    with contextlib.redirect_stdout(io.StringIO()) as out:
        exec(compile(ast.Module(body, []), name, "exec"), known)
        value = eval(compile(ast.Expression(last.value), name, "eval"), known) if isinstance(last, ast.Expr) else None
    html = value._repr_html_() if hasattr(value, "_repr_html_") else None
    text = re.sub(r"(?s)<style.*?</style>|<[^>]*>", " ", html) if html else "" if value is None else repr(value)
    return " ".join(f"{out.getvalue()} {text}".split())


def differences(stored: str, now: str) -> list[str]:
    """The words that are others, and the numbers that differ by more than a thousandth."""
    if len(stored.split()) != len(now.split()):
        return [f"{stored} | now {now}"]
    pairs = zip(stored.split(), now.split(), strict=True)
    return [f"{one} is now {other}" for one, other in pairs if not alike(one, other)]


def alike(one: str, other: str) -> bool:
    if one == other:
        return True
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return False
    numbers = [[float(number) for number in NUMBER.findall(word)] for word in (one, other)]
    return all(abs(a - b) <= 1e-3 * abs(a) for a, b in zip(*numbers, strict=True))


def refresh(path: Path) -> None:
    """Runs the notebook in a kernel of its own, then its short form here, and keeps both."""
    words = "nbconvert --to notebook --execute --inplace --ExecutePreprocessor.record_timing=False".split()
    subprocess.run([sys.executable, "-m", *words, str(path)], check=True)
    short = short_form(path)
    notebook = json.loads(path.read_text("utf-8"))
    for cell in notebook["cells"]:
        cell["metadata"].pop("execution", None)
        if cell["cell_type"] == "code":
            cell["metadata"]["short_form"] = short.pop(0)
    path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n", "utf-8")


if __name__ == "__main__":
    import matplotlib

    matplotlib.use("Agg")
    for name in sys.argv[1:] or [path.stem for path in NOTEBOOKS]:
        refresh(HERE / f"{name}.ipynb")
