"""Modules import each other without a circle: each can be read before those that use it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("holonom", "solver", "fmu_src", "build_fmu", "viewer", "build_kernel")


def modules(root: Path, packages: tuple[str, ...]) -> dict[str, Path]:
    """Files by their dotted names."""
    found = {}
    for path in (path for package in packages for path in (root / package).rglob("*.py")):
        parts = path.relative_to(root).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports_on_loading(tree: ast.Module) -> Iterator[ast.Import | ast.ImportFrom]:
    """Imports outside functions; not those that only a type checker sees."""
    waiting: list[ast.stmt] = list(tree.body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If):
            waiting += node.orelse if ast.unparse(node.test) == "TYPE_CHECKING" else node.body
        elif isinstance(node, ast.Try | ast.With):
            waiting += node.body


def imported(name: str, path: Path, node: ast.Import | ast.ImportFrom) -> list[str]:
    """Dotted names that an import statement of a module may mean."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    above = package[: len(package) + 1 - node.level] if node.level else []
    base = ".".join([*above, *filter(None, [node.module])])
    return [base, *(f"{base}.{alias.name}" for alias in node.names)]


def graph(known: dict[str, Path]) -> dict[str, set[str]]:
    """Modules that each one loads; of a name within a package the module, not the package."""
    needs: dict[str, set[str]] = {}
    for name, path in known.items():
        needs[name] = set()
        for node in imports_on_loading(ast.parse(path.read_text(encoding="utf-8"))):
            meant = [each for each in imported(name, path, node) if each in known]
            needs[name] |= {*meant[1:]} or {*meant}
        needs[name].discard(name)
    return needs


def test_modules_import_each_other_without_a_circle():
    TopologicalSorter(graph(modules(ROOT, PACKAGES))).prepare()


def test_a_circle_is_found(tmp_path):
    (tmp_path / "made").mkdir()
    for name, other in (("first", "second"), ("second", "first")):
        (tmp_path / "made" / f"{name}.py").write_text(f"from made.{other} import x\n")
    with pytest.raises(CycleError):
        TopologicalSorter(graph(modules(tmp_path, ("made",)))).prepare()
