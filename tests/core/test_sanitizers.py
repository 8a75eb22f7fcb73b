"""The kernel and native FMUs under gcc's sanitizers, briefly; `make long` does it at length."""

from __future__ import annotations

import collections
import os
import re
import subprocess

import fmpy
import pytest

from tests.hostile import native
from tests.sanitize import (
    OPTIONS,
    ROOT,
    can_sanitize,
    copy_with_sanitizers,
    run_in,
    sanitized_library,
)
from tests.support.fmus.fmu_instance import pendulum

pytestmark = pytest.mark.skipif(not can_sanitize(), reason="gcc has no sanitizers here")

SOME = 67
"""Every 67th of 960 cases, each with another of the 16 settings."""
DAMAGED = 150
"""Model files and states; 100,000 take ten minutes."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    copy = tmp_path_factory.mktemp("sanitizers")
    copy_with_sanitizers(copy, "-O0")
    return copy


def spoken(command: list[str], given: str = "") -> str:
    """What a host says that ends well, with no memory lost where that can be seen."""
    for leaks in (1, 0):
        settings = dict(os.environ) | {"ASAN_OPTIONS": f"detect_leaks={leaks}"}
        run = subprocess.run(command, input=given, env=settings, text=True, capture_output=True)
        if "LeakSanitizer has encountered a fatal error" not in run.stderr:  # no ptrace here
            break
    assert run.returncode == 0, run.stderr[-3000:]
    return run.stdout


def test_no_run_reads_or_writes_beyond_its_arrays_or_is_undefined(folder):
    run = run_in(folder, SOME)
    assert run.returncode == 0, run.stderr[-3000:]
    ran, ended = map(int, re.findall(r"\d+", run.stdout.splitlines()[-1]))
    assert ran > 10
    assert ended < ran / 2


def test_no_damaged_model_or_state_makes_a_native_fmu_speak_of_memory(folder):
    native.prepare(folder)
    numbers = "".join(f"{number}\n" for number in range(DAMAGED))
    outcomes = collections.Counter(spoken(native.host("0", folder), numbers).splitlines())
    assert outcomes.total() == DAMAGED
    assert not any(line.startswith("!") for line in outcomes)
    assert outcomes["model: refused"] < DAMAGED / 2  # others get as far as steps
    assert outcomes["state taken, moved"] > DAMAGED / 10


@pytest.fixture(scope="module")
def host(folder):
    program, sources = folder / "host", sorted(ROOT.glob("tests/c_host/*.c"))
    command = ["gcc", "-std=c99", "-O1", *OPTIONS, "-o", program, *sources, "-ldl", "-lpthread"]
    subprocess.run([*map(str, command)], check=True)
    return str(program)


@pytest.mark.parametrize(
    ("how", "more"),
    [
        ("calls", ["solver.assemble", "solver.start"]),
        ("cycles", [20]),
        ("instances", [100]),
        ("threads", [8]),
    ],
)
def test_a_host_finds_no_fault_and_no_lost_memory_in_a_native_fmu(
    folder, host, tmp_path, how, more
):
    path = pendulum(native=True)
    fmpy.extract(str(path), str(tmp_path))
    references = {
        v.name: v.valueReference for v in fmpy.read_model_description(path).modelVariables
    }
    words = (references.get(word, word) for word in ("push", "A.x", *more))
    resources = (tmp_path / "resources").as_uri()
    library = sanitized_library(folder, 2)
    assert spoken([host, how, str(library), resources, *map(str, words)])
