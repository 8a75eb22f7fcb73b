"""A host in C, without Python of its own: every function, reloads, threads, two FMUs at once."""

from __future__ import annotations

import ctypes.util
import os
import re
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import fmpy
import pytest

from build_kernel.compiler import system_compiler, zig_compiler
from tests.support.fmus.fmu_instance import instance, pendulum, scene_fmu, text_fmu

SOURCES = Path(__file__).parents[1].joinpath("c_host")
H, STEPS = 0.01, 50
"""Of the threads in host.c."""
OK, DISCARD, ERROR = "0", "2", "3"
NOT_SUPPORTED = {  # by pythonfmu's library
    "fmi2GetStatus": ERROR,
    "fmi2GetIntegerStatus": DISCARD,
    "fmi2GetStringStatus": DISCARD,
    "fmi2SetRealInputDerivatives": ERROR,
    "fmi2GetRealOutputDerivatives": ERROR,
    "fmi2GetDirectionalDerivative": ERROR,
    "fmi2CancelStep": ERROR,
}


def libpython() -> str | None:
    """A shared libpython of 3.10 or newer: this interpreter's, or one of the system."""
    own = Path(str(sysconfig.get_config_var("LIBDIR")), str(sysconfig.get_config_var("INSTSONAME")))
    if sysconfig.get_config_var("Py_ENABLE_SHARED") and own.is_file():
        return str(own)
    found = (ctypes.util.find_library(f"python3.{minor}") for minor in range(10, 20))
    return next((name for name in found if name), None)


pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="the host is for Linux"),
    pytest.mark.skipif(not (system_compiler() or zig_compiler()), reason="no C compiler"),
]
with_python = pytest.mark.skipif(not libpython(), reason="no shared libpython")


class Unpacked(NamedTuple):
    """An FMU on disk, and the value references that the host is given."""

    library: str
    resources: str
    references: dict[str, int]

    def arguments(self, *names: str) -> list[str]:
        return [self.library, self.resources, *(str(self.references[name]) for name in names)]


@pytest.fixture(scope="module")
def host(tmp_path_factory) -> Path:
    program = tmp_path_factory.mktemp("host") / "host"
    compiler = system_compiler() or zig_compiler() or []
    flags = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    sources = sorted(SOURCES.glob("*.c"))
    command = [*compiler, *flags, "-o", program, *sources, "-ldl", "-lpthread"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return program


def unpacked(path: Path, folder: Path) -> Unpacked:
    fmpy.extract(str(path), str(folder))
    variables = fmpy.read_model_description(str(path)).modelVariables
    library = next(folder.glob("binaries/linux64/*.so"))
    references = {v.name: v.valueReference for v in variables}
    return Unpacked(str(library), (folder / "resources").as_uri(), references)


@pytest.fixture(scope="module")
def swinging(tmp_path_factory) -> Unpacked:
    return unpacked(pendulum(), tmp_path_factory.mktemp("pendulum"))


@pytest.fixture(scope="module")
def linked(tmp_path_factory) -> Unpacked:
    return unpacked(scene_fmu("four_bar"), tmp_path_factory.mktemp("four_bar"))


@pytest.fixture(scope="module")
def native(tmp_path_factory) -> Unpacked:
    return unpacked(pendulum(native=True), tmp_path_factory.mktemp("native"))


@pytest.fixture(scope="module")
def native_linked(tmp_path_factory) -> Unpacked:
    path = scene_fmu("four_bar", native=True)
    return unpacked(path, tmp_path_factory.mktemp("native_four_bar"))


def run_host(host: Path, *arguments: str, preload="LD_PRELOAD") -> subprocess.CompletedProcess[str]:
    """Run the host with a libpython, by the loader or by the host itself."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    environment = kept | ({preload: libpython() or ""} if preload else {})
    command = [str(host), *arguments]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def lines(host: Path, *arguments: str, preload="LD_PRELOAD") -> list[str]:
    run = run_host(host, *arguments, preload=preload)
    assert run.returncode == 0, run.stderr
    return run.stdout.splitlines()


def in_fmpy(
    path: Path, push: str, output: str, h: float, steps: int, tolerance: float | None = None
) -> list[float]:
    """Output after each step of size h, with an input of 1, 2, 3, ..., in fmpy."""
    with instance(path) as fmu:
        fmu.initialise(tolerance=tolerance)
        return list(_values(fmu, push, output, h, steps))


def _values(fmu, push: str, output: str, h: float, steps: int) -> Iterator[float]:
    for i in range(steps):
        fmu.set(**{push: 1.0 + i})
        assert fmu.step(i * h, h)
        yield fmu.get(output)


# ----------------------------------------------------------------------------------- one FMU


@with_python
def test_without_libpython_the_library_does_not_load(host, swinging):
    run = run_host(host, "run", *swinging.arguments("push", "A.x"), "3", "0.1", preload="")
    assert run.returncode == 1
    assert "undefined symbol: _Py" in run.stderr


@with_python
@pytest.mark.parametrize("preload", ["LD_PRELOAD", "HOST_PYTHON"])
def test_with_libpython_it_moves_as_in_fmpy(host, swinging, preload):
    arguments = swinging.arguments("push", "A.x")
    shown = lines(host, "run", *arguments, "20", "0.05", preload=preload)
    assert [*map(float, shown)] == in_fmpy(pendulum(), "push", "A.x", 0.05, 20)


def test_the_readme_tells_of_the_preload_in_one_line():
    readme = (SOURCES.parents[1] / "README.md").read_text(encoding="utf-8")
    assert re.search(r"preloads libpython: `LD_PRELOAD=libpython3\.\d+\.so\.1\.0 host`", readme)


@with_python
def test_every_function_is_called_and_answers_as_documented(host, swinging):
    arguments = swinging.arguments("push", "A.x", "solver.assemble", "solver.start")
    values: dict[str, str] = {}
    called = {}
    for line in lines(host, "calls", *arguments):
        what, _, value = line.rpartition(" ")
        if what.startswith("value of "):
            values[what.removeprefix("value of ")] = value
            continue
        expected = DISCARD if "beyond" in what else NOT_SUPPORTED.get(what, OK)
        assert value == expected, line
        called[what] = value
    header = SOURCES.parents[1] / "fmu_src" / "native" / "fmi2.h"
    table = header.read_text(encoding="utf-8")
    functions = set(re.findall(r"\b(fmi2(?!Get##|Set##)\w+),\s*\\?\s*\(", table))
    functions |= {f"fmi2{way}{kind}" for way in ("Get", "Set") for kind in KINDS}
    assert len(functions) == 34
    assert functions - set(called) - set(values) == {"fmi2Instantiate"}
    assert values["fmi2GetVersion"] == "2.0"
    assert (values["fmi2GetBoolean"], values["fmi2GetString"]) == ("0", "drawn")
    assert float(values["fmi2GetRealStatus"]) == 0.1


KINDS = ("Real", "Integer", "Boolean", "String")


@with_python
def test_load_run_and_unload_many_times_gives_the_same_and_holds_little_memory(host, swinging):
    shown = [
        line.split() for line in lines(host, "cycles", *swinging.arguments("push", "A.x"), "60")
    ]
    values, pages, loaded = zip(*shown, strict=True)
    assert len(set(values)) == 1
    # Its unique C++ symbols keep the library where it is (docs/fmu.md, section 5).
    assert set(loaded) == {"1"}
    # Measured: two pages a cycle, whoever unloads; ten are let pass.
    assert int(pages[-1]) - int(pages[9]) < 500


# ----------------------------------------------------------------------------- several at once


@with_python
def test_two_fmus_in_threads_move_as_each_alone(host, swinging, linked):
    expected = [
        in_fmpy(pendulum(), "push", "A.x", H, STEPS)[-1],
        in_fmpy(scene_fmu("four_bar"), "drive", "B0.x", H, STEPS)[-1],
    ]
    second = linked.arguments("drive", "B0.x")
    shown = lines(host, "threads", *swinging.arguments("push", "A.x"), "6", *second)
    assert [*map(float, shown)] == expected * 3


@with_python
def test_an_fmu_may_go_and_come_back_while_another_stays(host, swinging, linked):
    a = in_fmpy(pendulum(), "push", "A.x", H, 30)[-1]
    b = in_fmpy(scene_fmu("four_bar"), "drive", "B0.x", H, 30)[-1]
    second = linked.arguments("drive", "B0.x")
    shown = lines(host, "turns", *swinging.arguments("push", "A.x"), "30", *second)
    assert [*map(float, shown)] == [a, b, a]


# ------------------------------------------------------------------------------------- native


def alone(host: Path, *arguments: str) -> list[str]:
    """Run the host without any Python."""
    return lines(host, *arguments, preload="")


def test_a_native_fmu_needs_no_python_and_moves_as_in_fmpy(host, native):
    shown = alone(host, "run", *native.arguments("push", "A.x"), "20", "0.05")
    assert [*map(float, shown)] == in_fmpy(pendulum(), "push", "A.x", 0.05, 20)


def test_a_host_that_rounds_and_flushes_its_own_way_gets_the_same_bits(host, native):
    arguments = native.arguments("push", "A.x")
    # A step that is a power of two: the host's own times are then those of another rounding, too.
    plain, odd = (alone(host, how, *arguments, "20", "0.0625") for how in ("run", "odd"))
    assert plain == odd


def test_steps_and_derivatives_of_a_native_fmu_allocate_nothing(host, native, native_linked):
    for fmu, push, output in ((native, "push", "A.x"), (native_linked, "drive", "B0.x")):
        steps, instance_ = alone(host, "allocations", *fmu.arguments(push, output), "200")
        assert int(steps) == 0
        assert int(instance_) > 0  # the counter counts


def test_ten_thousand_native_instances_leave_nothing_behind(host, native):
    made, kept = alone(host, "instances", *native.arguments("push", "A.x"), "10000")
    assert int(made) > 20000  # the counter counts
    assert int(kept) == 0


def test_every_function_of_a_native_fmu_answers_as_documented(host, native):
    arguments = native.arguments("push", "A.x", "solver.assemble", "solver.start")
    own = NOT_SUPPORTED | {"fmi2GetStatus": DISCARD, "fmi2GetRealOutputDerivatives": OK}
    for line in alone(host, "calls", *arguments):
        what, _, value = line.rpartition(" ")
        if not what.startswith("value of "):
            assert value == (ERROR if "beyond" in what else own.get(what, OK)), line


def test_a_native_library_is_gone_after_it_was_unloaded(host, native):
    shown = [line.split() for line in alone(host, "cycles", *native.arguments("push", "A.x"), "60")]
    values, pages, loaded = zip(*shown, strict=True)
    assert len(set(values)) == 1
    assert set(loaded) == {"0"}
    assert int(pages[-1]) - int(pages[9]) < 20


def test_native_instances_in_threads_move_as_one_alone(host, native, native_linked):
    expected = [
        in_fmpy(pendulum(), "push", "A.x", H, STEPS)[-1],
        in_fmpy(scene_fmu("four_bar"), "drive", "B0.x", H, STEPS)[-1],
    ]
    second = native_linked.arguments("drive", "B0.x")
    shown = alone(host, "threads", *native.arguments("push", "A.x"), "16", *second)
    assert [*map(float, shown)] == expected * 8


# ------------------------------------------------------------- tolerances that a host passes

SWING = """
name = "{name}"
dimension = 2
gravity = [0, -9.81]
[inputs]
push = {{ start = 0.0, unit = "N" }}
[bodies]
rod = {{ position = [0.5, 0], mass = 1.0, inertia = 0.1, points = {{ end = [0.5, 0] }} }}
[points]
B = {{ position = [1.8, 0], mass = 0.5 }}
[joints]
bearing = {{ type = "revolute", bodies = ["ground", "rod"], position = [0, 0] }}
rope = {{ type = "distance", points = ["rod.end", "B"] }}
[forces]
wind = {{ type = "force", point = "B", value = ["0.05*push", 0] }}
"""
WALL = """
[contacts]
wall = {{ type = "plane", point = "B", axis = [1, 0], position = [-0.2, 0], restitution = 0.8 }}
"""
SWINGS = {
    "smooth": SWING.format(name="swing"),
    "contact": f"{SWING}{WALL}".format(name="swing_and_wall"),
}
"""No settings: the default, which follows a tolerance. In the second scene B hits a wall."""
POINT = 0.03125
"""Communication step [s], a power of two: hosts add it up in different ways, to the same sums."""
POINTS = 60
COARSER, FINER = (1e-2, 1e-3), 1e-7
"""Tolerances that are wider than the default one, and one that is tighter."""


@pytest.mark.parametrize("scene", SWINGS)
@pytest.mark.parametrize(
    "is_native", [pytest.param(False, marks=with_python), True], ids=["python", "native"]
)
def test_whatever_host_and_tolerance_if_wider_the_motion_is_that_of_the_default(
    host, tmp_path, scene, is_native
):
    path = text_fmu(SWINGS[scene], native=is_native)
    fmu, preload = unpacked(path, tmp_path), "" if is_native else "LD_PRELOAD"
    given = POINT, POINTS
    for output in ("B.x", "rope.force"):
        arguments = (*fmu.arguments("push", output), str(POINTS), str(POINT))
        default = in_fmpy(text_fmu(SWINGS[scene]), "push", output, *given)
        finer = in_fmpy(path, "push", output, *given, FINER)
        assert finer != default
        for tolerance in COARSER:
            assert in_fmpy(path, "push", output, *given, tolerance) == default
        for words in ((), *((str(tolerance),) for tolerance in (*COARSER, FINER))):
            shown = [*map(float, lines(host, "run", *arguments, *words, preload=preload))]
            assert shown == (finer if words == (str(FINER),) else default)
