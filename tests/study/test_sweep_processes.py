"""Sweeps and their processes: nothing is left behind, whoever dies or is interrupted."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

import build_fmu
from build_fmu.errors import UsageError
from build_fmu.study import stores
from build_fmu.study import sweep as sweep_module
from build_fmu.study.csv_tables import cell
from build_fmu.study.processes import DIED
from tests.support.fmus.crashing_runs import FATAL, crashing
from tests.support.fmus.fmu_instance import pendulum
from tests.support.hanging import HANGS, wait_until

pytestmark = pytest.mark.usefixtures("interruptible")


@pytest.fixture
def temporary(monkeypatch, tmp_path) -> Path:
    """Folder for temporary files of this process and those that it starts."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", None)
    return folder


@pytest.mark.parametrize("engine", ["serial", "processes:2"])
def test_no_folder_is_left(temporary, engine):
    found = build_fmu.sweep(pendulum(), grid=["mass=1:2:8"], outputs=["A.x"], engine=engine)
    assert found["finished"].all()
    assert list(temporary.iterdir()) == []


def test_a_run_that_ends_its_process_is_the_only_one_lost(temporary, monkeypatch):
    arguments = {"grid": ["mass=1:2:20"], "outputs": ["A.x"]}
    whole = build_fmu.sweep(pendulum(), engine="serial", **arguments)
    monkeypatch.setattr(sweep_module, "run_row", crashing)
    found = build_fmu.sweep(pendulum(), engine="processes:2", **arguments)
    lost = found[FATAL - 1]
    assert (lost["finished"], lost["reason"], lost["end_time"]) == (False, DIED, 0.0)
    assert np.isnan(lost["A.x.final"])
    assert np.delete(found, FATAL - 1).tolist() == np.delete(whole, FATAL - 1).tolist()
    assert list(temporary.iterdir()) == []


# ------------------------------------------------------------------------------ the first process


def begin(file: Path, engine: str) -> subprocess.Popen:
    """Begin a long sweep, and return when some of its runs are in the file."""
    arguments = ["sweep", pendulum(), "--grid", "mass=1:2:100000", "--output", "A.x"]
    command = [sys.executable, "-m", "build_fmu", *arguments, "--engine", engine, "-o", file]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )

    def some_runs_are_there() -> bool:
        assert process.poll() is None, process.communicate()
        return file.is_file() and len(file.read_text().splitlines()) >= 20

    wait_until(some_runs_are_there)
    return process


@pytest.mark.skipif(os.name == "nt", reason="Ctrl-C goes to all processes of a console")
@pytest.mark.parametrize(
    ("engine", "whom"),
    [("serial", os.kill), ("processes:2", os.kill), ("processes:2", os.killpg)],
    ids=["the only process", "the first process", "all"],
)
def test_an_interruption_leaves_the_runs_that_are_done_and_nothing_else(
    temporary, tmp_path, engine, whom
):
    file = tmp_path / "a.csv"
    process = begin(file, engine)
    whom(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=HANGS)
    text = file.read_text()
    assert (process.returncode, out) == (130, "")
    done = len(text.splitlines()) - 1
    assert said(err) == [
        f"holonom: interrupted; {done} of 100000 runs are in {file}, the same command goes on"
    ]
    assert ",false," not in text  # an interruption is no failure of a run
    assert list(temporary.iterdir()) == []


def test_a_run_that_an_interruption_strikes_while_it_is_written_is_in_the_file(
    monkeypatch, tmp_path
):
    monkeypatch.setattr(stores, "cell", struck_cell)
    file = tmp_path / "a.csv"
    with pytest.raises(KeyboardInterrupt, match=f"^1 of 3 runs are in {re.escape(str(file))}, "):
        build_fmu.sweep(pendulum(), grid=["mass=1:2:3"], outputs=["A.x"], path=file)
    assert len(file.read_text().splitlines()) == 1 + 1


def struck_cell(value: object) -> str:
    """Text of a value in a file, in whose writing Ctrl-C strikes."""
    signal.raise_signal(signal.SIGINT)
    return cell(value)


def said(err: str) -> list[str]:
    """Lines on stderr, without the progress that a slow machine has time for."""
    return [line for line in err.splitlines() if not line.startswith("sweep of ")]


STRUCK = """
import os, signal, sys
from multiprocessing import popen_spawn_posix
from build_fmu.command_line import main

launch, launches = popen_spawn_posix.Popen._launch, []

def struck(self, process):
    launch(self, process)
    launches.append(process)
    if len(launches) == int(sys.argv[1]):
        os.killpg(0, signal.SIGINT)

popen_spawn_posix.Popen._launch = struck
sys.exit(main(sys.argv[2:]))
"""
"""A command that Ctrl-C strikes as soon as it has so many processes."""


@pytest.mark.skipif(os.name == "nt", reason="no groups of processes")
@pytest.mark.parametrize("processes", [1, 4])
def test_an_interruption_while_processes_start_is_one_like_any_other(
    temporary, tmp_path, processes
):
    file = tmp_path / "a.csv"
    arguments = ["sweep", pendulum(), "--grid", "mass=1:2:100000", "--output", "A.x", "-o", file]
    command = [sys.executable, "-c", STRUCK, str(processes), *arguments, "--engine", "processes:4"]
    done = subprocess.run(
        command, capture_output=True, text=True, start_new_session=True, timeout=HANGS
    )
    assert done.returncode == 130, done.stderr
    assert [line[:22] for line in said(done.stderr)] == ["holonom: interrupted; "]
    assert list(temporary.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
@pytest.mark.usefixtures("temporary")
def test_processes_of_a_sweep_that_was_killed_end_and_its_file_is_free(tmp_path):
    file = tmp_path / "a.csv"
    process = begin(file, "processes:2")
    process.kill()
    process.communicate(timeout=HANGS)
    wait_until(lambda: not is_there(process.pid))  # the group, as long as one process of it is
    with pytest.raises(UsageError, match="differs in values"):  # not: in use
        build_fmu.sweep(pendulum(), grid=["mass=1,2"], outputs=["A.x"], path=file)


def is_there(group: int) -> bool:
    """Whether a group has processes."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True
