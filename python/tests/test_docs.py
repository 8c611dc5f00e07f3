"""What the documentation shows is run as it stands."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import daphnis_sim as daphnis
from daphnis_sim.kotlin import descriptor
from leisure import at_leisure
from notebooks import NOTEBOOKS, cells_of, differences, short_form, shown

REFRESH = "run the notebook again: python python/tests/notebooks.py NAME, see CONTRIBUTING.md"
CHECKOUT = Path(__file__).resolve().parents[2]


def run_blocks(page: Path) -> int:
    """Runs the blocks of Python in `page` one after the other, as one program; the number of them.

    `<!-- in tests: NAME = VALUE -->` above a block takes the place of the line of that name.
    """
    text = page.read_text("utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)
    for short in re.findall(r"^<!-- in tests: (\w+ = .*?) -->\n```python$", text, re.M):
        name = short.split(" = ")[0]
        assert any(re.search(rf"^{name} = ", block, re.M) for block in blocks), short
        blocks = [re.sub(rf"^{name} = .*$", short, block, flags=re.M) for block in blocks]
    known: dict[str, Any] = {}
    for block in blocks:
        exec(compile(block, str(page), "exec"), known)
    return len(blocks)


EXAMPLES = [
    path for path in sorted((CHECKOUT / "docs" / "examples").glob("*.md")) if "```python" in path.read_text("utf-8")
]
PAGES = (
    "README.md",
    "python/README.md",
    "docs/guide.md",
    "docs/python.md",
    *(f"docs/examples/{path.name}" for path in EXAMPLES),
)


@pytest.mark.parametrize("page", at_leisure(PAGES, {"python/README.md"}))
def test_blocks_of_python_run(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    if "matplotlib" in (CHECKOUT / page).read_text("utf-8") and page.startswith("docs/examples"):
        pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(tmp_path)
    assert run_blocks(CHECKOUT / page) > 0
    assert capsys.readouterr().out


@pytest.mark.parametrize("path", at_leisure(NOTEBOOKS, {"laws"}), ids=lambda path: path.stem)
def test_a_notebook_runs_and_its_numbers_are_those_of_the_code(path: Path) -> None:
    pytest.importorskip("matplotlib").use("Agg")
    assert path.stat().st_size < 420_000
    cells = cells_of(path)
    for cell, now in zip(cells, short_form(path), strict=True):
        assert cell["execution_count"], REFRESH
        assert not [output for output in cell["outputs"] if output["output_type"] == "error"]
        if "numbers-vary" not in cell["metadata"].get("tags", []):
            assert not differences(cell["metadata"].get("short_form", ""), now), REFRESH
    # Pictures and numbers are kept in it.
    kinds = {kind for cell in cells for output in cell["outputs"] for kind in output.get("data", {})}
    assert {"image/png", "text/html"} <= kinds


def test_another_error_or_a_new_row_in_a_notebook_is_seen() -> None:
    stored = "scale_height 2.190664 0.011134 r"
    assert not differences(stored, "scale_height 2.190665 0.011134 r")
    assert differences(stored, "scale_height 2.190664 0.020523 r") == ["0.011134 is now 0.020523"]
    assert differences(stored, "scale_height 2.190664 NaN r") == ["0.011134 is now NaN"]
    assert differences(stored, f"{stored} filling_factor 0.1 0.01")
    assert shown("a = 1.5\nprint(a)\na / 3", {}, "cell") == "1.5 0.5" and shown("2;", {}, "cell") == ""


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_has_links_that_exist_and_no_path_of_a_machine(path: Path) -> None:
    cells = json.loads(path.read_text("utf-8"))["cells"]
    for cell in cells:
        for link in re.findall(r"\]\((?!https?:)([^)#]*)", "".join(cell["source"])):
            assert (path.parent / link).resolve().is_file(), link
    shown = json.dumps([cell.get("outputs", []) for cell in cells if cell["cell_type"] == "code"])
    # Pictures are in base64, which has slashes too.
    shown = re.sub(r'"image/png": "[^"]*"', "", shown)
    assert not re.findall(r"/(?:home|root|tmp|work|Users|private|var|opt)/[^\s\"<]*", shown)
    assert not re.findall(r'"name": "stderr"', shown)


def test_the_guide_lists_every_notebook() -> None:
    listed = re.findall(r"\(notebooks/([\w-]+)\.ipynb\)", (CHECKOUT / "docs" / "python.md").read_text("utf-8"))
    assert sorted(set(listed)) == [path.stem for path in NOTEBOOKS]


def test_the_kotlin_descriptor_names_this_version_and_jars_that_are_there() -> None:
    page = json.loads((CHECKOUT / "docs" / "notebooks" / "daphnis.json").read_text("utf-8"))
    assert page["properties"] == [{"name": "v", "value": daphnis.__version__}]
    own = descriptor()
    assert own["imports"] == page["imports"] and "properties" not in own
    assert len(own["dependencies"]) > 10 and all(Path(jar).is_file() for jar in own["dependencies"])


@pytest.mark.thorough
def test_what_the_documentation_shows_has_the_right_types(tmp_path: Path) -> None:
    api = pytest.importorskip("mypy.api")
    shown = {}
    for path in NOTEBOOKS:
        cells = [cell for cell in json.loads(path.read_text("utf-8"))["cells"] if cell["cell_type"] == "code"]
        shown[path.stem.replace("-", "_")] = "\n".join("".join(cell["source"]) for cell in cells)
    for page in (*PAGES, "docs/batch.md"):
        text = (CHECKOUT / page).read_text("utf-8")
        name = re.sub(r"\W", "_", page.removesuffix(".md"))
        shown[name] = "\n".join(re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S))
    for name, program in shown.items():
        file = tmp_path / f"{name}.py"
        file.write_text(program, "utf-8")
        # The package is typed, so its own modules are looked at as well as what is shown of them.
        words = ["--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path / "cache"), str(file)]
        found, problem, code = api.run(words)
        assert code == 0, f"{name}: {found}{problem}"


def test_what_a_run_has_is_no_maybe() -> None:
    """Without mypy too: what documents use plainly is typed plainly."""
    frame = ("omega", "kappa", "nu", "orbit", "units")
    for kind, names in {daphnis.Run: ("scenario", "summary", "units"), daphnis.Scenario: frame}.items():
        for name in names:
            assert "None" not in str(getattr(kind, name).fget.__annotations__["return"]), name
