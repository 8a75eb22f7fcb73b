"""Counts which functions, lines and branches of the kernel run in `make test`, with gcc's gcov.

python -m tests.coverage [--folder F] [pytest's arguments]

Tests run in a copy of the repository whose libraries, Python's and those of native FMUs, count; all
processes add to the same files. What is in several libraries or sources runs where it runs in one.
Tests of sizes, instructions and compilers may fail with such libraries: their failures are shown
and do not matter here. Functions that never run make the exit code 1.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

from build_fmu.platforms import SCOPES, library_path, own_platform
from build_kernel.compiler import (
    DIMENSIONS,
    LIBRARIES,
    SLAVE_SOURCES,
    SLAVES,
    SOURCES,
    Kind,
    compile_library,
    library_name,
)

ROOT = Path(__file__).parent.parent
# Without inlined functions, whose counts would be those of others.
OPTIONS = "--coverage", "-O0", "-Dalways_inline=", "-Wno-attributes"
LEFT_OUT = ".venv*", "build", "dist", "node_modules", "__pycache__", ".*_cache", "*.so", "*.log"
LIMITED = ("--ignore=tests/fmu/test_full_disk.py",)
"""Tests in which a process may not write, and so loses counts."""
LONG = 5
"""Lines of a block that is worth its own line of the report."""


class Counts(NamedTuple):
    """Whether they ever run: functions by file, line and name, lines, branches by their place."""

    functions: dict[tuple[str, int, str], bool]
    lines: dict[tuple[str, int], bool]
    branches: dict[tuple[str, int, str, int], bool]


def copy_that_counts(folder: Path) -> Path:
    """Copy the repository below a folder and compile its libraries, whose counts go there too."""
    copy = folder / "copy"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*LEFT_OUT), symlinks=True)
    slave, own = copy / SLAVE_SOURCES, own_platform()
    libraries = {copy / LIBRARIES / library_name("Linux", d): Kind(d) for d in DIMENSIONS}
    for kind in (Kind(d, scope, slave) for d in DIMENSIONS for scope in SCOPES):
        libraries[library_path(copy / SLAVES, own, kind.dimension, kind.scope)] = kind

    def compiled(target: Path, kind: Kind) -> None:
        counts = folder / "counts" / target.stem  # beside the library, as gcc writes its notes
        for path in (counts, target.parent):
            path.mkdir(parents=True, exist_ok=True)
        compile_library(["gcc"], copy / SOURCES, kind, counts / target.name, *OPTIONS)
        shutil.move(counts / target.name, target)

    with ThreadPoolExecutor(len(DIMENSIONS)) as pool:
        list(pool.map(lambda item: compiled(*item), libraries.items()))
    return copy


def run_tests(copy: Path, arguments: list[str]) -> None:
    """Run tests of a copy; other processes that they start import from it as well."""
    paths = [str(copy), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = dict(os.environ) | {"PYTHONPATH": os.pathsep.join(paths)}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "--tb=line",
        "-m",
        "not long",
        *LIMITED,
        *arguments,
    ]
    subprocess.run(command, cwd=copy, env=environment, check=False)


def counted(folder: Path) -> Counts:
    """Read the counts in a folder of `copy_that_counts`."""
    sources = [folder / "copy" / x for x in (SOURCES, SLAVE_SOURCES)]
    functions, lines, branches = defaultdict(bool), defaultdict(bool), defaultdict(bool)
    for notes in sorted(folder.glob("counts/*/*.gcno")):
        command = ["gcov", "-b", "-j", "-t", str(notes)]
        run = subprocess.run(command, capture_output=True, check=True, cwd=notes.parent)
        found: dict[str, Any] = json.loads(run.stdout)
        for file in found["files"]:
            path = Path(found["current_working_directory"], file["file"])
            if not any(path.is_relative_to(source) for source in sources):
                continue
            name = str(path.relative_to(folder / "copy"))
            for x in file["functions"]:
                functions[name, x["start_line"], x["name"]] |= x["execution_count"] > 0
            for x in file["lines"]:
                at = name, x["line_number"]
                lines[at] |= x["count"] > 0
                for index, branch in enumerate(x["branches"]):
                    branches[(*at, x.get("function_name", ""), index)] |= branch["count"] > 0
    return Counts(functions, lines, branches)


def blocks(counts: Counts) -> list[tuple[int, str, int, int]]:
    """Length, file, first and last line of what never runs without a line between that does."""
    found: list[tuple[int, str, int, int]] = []
    length, first, before = 0, ("", 0), ("", 0)
    for (file, line), runs in [*sorted(counts.lines.items()), (("", 0), True)]:
        if length and (runs or file != before[0]):
            found.append((length, before[0], first[1], before[1]))
            length = 0
        if not runs:
            first = first if length else (file, line)
            length += 1
        before = file, line
    return sorted((x for x in found if x[0] >= LONG), reverse=True)


def table(counts: Counts) -> str:
    """What runs of each file and of all, in percent."""
    of_files: dict[str, list[list[bool]]] = defaultdict(lambda: [[], [], []])
    for kind, known in enumerate(counts):
        for at, runs in known.items():
            of_files[at[0]][kind].append(runs)
            of_files["all"][kind].append(runs)
    rows = [f"{'file':40}{'functions':>12}{'lines':>12}{'branches':>12}{'never run':>12}"]
    for name in sorted(of_files, key=lambda x: (x == "all", x)):
        row = [f"{100 * sum(x) / len(x):11.2f}%" if x else f"{'-':>12}" for x in of_files[name]]
        rows.append(f"{name:40}{''.join(row)}{of_files[name][1].count(False):6} lines")
    totals = zip(("functions", "lines", "branches"), of_files["all"], strict=True)
    rows += [f"{sum(x)} of {len(x)} {kind} run" for kind, x in totals]
    return "\n".join(rows)


def main() -> int:
    """Compile, run tests, print; 1 where a function never runs."""
    parser = argparse.ArgumentParser(prog="python -m tests.coverage", description=__doc__)
    parser.add_argument("--folder", type=Path, help="keep the copy and its counts there")
    known, arguments = parser.parse_known_args()
    if not (shutil.which("gcc") and shutil.which("gcov")):
        sys.exit("counts need gcc and gcov")
    with tempfile.TemporaryDirectory(prefix="coverage-") as name:
        folder = (known.folder or Path(name)).resolve()
        run_tests(copy_that_counts(folder), arguments)
        counts = counted(folder)
    print(table(counts))
    for length, file, first, last in blocks(counts):
        print(f"{file}:{first}-{last}: {length} lines never run")
    never = sorted(at for at, runs in counts.functions.items() if not runs)
    for file, line, name in never:
        print(f"{file}:{line}: {name} never runs")
    return 1 if never else 0


if __name__ == "__main__":
    sys.exit(main())
