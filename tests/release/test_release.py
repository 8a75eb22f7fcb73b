"""The files of `make release` in dist/: what wheels hold, and commands where no compiler is."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import fmpy
import pytest

from build_fmu.package import parts_of
from build_fmu.platforms import PLATFORMS, SCOPES, own_platform
from build_fmu.version import VERSION
from build_kernel.compiler import DIMENSIONS

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / f"dist/holonom-{VERSION}.tar.gz"
SCENE = ROOT / "scenes/four_bar.toml"
MACHINES = {
    "linux64": [b"\x7fELF\x02\x01", 18, b"\x3e\0"],
    "linux-arm64": [b"\x7fELF\x02\x01", 18, b"\xb7\0"],
    "win64": [b"MZ", None, b"\x64\x86"],
    "darwin64": [b"\xca\xfe\xba\xbe", 4, b"\0\0\0\x02"],
}
"""First bytes of a library, and where its machine is (of macOS: how many)."""
PARTS_OF_MACOS = [b"\xcf\xfa\xed\xfe\x07\0\0\x01", b"\xcf\xfa\xed\xfe\x0c\0\0\x01"]

pytestmark = pytest.mark.skipif(not SOURCES.is_file(), reason="no files in dist/: make release")


def wheel(platform: str) -> Path:
    """Wheel for a platform."""
    return ROOT / f"dist/holonom-{VERSION}-py3-none-{PLATFORMS[platform].wheel}.whl"


def assert_is_for(library: bytes, platform: str) -> None:
    magic, at, machine = MACHINES[platform]
    at = int.from_bytes(library[60:64], "little") + 4 if at is None else at
    assert library.startswith(magic)
    assert library[at : at + len(machine)] == machine
    if platform == "darwin64":
        assert [part[:8] for part in parts_of(library)] == PARTS_OF_MACOS


def environment(folder: Path, source: Path) -> Path:
    """Folder of the commands of a new environment with what is installed from a file."""
    subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
    commands = folder / ("Scripts" if os.name == "nt" else "bin")
    pip = [str(commands / "python"), "-m", "pip", "install", "--quiet", str(source)]
    subprocess.run(pip, check=True, cwd=folder)
    return commands


def run(commands: Path, where: Path, *arguments: str) -> str:
    """What a command prints; the environment's commands are all that there are."""
    alone = {"PATH": str(commands), "HOME": str(where), "COLUMNS": "100"}
    command = [str(commands / arguments[0]), *arguments[1:]]
    done = subprocess.run(
        command, cwd=where, env=alone, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


@pytest.mark.parametrize("platform", PLATFORMS)
def test_a_wheel_holds_the_libraries_of_the_machines_that_it_is_for(platform):
    with zipfile.ZipFile(wheel(platform)) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    about = files[f"holonom-{VERSION}.dist-info/WHEEL"].decode()
    assert f"\nTag: py3-none-{PLATFORMS[platform].wheel}\n" in about
    assert "\nRoot-Is-Purelib: false\n" in about
    for word in DIMENSIONS.values():
        for name, known in PLATFORMS.items():
            for scope in SCOPES:
                path = f"fmu_src/native/_libraries/{name}/{word}_{scope}{known.suffix}"
                native = files.pop(path)
                assert_is_for(native, name)
        kernel = f"solver/runtime/_kernel/libholonom_{word}{PLATFORMS[platform].suffix}"
        assert_is_for(files.pop(kernel), platform)
    assert not [name for name in files if name.endswith((".so", ".dll", ".dylib"))]
    assert {name.partition("/")[0] for name in files} == {
        *("build_fmu", "fmu_src", "holonom", "solver", "viewer", f"holonom-{VERSION}.dist-info"),
    }


@pytest.mark.parametrize("platform", [name for name in PLATFORMS if "linux" in name])
def test_libraries_for_linux_keep_to_manylinux2014(platform):
    with zipfile.ZipFile(wheel(platform)) as archive:
        libraries = [archive.read(name) for name in archive.namelist() if name.endswith(".so")]
    versions = {v for library in libraries for v in re.findall(rb"GLIBC_([0-9.]+)", library)}
    assert max(tuple(map(int, version.split(b"."))) for version in versions) <= (2, 17)


def test_the_sources_are_those_of_the_last_commit_and_hold_nothing_built():
    with tarfile.open(SOURCES) as archive:
        names = {name.partition("/")[2] for name in archive.getnames() if "." in name}
    tracked = subprocess.check_output(["git", "ls-files"], cwd=ROOT, text=True).splitlines()
    left_out = {name for name in tracked if name.startswith(".")}
    assert {*tracked} - left_out - names == set()
    assert not [name for name in names if name.endswith((".so", ".dll", ".dylib", ".pyc"))]


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    """Commands of an environment with the wheel of this machine, where no compiler is."""
    commands = environment(tmp_path_factory.mktemp("wheel") / "env", wheel(own_platform()))
    names = {path.stem for path in commands.iterdir()}
    assert not names & {"cc", "gcc", "clang", "zig", "python-zig"}
    return commands


def test_the_wheel_needs_no_compiler(installed, tmp_path):
    holonom = (installed, tmp_path, "holonom")
    assert VERSION in run(*holonom, "--version")
    run(*holonom, "build", str(SCENE))
    run(*holonom, "build", str(SCENE), "--native", "--platforms", "all", "-o", "all.fmu")
    run(
        *holonom, "build", str(SCENE), "--native", "--fmi", "3", "--platforms", "all", "-o", "3.fmu"
    )
    for name, count in (("four_bar.fmu", 2), ("all.fmu", 3), ("3.fmu", 5)):
        assert "yes" in run(*holonom, "check", name)
        assert "rows" in run(*holonom, "simulate", name, "--stop", "0.5", "--csv", "out.csv")
        description = fmpy.read_model_description(str(tmp_path / name))
        assert description.generationTool == f"holonom {VERSION}"
        assert len(fmpy.supported_platforms(str(tmp_path / name))) >= min(count, 2)
        with zipfile.ZipFile(tmp_path / name) as archive:
            libraries = [entry for entry in archive.namelist() if entry.startswith("binaries/")]
        assert len(libraries) == count
    run(installed, tmp_path, "python", "-c", "import solver, holonom; solver.load, holonom.load")


def test_the_sources_install_with_a_compiler_and_give_the_bits_of_the_wheel(installed, tmp_path):
    commands = environment(tmp_path / "env", SOURCES)
    rows = []
    for where in (installed, commands):
        run(where, tmp_path, "holonom", "simulate", str(SCENE), "--stop", "1", "--csv", "out.csv")
        rows.append((tmp_path / "out.csv").read_text())
    assert rows[0] == rows[1]
