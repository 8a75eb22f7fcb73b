"""What the repository promises of itself: short files and functions, no traces of one machine."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
CODE = ("solver", "fmu_src", "build_fmu", "build_kernel", "benchmarks")
TEXT = (*CODE, "docs", "scenes", "tests")
FILE_LINES = 300
FUNCTION_LINES = 45
STEP_LINES = 80
"""The step itself reads as one page of equations."""

MACHINE_PATH = re.compile(r"(?<![\w.])/(?:home|root|Users|work|tmp)/\w|[A-Z]:\\\\?Users", re.ASCII)


def files(folders: tuple[str, ...], *suffixes: str) -> list[Path]:
    """Files below folders of the repository, without what is built."""
    found = [path for folder in folders for path in sorted((ROOT / folder).rglob("*"))]
    return [path for path in found if path.suffix in suffixes and "_kernel" not in path.parts]


def python_functions(path: Path) -> dict[str, int]:
    """Lines of every function of a Python file, without its docstring."""
    lengths = {}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            documented = ast.get_docstring(node) is not None
            body = node.body[0]
            docstring = (body.end_lineno or 0) - body.lineno + 1 if documented else 0
            lengths[f"{node.lineno}: {node.name}"] = (
                (node.end_lineno or 0) - node.lineno + 1 - docstring
            )
    return lengths


def c_functions(path: Path) -> dict[str, int]:
    """Lines of every function of a C file; its braces stand in the first column or end a line."""
    lengths: dict[str, int] = {}
    signature = ""
    start = 0
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if named := re.match(r"[A-Za-z].*?(\w+)\s*\(", line):
            signature, start = named[1], number
        elif line.startswith("}") and signature:
            lengths[f"{start}: {signature}"] = number - start + 1
            signature = ""
    return lengths


def relative(path: Path) -> str:
    """Name of a file in a test's title."""
    return path.relative_to(ROOT).as_posix()


@pytest.mark.parametrize("path", files(CODE, ".py", ".c", ".h"), ids=relative)
def test_a_file_holds_one_idea(path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= FILE_LINES


@pytest.mark.parametrize("path", files(CODE, ".py", ".c", ".h"), ids=relative)
def test_a_function_fits_on_a_page(path):
    lengths = python_functions(path) if path.suffix == ".py" else c_functions(path)
    too_long = {
        name: lines
        for name, lines in lengths.items()
        if lines > (STEP_LINES if name.endswith("step") else FUNCTION_LINES)
    }
    assert not too_long


def test_no_text_names_a_folder_of_one_machine():
    suffixes = (".py", ".c", ".h", ".md", ".toml", ".json", ".txt")
    texts = [*files(TEXT, *suffixes), *ROOT.glob("*.md"), *ROOT.glob("*.toml"), ROOT / "Makefile"]
    found = {
        f"{relative(path)}:{number}: {line.strip()}"
        for path in texts
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)
        if MACHINE_PATH.search(line)
    }
    assert not found


def test_nothing_is_left_to_do_in_the_code():
    marker = re.compile(r"\b(?:TODO|FIXME|XXX)\b")
    texts = [
        path for path in files(CODE, ".py", ".c", ".h") if marker.search(path.read_text("utf-8"))
    ]
    assert not texts
