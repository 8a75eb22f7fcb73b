"""The code that travels: it imports nothing else, and has libraries of several platforms."""

from __future__ import annotations

import ast
import sys

import pytest

from build_fmu.payload import SLAVE_NAME, payload
from build_fmu.platforms import library_path


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
    own = {path.partition("/")[0] for path in code}
    strangers = {
        path: imported(data) - allowed - own for path, data in code.items() if path.endswith(".py")
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
    found = payload.__wrapped__(2, "points")
    libraries = {
        path.partition("/")[2]: data
        for path, data in found.items()
        if not path.endswith((".py", SLAVE_NAME))
    }
    assert set(libraries.values()) == {b"linux64", b"win64", own.encode()}
    assert all(name.startswith(data.decode() + ".") for name, data in libraries.items())
