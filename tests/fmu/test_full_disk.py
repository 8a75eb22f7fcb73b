"""A file that cannot be written to its end is named, whatever writes it."""

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

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


SMALL = ("--stop", "0.1")
WRITERS = [
    (1000, "x.fmu", ("build", PENDULUM, "-o", "x.fmu")),
    (1000, "x.json", ("schema", "-o", "x.json")),
    (ENOUGH, "x.html", ("report", "FMU", "--results", "run.csv", "-o", "x.html")),
    (ENOUGH, "x.csv", ("simulate", "FMU", "--step", "5e-3", "--csv", "x.csv")),
    (ENOUGH, "x.html", ("simulate", "FMU", *SMALL, "--report", "x.html")),
    (ENOUGH, "x.csv", ("sweep", "FMU", "-o", "x.csv", *GRID)),
    (ENOUGH, "x.h5", ("sweep", "FMU", "-o", "x.h5", *GRID)),
]
"""Size [bytes] at which files end, the file that is larger, and what writes it."""


@pytest.fixture
def results(tmp_path, capsys):
    """Results of a run beside what is written."""
    words = ("simulate", scene_fmu("double_pendulum"), *SMALL, "--csv", tmp_path / "run.csv")
    assert run(capsys, *words)[0] == 0


@pytest.mark.usefixtures("results")
@pytest.mark.parametrize(("size", "file", "command"), WRITERS)
def test_a_file_that_becomes_too_large_is_named_and_not_left(tmp_path, size, file, command):
    fmu = scene_fmu("double_pendulum")
    code, err = limited(tmp_path, size, *(fmu if word == "FMU" else word for word in command))
    assert code == 2
    assert err.splitlines()[-1].startswith(f"holonom: {file}: ")
    assert "Traceback" not in err
    left = {path.name for path in tmp_path.iterdir()} - {"run.csv"}
    if command[0] == "sweep" and file == "x.csv":  # it has the runs so far, and goes on
        assert left == {"x.csv", "x.csv.plan.json"}
        assert (
            len({line.count(b",") for line in (tmp_path / file).read_bytes().split(b"\n")[:-1]})
            == 1
        )
        assert (tmp_path / file).read_bytes().endswith(b"\n")
    else:
        assert not left


@pytest.mark.usefixtures("results")
@pytest.mark.parametrize(("size", "file", "command"), [w for w in WRITERS if w[2][0] != "sweep"])
def test_the_file_before_stays(tmp_path, size, file, command):
    (tmp_path / file).write_bytes(b"before")
    fmu = scene_fmu("double_pendulum")
    limited(tmp_path, size, *(fmu if word == "FMU" else word for word in command))
    assert (tmp_path / file).read_bytes() == b"before"


def test_the_results_before_stay_where_a_fresh_sweep_finds_no_room(tmp_path):
    pytest.importorskip("h5py")
    words = ("sweep", scene_fmu("double_pendulum"), "-o", "x.h5", *SMALL, "--engine", "serial")
    assert limited(tmp_path, 2**30, *words, "--grid", "mass=1")[0] == 0
    before = (tmp_path / "x.h5").read_bytes()
    assert limited(tmp_path, ENOUGH, *words, "--grid", "mass=1:2:500", "--fresh")[0] == 2
    assert (tmp_path / "x.h5").read_bytes() == before


@pytest.mark.parametrize("name", ["x.ssv", "manifest.csv"])
def test_so_is_a_small_file_on_a_disk_that_is_full_by_then(tmp_path, monkeypatch, capsys, name):
    """A limit that spares the FMU spares these as well, so that one write alone is refused."""
    replace = Path.replace

    def refused(path, target):
        if Path(target).name == name and path.name.startswith(".holonom-"):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return replace(path, target)

    monkeypatch.setattr(Path, "replace", refused)
    command = ("build", PENDULUM, "-o", tmp_path / "x.fmu")
    if name == "manifest.csv":
        command = ("variants", PENDULUM, "-o", tmp_path, "--grid", "mass=1", "--engine", "serial")
    code, _, err = run(capsys, *command)
    assert (code, err) == (2, f"holonom: {tmp_path / name}: No space left on device\n")
    assert not [path for path in tmp_path.iterdir() if path.name == name or path.suffix == ""]


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
