"""The code that travels: that of the installation without comments; it imports nothing else."""

from __future__ import annotations

import ast
import io
import sys
import tokenize
from pathlib import PurePosixPath

import pytest

from build_fmu.payload import bare, package_folder, payload, relative_imports

SOURCES = {
    path.relative_to(package_folder(name).parent).as_posix(): path
    for name in ("fmu_src", "solver")
    for path in package_folder(name).rglob("*.py")
    if name == "fmu_src" or "runtime" in path.parts
}


@pytest.mark.parametrize(
    ("path", "line", "expected"),
    [
        ("slave.py", "from solver.runtime import Model", "from .runtime import Model"),
        ("runtime/a.py", "    from solver.runtime.b import c", "    from ..runtime.b import c"),
        ("slave.py", "from solver import runtime", "from solver import runtime"),
        ("slave.py", "import json", "import json"),
    ],
)
def test_imports_become_relative(path, line, expected):
    assert relative_imports(line, PurePosixPath(path)) == expected


def imported(source: bytes) -> set[str]:
    """Top-level names of absolute imports anywhere in a module."""
    names = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names.add((node.module or "").split(".")[0])
    return names


def test_what_travels_imports_the_standard_library_and_itself_alone():
    allowed = set(sys.stdlib_module_names)
    strangers = {
        path: imported(data) - allowed - {payload(2).slave_module.removesuffix("_slave")}
        for path, data in payload(2).files.items()
        if path.endswith(".py")
    }
    assert not {path: names for path, names in strangers.items() if names}


def without_docstrings(source: str) -> str:
    """Syntax tree with places, docstrings as the constants that stand in for them."""
    tree = ast.parse(source)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            said = [
                s for s in body if isinstance(s, ast.Expr) and isinstance(s.value, ast.Constant)
            ]
            node.body = [s for s in body if s not in said] or [ast.Pass()]
            # A class or function ends with its last statement, which may have been one of these.
            node.end_lineno = node.end_col_offset = 0
    return ast.dump(tree, include_attributes=True)


@pytest.mark.parametrize("path", sorted(SOURCES), ids=str)
def test_code_travels_without_comments_and_docstrings_and_is_else_the_same(path):
    source = SOURCES[path].read_text(encoding="utf-8")
    found = bare(source)
    assert without_docstrings(found) == without_docstrings(source)
    kinds = {token.type for token in tokenize.generate_tokens(io.StringIO(found).readline)}
    assert tokenize.COMMENT not in kinds
    nodes = (node for node in ast.walk(ast.parse(found)) if hasattr(node, "body"))
    kinds = (ast.Module, ast.ClassDef, ast.FunctionDef)
    assert not [node for node in nodes if isinstance(node, kinds) and ast.get_docstring(node)]
