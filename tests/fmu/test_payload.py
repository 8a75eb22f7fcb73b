"""The code that travels: that of the installation without comments; it imports nothing else."""

from __future__ import annotations

import ast
import io
import sys
import tokenize

import pytest

from build_fmu.payload import bare, package_folder, payload
from build_fmu.platforms import library_path

SOURCES = {path.name: path for path in package_folder("fmu_src").glob("*.py")}


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
    code = payload(2, "points")
    strangers = {
        path: imported(data) - allowed - {code.slave_module.removesuffix("_slave")}
        for path, data in code.files.items()
        if path.endswith(".py")
    }
    assert not {path: names for path, names in strangers.items() if names}


@pytest.mark.parametrize("own", ["linux64", "darwin64", "linux-arm64"])
def test_the_libraries_that_are_compiled_for_this_platform_and_pythonfmus_travel(
    own, tmp_path, monkeypatch
):
    for name in ("linux64", "linux-arm64", "win64", "darwin64"):
        path = library_path(tmp_path, name, 2, "points")
        path.parent.mkdir(parents=True)
        path.write_bytes(name.encode())
    monkeypatch.setattr("build_fmu.payload.own_platform", lambda: own)
    monkeypatch.setattr(
        "build_fmu.payload.library_path", lambda _, *of: library_path(tmp_path, *of)
    )
    found = payload.__wrapped__(2, "points").files
    libraries = {p.partition("/")[2]: data for p, data in found.items() if not p.endswith(".py")}
    assert set(libraries.values()) == {b"linux64", b"win64", own.encode()}
    assert all(name.startswith(data.decode() + ".") for name, data in libraries.items())


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
