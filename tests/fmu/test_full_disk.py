"""A file that cannot be written to its end is named, whatever writes it."""

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.commands import run
from tests.fmu_instance import SCENES, scene_fmu

resource = pytest.importorskip("resource")

PENDULUM = SCENES / "double_pendulum.toml"
ENOUGH = 350_000
"""Bytes for the largest file of an unpacked FMU: what a run writes is to be too large."""
GRID = ("--grid", "mass=1:2:500", "--engine", "serial", "--stop", "0.05")
"""A line of the results of a run has some 800 bytes."""
LIMITED = """
import resource, sys
from build_fmu.command_line import main
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]),) * 2)
sys.exit(main(sys.argv[2:]))
"""


def limited(folder, size, *command):
    """Exit code and stderr of a command whose files end at a size [bytes]."""
    code = [sys.executable, "-c", LIMITED, str(size), *map(str, command)]
    process = subprocess.run(code, cwd=folder, capture_output=True, text=True, check=False)
    return process.returncode, process.stderr


@pytest.mark.parametrize(
    ("size", "file", "command"),
    [
        (1000, "x.fmu", ("build", PENDULUM, "-o", "x.fmu")),
        (ENOUGH, "x.csv", ("simulate", "FMU", "--step", "5e-3", "--csv", "x.csv")),
        (ENOUGH, "x.csv", ("sweep", "FMU", "-o", "x.csv", *GRID)),
        (ENOUGH, "x.h5", ("sweep", "FMU", "-o", "x.h5", *GRID)),
    ],
)
def test_a_file_that_becomes_too_large_is_named(tmp_path, size, file, command):
    fmu = scene_fmu("double_pendulum")
    code, err = limited(tmp_path, size, *(fmu if word == "FMU" else word for word in command))
    assert code == 2
    assert err.splitlines()[-1].startswith(f"holonom: {file}: ")
    assert "Traceback" not in err


@pytest.mark.parametrize("name", ["x.ssv", "manifest.csv"])
def test_so_is_a_small_file_on_a_disk_that_is_full_by_then(tmp_path, monkeypatch, capsys, name):
    """A limit that spares the FMU spares these as well, so that one write alone is refused."""
    write = Path.write_bytes

    def refused(path, data):
        if path.name == name:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(path, data)

    monkeypatch.setattr(Path, "write_bytes", refused)
    command = ("build", PENDULUM, "-o", tmp_path / "x.fmu")
    if name == "manifest.csv":
        command = ("variants", PENDULUM, "-o", tmp_path, "--grid", "mass=1", "--engine", "serial")
    code, _, err = run(capsys, *command)
    assert (code, err) == (2, f"holonom: {tmp_path / name}: No space left on device\n")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no such device")
@pytest.mark.parametrize("command", ["info", "simulate"])
def test_a_full_disk_behind_the_standard_output_is_said(tmp_path, command):
    with open("/dev/full", "w") as full:
        process = subprocess.run(
            [sys.executable, "-m", "build_fmu", command, PENDULUM],
            cwd=tmp_path, stdout=full, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert process.returncode == 2
    assert process.stderr == "holonom: the standard output: No space left on device\n"
