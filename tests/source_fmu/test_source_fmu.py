"""Sources of native FMUs: compiled by an importer or into a program, with the native FMU's bits."""

from __future__ import annotations

import functools
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import fmpy
import pytest
from fmpy.build import build_platform_binary

from build_fmu import build
from build_fmu.errors import UsageError
from build_fmu.fmu_runner import FmuRunner
from build_fmu.package import chosen_package
from build_fmu.source_package import functions
from build_kernel.compiler import system_compiler
from tests.support.fmus.commands import run as command
from tests.support.fmus.fmu_instance import SCENES, instance

HERE, NATIVE = Path(__file__).parent, Path(__file__).parents[2] / "fmu_src" / "native"
STEPS = 60
pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or not system_compiler(), reason="needs a C compiler on Linux"
)
OF_STRINGS = {"strlen", "strcmp", "strncmp", "strchr", "strcspn"}
OF_MEMORY = {"memcpy", "memmove", "memset", "memcmp"}
"""All that sources need of a C library, but for calloc and free, which HOLONOM_BLOCKS replaces."""


@functools.cache
def source_fmu(folder: Path, name: str, fmi: int = 2) -> Path:
    """FMU of a scene with a library and sources."""
    path = folder / f"{name}_{fmi}.fmu"
    return build(SCENES / f"{name}.toml", path, native=True, fmi=fmi, sources=True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    return tmp_path_factory.mktemp("sources")


def run(*command: object) -> str:
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def unpacked(path: Path) -> Path:
    return Path(fmpy.extract(str(path), str(path.with_suffix(""))))


@functools.cache
def compiled(path: Path, fmi: int, prefix: str, *flags: str) -> Path:
    """Object of the one unit of an FMU."""
    target = path.with_name(f"{path.stem}{prefix}{'_'.join(flags)}.o")
    prefixed = [f"-DFMI{fmi}_FUNCTION_PREFIX={prefix}"]
    source = unpacked(path) / "sources" / "all.c"
    run(*(system_compiler() or []), *flags, *prefixed, "-c", source, "-o", target)
    return target


def functions_of(fmi: int) -> set[str]:
    return {*functions((NATIVE / f"fmi{fmi}.h").read_text(encoding="utf-8"))}


def symbols(path: Path, kinds: str, *options: str) -> set[str]:
    lines = (line.split() for line in run("nm", *options, path).splitlines())
    return {words[-1] for words in lines if words[-2] in kinds}


def driven(name: str, folder: Path, fmi: int, h: float) -> tuple[list[str], list[float]]:
    """Arguments of the host for an FMU, and what the library of FMI 2 gives in the host's run."""
    with instance(source_fmu(folder, name)) as fmu:
        named = fmu.description.modelVariables
        outputs = [v.name for v in named if v.causality == "output" and v.type == "Real"]
        inputs = [v.name for v in named if v.causality == "input"][:1]
        fmu.initialise()
        found: list[float] = []
        for k in range(STEPS):
            fmu.set(**dict.fromkeys(inputs, 0.25 * (k % 4)))
            assert fmu.step(k * h, h)
            found += fmu.fmu.getReal([fmu.references[name] for name in outputs])
    described = fmpy.read_model_description(str(source_fmu(folder, name, fmi)))
    references = {v.name: v.valueReference for v in described.modelVariables}
    first = [references[name] for name in inputs] or [-1]
    used = [*first, *(references[name] for name in outputs)]
    return [described.guid, str(h), *map(str, used)], found


# ------------------------------------------------------------------------------------- compiled


@pytest.mark.skipif(not shutil.which("cmake"), reason="fmpy compiles with cmake")
@pytest.mark.parametrize(
    ("name", "fmi", "configuration"),
    [("double_wishbone", 2, "Release"), ("slider_crank_with_clearance", 3, "Debug")],
)
def test_what_fmpy_compiles_of_the_sources_has_the_bits_of_the_library(
    folder, name, fmi, configuration
):
    """In space with a driven input; contacts."""
    native = source_fmu(folder, name, fmi)
    other = native.with_name(f"compiled_{native.name}")
    unzipped = Path(fmpy.extract(str(native), str(folder / f"compiled_{name}")))
    shutil.rmtree(unzipped / "binaries")
    scratch = folder / f"cmake_{name}"
    scratch.mkdir()
    build_platform_binary(unzipped, scratch, configuration=configuration)
    (library,) = unzipped.glob("binaries/*/*.so")
    assert symbols(library, "TDBCR", "-D") == functions_of(fmi)
    needed = {name.split("@")[0] for name in symbols(library, "U", "-D")}
    assert needed <= OF_STRINGS | OF_MEMORY | {"calloc", "free", "__stack_chk_fail"}
    with zipfile.ZipFile(other, "w") as archive:
        for file in unzipped.rglob("*"):
            archive.write(file, file.relative_to(unzipped))
    runs = []
    for path in (native, other):
        fmu = FmuRunner(path)
        described = fmpy.read_model_description(str(path))
        h = described.defaultExperiment.stepSize
        real = (v for v in described.modelVariables if v.type in ("Real", "Float64"))
        names = [v.name for v in real if v.causality != "independent"]
        times = [k * float(h) for k in range(STEPS)]
        inputs = [v.name for v in described.modelVariables if v.causality == "input"]
        values = {n: [0.01 * (k % 4) for k in range(STEPS)] for n in inputs}
        runs.append(fmu.run({}, times, names, values))
        fmu.close()
    assert [record.reason for record in runs] == ["", ""]
    assert runs[0].values.tobytes() == runs[1].values.tobytes()


@pytest.mark.parametrize("fmi", [2, 3])
def test_two_fmus_in_one_static_program_without_malloc_have_the_bits_of_a_library(folder, fmi):
    """One driven, not optimised; one with contacts, optimised for a processor that may fuse.

    What is optimised, the kernel, is the same in FMI 3.
    """
    names, block = ("four_bar", "pendulum_with_stop"), "-DHOLONOM_BLOCKS=1"
    optimised = ["-O2", "-std=gnu11", "-march=native"] if fmi == 2 else ["-O0", "-std=gnu11"]
    planar, contact = (source_fmu(folder, name, fmi) for name in names)
    objects = [
        compiled(planar, fmi, "a_", "-O0", block),
        compiled(contact, fmi, "b_", *optimised, block),
    ]
    for prefix, unit in zip(("a_", "b_"), objects, strict=True):
        assert symbols(unit, "TDBCR") == {prefix + name for name in functions_of(fmi)}
        assert symbols(unit, "U") <= OF_STRINGS | OF_MEMORY
    host = folder / f"host_{fmi}"
    flags = [
        f"-DFMI={fmi}",
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
        f"-I{NATIVE}",
        "-static",
    ]
    run(*(system_compiler() or []), *flags, HERE / "host.c", *objects, "-o", host)
    (first, a), (second, b) = (driven(name, folder, fmi, 0.05) for name in names)
    shown = [*map(float, run(host, STEPS, *first, "-", *second).split())]
    each = len(a) // STEPS, len(b) // STEPS
    expected = []
    for k in range(STEPS):
        for values, count in zip((a, b), each, strict=True):
            expected += values[k * count : (k + 1) * count]
    assert shown == expected


def test_a_function_that_nothing_declares_is_an_error_in_the_unit(folder):
    """It would take and return integers; importers may compile with no option."""
    source, sources = folder / "unheard_of.c", unpacked(source_fmu(folder, "four_bar")) / "sources"
    source.write_text('#include "all.c"\nint own(int x) { return x + unheard_of(x); }\n')
    command = [*(system_compiler() or []), "-fsyntax-only", f"-I{sources}", str(source)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    errors = re.findall(r"error: .*", done.stderr)
    assert len(errors) == 1
    assert "unheard_of" in errors[0]


@pytest.mark.parametrize("flags", ["-O0", "-O2 -ffp-contract=off"])
def test_own_functions_are_those_of_libm(folder, flags):
    program = folder / "own_math"
    command = [*(system_compiler() or []), *flags.split(), f"-I{NATIVE}"]
    run(*command, HERE / "own_math.c", "-o", program, "-lm")
    found = [line.split() for line in run(program).splitlines()]
    assert len(found) == 10
    assert {name: int(n) for name, n in found} == {name: 0 for name, _ in found}


# ------------------------------------------------------------------------------------- packaged


def test_both_descriptions_name_the_one_unit(folder):
    for fmi in (2, 3):
        path = source_fmu(folder, "four_bar", fmi)
        described = fmpy.read_model_description(str(path))
        (files,) = described.buildConfigurations[0].sourceFileSets
        assert files.sourceFiles == ["all.c"]
        with zipfile.ZipFile(path) as archive:
            assert "sources/buildDescription.xml" in archive.namelist()


def test_sources_may_be_all_that_is_in_it(folder, capsys):
    path = folder / "alone.fmu"
    options = ["--native", "--sources", "--platforms", "none"]
    code, _, _ = command(capsys, "build", SCENES / "four_bar.toml", "-o", path, *options)
    assert code == 0
    with zipfile.ZipFile(path) as archive:
        assert not [name for name in archive.namelist() if name.startswith("binaries/")]
    assert "FMI 2.0, native, sources in C" in command(capsys, "info", path)[1]
    code, _, error = command(capsys, "check", path)
    assert code == 4
    assert "compile its sources: fmpy compile" in error


def test_sources_without_native_are_refused():
    with pytest.raises(UsageError, match=r"sources: for native FMUs alone.*add --native"):
        chosen_package(sources=True)


def test_no_platform_and_no_sources_are_refused():
    with pytest.raises(UsageError, match=r"platform 'none': .*or none of an FMU with --sources"):
        chosen_package(native=True, platforms="none")
