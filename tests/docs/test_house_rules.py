"""What the repository promises of itself: short functions, no traces of one machine."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[2]
CODE = ("holonom", "solver", "fmu_src", "build_fmu", "build_kernel", "benchmarks", "examples")
TEXT = (*CODE, "docs", "scenes", "tests")
FUNCTION_LINES = 40
"""Of the body: without signature and docstring."""

C_SIGNATURE = re.compile(r"[A-Za-z].*?(?:NAME\((\w+)\)|(\w+))\s*\((?![^()]*\)\()")
MACHINE_PATH = re.compile(r"(?<![\w.])/(?:home|root|Users|work|tmp)/\w|[A-Z]:\\\\?Users", re.ASCII)


def files(folders: tuple[str, ...], *suffixes: str) -> list[Path]:
    """Files below folders of the repository, without what is built."""
    found = [path for folder in folders for path in sorted((ROOT / folder).rglob("*"))]
    return [path for path in found if path.suffix in suffixes and "_kernel" not in path.parts]


def python_functions(path: Path) -> dict[str, int]:
    """Lines of the body of every function of a Python file, without signature and docstring."""
    lengths = {}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            body = node.body[1:] if ast.get_docstring(node) is not None else node.body
            lines = (body[-1].end_lineno or 0) - body[0].lineno + 1 if body else 0
            lengths[f"{node.lineno}: {node.name}"] = lines
    return lengths


def c_functions(path: Path) -> dict[str, int]:
    """Lines of the body of every function of a C file; its braces stand in the first column."""
    lengths: dict[str, int] = {}
    signature = ""
    start = begin = 0
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if named := C_SIGNATURE.match(line):
            signature, start = named[1] or named[2], number
        elif line == "{":
            begin = number
        elif line == "}" and signature:
            lengths[f"{start}: {signature}"] = number - begin - 1
            signature = ""
    return lengths


def relative(path: Path) -> str:
    """Name of a file in a test's title."""
    return path.relative_to(ROOT).as_posix()


def too_long(lengths: dict[str, int]) -> dict[str, int]:
    """Functions of more lines than theirs may have."""
    return {name: lines for name, lines in lengths.items() if lines > FUNCTION_LINES}


@pytest.mark.parametrize("path", files(CODE, ".py", ".c", ".h"), ids=relative)
def test_a_function_fits_on_a_page(path):
    lengths = python_functions(path) if path.suffix == ".py" else c_functions(path)
    assert not too_long(lengths)


def test_every_function_of_the_kernel_is_measured():
    names = {
        name.rpartition(" ")[2]
        for path in files(("solver",), ".c", ".h")
        for name in c_functions(path)
    }
    assert {"holonom_advance", "hm_run_tape", "solve_step", "internal_step"} <= names


@pytest.mark.parametrize("name", ["solve_step", "advance", "other"])
def test_a_longer_function_is_found(tmp_path, name):
    python, c = tmp_path / "a.py", tmp_path / "a.c"
    python.write_text(f'def {name}(\n    x,\n):\n    """Text."""\n' + "    x += 1\n" * 41)
    c.write_text(f"static int {name}(int x,\n    int y)\n{{\n" + "    x++;\n" * 41 + "}\n")
    for lengths in (python_functions(python), c_functions(c)):
        assert list(lengths.values()) == [41]
        assert too_long(lengths)


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


def test_what_pages_and_messages_tell_to_install_is_an_extra():
    """Of `holonom[hdf5]` pip would only warn that there is no such extra, and install nothing."""
    pages = [ROOT / "README.md", *ROOT.glob("docs/*.md"), *ROOT.glob("build_fmu/**/*.py")]
    told = {
        name
        for page in pages
        for names in re.findall(r"holonom\[([\w,]+)\]", page.read_text(encoding="utf-8"))
        for name in names.split(",")
    }
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert told <= set(tomllib.loads(text)["project"]["optional-dependencies"])
    assert told >= {"hdf5", "dask", "pandas", "xarray", "pytest"}
