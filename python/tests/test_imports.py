"""What modules of the package import of one another: never in a circle."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import daphnis_sim

# The type of an attribute and of an argument only: a state of a recorded run knows it.
ANNOTATIONS = {("states", "runs")}


def imports(module: str, source: str, modules: set[str], for_types: bool) -> Iterator[str]:
    """What `module` imports of `modules`, in functions too, and for types only if asked for."""
    tree = ast.parse(source)
    skipped = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test) in ("TYPE_CHECKING", "typing.TYPE_CHECKING"):
            skipped.update(id(inner) for statement in node.body for inner in ast.walk(statement))
    for node in ast.walk(tree):
        if id(node) in skipped and not for_types:
            continue
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            start = "daphnis_sim" if node.level else ""
            base = ".".join(part for part in (start, node.module) if part)
            names = [f"{base}.{alias.name}" for alias in node.names]
        else:
            continue
        for name in names:
            parts = name.split(".")
            if parts[0] == "daphnis_sim":
                found = parts[1] if len(parts) > 1 and parts[1] in modules else "__init__"
                if found != module:
                    yield found


def circle(graph: dict[str, set[str]]) -> list[str]:
    """The modules of a circle, the first one again at the end; none without one."""
    done: set[str] = set()

    def from_(module: str, way: list[str]) -> list[str]:
        if module in way:
            return [*way[way.index(module) :], module]
        if module in done:
            return []
        for other in sorted(graph[module]):
            if found := from_(other, [*way, module]):
                return found
        done.add(module)
        return []

    return next((found for module in sorted(graph) if (found := from_(module, []))), [])


def package(for_types: bool) -> dict[str, set[str]]:
    """Each module of the package with those that it imports."""
    sources = {path.stem: path.read_text("utf-8") for path in Path(daphnis_sim.__file__).parent.glob("*.py")}
    return {module: set(imports(module, text, set(sources), for_types)) for module, text in sources.items()}


def test_no_modules_import_one_another_in_a_circle() -> None:
    assert circle(package(for_types=False)) == []


def test_nor_for_their_types_but_for_what_is_named_here() -> None:
    graph = package(for_types=True)
    for module, other in ANNOTATIONS:
        graph[module].remove(other)
    assert circle(graph) == []


def test_a_circle_is_found_also_in_functions_and_for_types() -> None:
    modules = {"__init__", "a", "b", "c"}
    of_a = "def f():\n    from .b import g\n"
    of_c = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import daphnis_sim.a\n"
    graph = {
        "a": set(imports("a", of_a, modules, True)),
        "b": set(imports("b", "from . import c\n", modules, True)),
        "c": set(imports("c", of_c, modules, True)),
    }
    assert circle(graph) == ["a", "b", "c", "a"]
    assert list(imports("c", of_c, modules, False)) == []
