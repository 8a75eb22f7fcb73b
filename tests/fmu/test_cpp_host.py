"""A host in C++11: native FMUs of FMI 2 and 3, an instance in each of many threads."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import fmpy
import pytest

import solver
from build_fmu import build
from build_kernel.compiler import SLAVE_SOURCES, SOURCES, Kind, compile_library
from tests.sanitize import has_thread_sanitizer
from tests.support.fmus.fmu_instance import PENDULUM

ROOT = Path(__file__).parents[2]
HOST = ROOT / "tests" / "c_host" / "threads.cpp"
FLAGS = ("-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-pthread")

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="the host is for Linux"),
    pytest.mark.skipif(not shutil.which("g++"), reason="there is no g++"),
]


def shown(folder: Path, host: Path, fmi: int, library: Path | None = None) -> list[str]:
    """Last output of an instance alone, and of eight in threads; of another library if given."""
    scene = solver.loads(PENDULUM.format(length=1.0, mass=1.0, push="push"))
    fmu = build(scene, folder / f"{fmi}.fmu", native=True, fmi=fmi)
    fmpy.extract(str(fmu), str(folder / str(fmi)))
    description = (folder / str(fmi) / "modelDescription.xml").read_text(encoding="utf-8")
    token = re.search(r'(?:guid|instantiationToken)="(\S+)"', description)
    assert token
    of = {v.name: v.valueReference for v in fmpy.read_model_description(str(fmu)).modelVariables}
    library = library or next((folder / str(fmi)).glob("binaries/*/*.so"))
    resources = folder / str(fmi) / "resources"
    place = resources.as_uri() if fmi == 2 else f"{resources}/"
    words = (fmi, library, place, token[1], of["push"], of["A.x"], 8)
    run = subprocess.run([str(host), *map(str, words)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout.split()


def test_instances_in_threads_of_cpp_move_as_one_alone_in_fmi_2_and_3(tmp_path):
    host = tmp_path / "host"
    subprocess.run(["g++", *FLAGS, str(HOST), "-o", str(host), "-ldl"], check=True)
    of_both = [shown(tmp_path, host, fmi) for fmi in (2, 3)]
    assert len({*of_both[0], *of_both[1]}) == 1
    assert [len(values) for values in of_both] == [9, 9]


@pytest.mark.skipif(not has_thread_sanitizer(), reason="gcc has no thread sanitizer here")
def test_instances_in_threads_of_cpp_share_nothing_that_changes(tmp_path):
    """Made, moved and freed at once; the library and the host speak up where two threads race."""
    host, library, flags = tmp_path / "host", tmp_path / "planar.so", ("-O1", "-fsanitize=thread")
    subprocess.run(["g++", *FLAGS, *flags, str(HOST), "-o", str(host), "-ldl"], check=True)
    kind = Kind(2, slave=ROOT / SLAVE_SOURCES)
    compile_library(["gcc"], ROOT / SOURCES, kind, library, *flags)
    of_both = [shown(tmp_path, host, fmi, library) for fmi in (2, 3)]
    assert len({*of_both[0], *of_both[1]}) == 1
