"""The libraries of native FMUs for other platforms: run in wine and qemu-user, or looked into.

`make platforms` runs this. It installs nothing: what is missing is skipped with a reason.
"""

from __future__ import annotations

import importlib.util
import itertools
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import fmpy
import pytest

import solver
from build_fmu import build
from build_fmu.package import chosen_package
from build_fmu.platforms import PLATFORMS, SCOPES, library_path
from tests.support.fmus.fmu_instance import SCENES, instance

ROOT = Path(__file__).parents[2]
SCENES_RUN = ["double_pendulum", "four_bar", "bricard", "stewart", "slider_crank_with_clearance"]
"""In the plane and in space, with ramped inputs, drivers with elementary functions and impacts."""
STEPS = 40
ARM_LIBRARIES = "/usr/aarch64-linux-gnu"
"""Where Debian's libc6-arm64-cross has the loader and libc."""
RUNNERS = {
    "linux64": [],
    "win64": ["wine"],
    "linux-arm64": ["qemu-aarch64", "-L", ARM_LIBRARIES],
}


def why_not(platform: str) -> str:
    """Say what is missing here to run a platform; empty if nothing is."""
    libraries = itertools.product((2, 3), SCOPES)
    if not all(library_path(ROOT / "fmu_src", platform, *x).is_file() for x in libraries):
        return f"no libraries for {platform}: python -m build_kernel --all"
    if importlib.util.find_spec("ziglang") is None:
        return "no compiler of hosts for other platforms: pip install ziglang"
    if platform == "linux64" and sys.platform != "linux":
        return "this is no Linux"
    runner = RUNNERS[platform][:1]
    if runner and not shutil.which(runner[0]):
        package = "wine64" if "wine" in runner else "qemu-user"
        return f"{runner[0]} is not installed: apt install {package}"
    if platform == "linux-arm64" and not Path(ARM_LIBRARIES).is_dir():
        return "no libc for ARM: apt install libc6-arm64-cross"
    return ""


@pytest.fixture(scope="module")
def hosts(tmp_path_factory) -> dict[str, Path]:
    """Host for each platform that can be run here."""
    folder, found = tmp_path_factory.mktemp("hosts"), {}
    for platform in RUNNERS:
        if why_not(platform):
            continue
        found[platform] = folder / f"host_{platform}.exe"
        command = [sys.executable, "-m", "ziglang", "cc", "-target", PLATFORMS[platform].targets[0]]
        source, include = ROOT / "tests/platforms/host.c", ROOT / "fmu_src/native"
        options = [
            "-std=c99",
            "-O1",
            "-Wall",
            f"-I{include}",
            str(source),
            "-o",
            str(found[platform]),
        ]
        libraries = [] if platform == "win64" else ["-ldl"]
        subprocess.run([*command, *options, *libraries], check=True)
    return found


def bits_on(platform: str, host: Path, scene: str, folder: Path) -> list[list[str]]:
    """Bits of all outputs after each step."""
    fmu = build(SCENES / f"{scene}.toml", folder / f"{scene}.fmu", native=True, platforms=platform)
    description = fmpy.read_model_description(str(fmu))
    fmpy.extract(str(fmu), str(folder / "unpacked"))
    library = next((folder / "unpacked").glob(f"binaries/*/*{PLATFORMS[platform].suffix}"))
    resources = (folder / "unpacked" / "resources").as_uri()
    path = str(library)
    if platform == "win64":  # wine shows the root of the system as Z:
        path, resources = f"Z:{path}", resources.replace("file://", "file:///Z:")
    variables = description.modelVariables
    of = {
        kind: [str(v.valueReference) for v in variables if v.causality == kind and v.type == "Real"]
        for kind in ("input", "output")
    }
    h = repr(solver.load(SCENES / f"{scene}.toml").experiment.step_size)
    arguments = [path, resources, description.guid, str(STEPS), h, str(len(of["input"]))]
    command = [*RUNNERS[platform], str(host), *arguments, *of["input"], *of["output"]]
    quiet = os.environ | {"WINEDEBUG": "-all"}
    run = subprocess.run(command, env=quiet, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [line.split() for line in run.stdout.splitlines()]


def bits_here(scene: str) -> list[list[str]]:
    """Bits of all outputs after each step, in the FMU with Python."""
    from tests.support.fmus.fmu_instance import scene_fmu

    h = solver.load(SCENES / f"{scene}.toml").experiment.step_size
    with instance(scene_fmu(scene)) as fmu:
        fmu.initialise()
        names = [v.name for v in fmu.description.modelVariables if v.causality == "input"]
        rows = []
        for k in range(STEPS):
            fmu.set(**{name: k / 1024.0 for name in names})
            assert fmu.step(k * h, h)
            rows.append([struct.pack(">d", x).hex() for x in fmu.outputs()])
        return rows


@pytest.mark.parametrize("scene", SCENES_RUN)
@pytest.mark.parametrize("platform", RUNNERS)
def test_every_platform_gives_the_bits_of_this_one(platform, scene, hosts, tmp_path):
    if reason := why_not(platform):
        pytest.skip(reason)
    assert bits_on(platform, hosts[platform], scene, tmp_path) == bits_here(scene)


# -------------------------------------------------------------------------------------- inspection


def functions_of_the_standard() -> set[str]:
    """Names in the headers that fmpy has of both standards."""
    headers = Path(fmpy.__file__).parent / "c-code"
    return {
        name
        for version in ("fmi2", "fmi3")
        for name in re.findall(
            rf"#define ({version}\w+)\s+{version}FullName",
            (headers / f"{version}Functions.h").read_text(encoding="utf-8"),
        )
    } - MODEL_EXCHANGE


MODEL_EXCHANGE = {
    f"fmi2{name}"
    for name in (
        "EnterEventMode", "NewDiscreteStates", "EnterContinuousTimeMode", "CompletedIntegratorStep",
        "SetTime", "SetContinuousStates", "GetDerivatives", "GetEventIndicators",
        "GetContinuousStates", "GetNominalsOfContinuousStates",
    )
}  # fmt: skip
"""Functions of FMI 2.0 that a unit for co-simulation does not have."""


OF_LINKERS = {"__dso_handle", "_mh_dylib_header"}
"""What zig's linker puts into every library for macOS."""


@pytest.mark.parametrize("scope", SCOPES)
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_library_shows_the_functions_of_the_standard_and_nothing_else(platform, dimension, scope):
    lief = pytest.importorskip("lief", reason="pip install lief, to look into libraries")
    path = library_path(ROOT / "fmu_src", platform, dimension, scope)
    if not path.is_file():
        pytest.skip(f"no library for {platform}: python -m build_kernel --all")
    mac = platform == "darwin64"
    # A universal file must live as long as its parts are looked at.
    whole = lief.MachO.parse(str(path)) if mac else lief.parse(str(path))
    parts = [whole.at(k) for k in range(whole.size)] if mac else [whole]
    if mac:
        assert [part.header.cpu_type for part in parts] == [
            lief.MachO.Header.CPU_TYPE.X86_64, lief.MachO.Header.CPU_TYPE.ARM64,
        ]  # fmt: skip
        for part in parts:
            assert part.build_version.minos[0] == 11
            names = [
                c.name for c in part.commands if c.command == lief.MachO.LoadCommand.TYPE.ID_DYLIB
            ]
            assert names == [f"@rpath/{path.name}"]
    for part in parts:
        shown = {f.name.removeprefix("_") for f in part.exported_functions}
        assert shown - OF_LINKERS == functions_of_the_standard()


LARGEST = {
    (2, "linux64"): 117_000, (2, "linux-arm64"): 117_000, (2, "win64"): 122_000,
    (2, "darwin64"): 223_000, (2, "all"): 442_000, (3, "all"): 535_000,
}  # fmt: skip
"""Bytes of an FMU of the double pendulum, by version of FMI and platforms.

Steps that are predicted and that check one increment took win64 from below 110 kB to 114, all
platforms from below 400 to 407; explicit steps take 6 kB of each library."""


@pytest.mark.parametrize(("fmi", "platforms"), LARGEST)
def test_an_fmu_stays_small(fmi, platforms, tmp_path):
    for name in PLATFORMS:  # where all are there, zig compiled this machine's, too
        if not library_path(ROOT / "fmu_src", name, 2, "points").is_file():
            pytest.skip(f"no library for {name}: python -m build_kernel --all")
    scene, target = SCENES / "double_pendulum.toml", tmp_path / "a.fmu"
    fmu = build(scene, target, native=True, fmi=fmi, platforms=platforms)
    assert fmu.stat().st_size <= LARGEST[fmi, platforms]


def test_a_library_for_linux_needs_no_newer_glibc_than_2_17():
    for platform in ("linux64", "linux-arm64"):
        path = library_path(ROOT / "fmu_src", platform, 2, "points")
        if why_not(platform):
            pytest.skip(why_not(platform))
        wanted = re.findall(rb"GLIBC_([0-9.]+)", path.read_bytes())
        assert max(tuple(map(int, version.split(b"."))) for version in wanted) <= (2, 17)


def test_the_folders_of_macos_in_fmi_3_have_a_library_of_their_processor_each():
    path = library_path(ROOT / "fmu_src", "darwin64", 2, "points")
    if not path.is_file():
        pytest.skip("no library for darwin64: python -m build_kernel --all")
    sizes = {"dim": 2, "unilateral": 0, "n_bodies": 0}
    entries = chosen_package(True, 3, "darwin64").entries("a", sizes)
    processors = {name.split("/")[1]: data[4:8][::-1].hex() for name, data in entries.items()}
    assert processors == {"x86_64-darwin": "01000007", "aarch64-darwin": "0100000c"}
