"""Each header of the kernel compiles alone, in the plane and in space, without a cycle."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
from collections import Counter
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from build_kernel.compiler import includes

KERNEL = Path(__file__).parents[2] / "solver" / "kernel"
HEADERS = sorted(KERNEL.rglob("*.h"))
COMPILER = shlex.split(os.environ.get("CC", "cc"))


@pytest.mark.skipif(shutil.which(COMPILER[0]) is None, reason="needs a C compiler")
@pytest.mark.parametrize("dimension", [2, 3])
def test_each_header_compiles_alone(dimension):
    options = ["-std=c99", f"-DDIM={dimension}", "-fsyntax-only", "-x", "c"]
    options += ["-Werror=implicit-function-declaration"]
    command = [
        *COMPILER,
        *options,
        *includes(KERNEL),
        *map(str, HEADERS),
    ]  # each is a unit of its own
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_no_header_includes_itself_through_others():
    included = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
    graph = {header.name: included.findall(header.read_text("utf-8")) for header in HEADERS}
    list(TopologicalSorter(graph).static_order())


def test_names_of_files_occur_once_in_all_rooms():
    # A file includes another by its name alone, and an FMU with sources has all in one folder.
    names = Counter(path.name for path in KERNEL.rglob("*.[ch]"))
    assert max(names.values()) == 1, names.most_common(1)


def test_no_function_is_declared_ahead_of_a_header_that_comes_later():
    ahead = re.compile(r"^static [^={}\n]*\);$", re.MULTILINE)
    found = {header.name: ahead.findall(header.read_text("utf-8")) for header in HEADERS}
    assert not any(found.values()), found
