"""An FMU that is kept between runs, and fails between them: that run is lost, the next one goes."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import pytest
from pythonfmu import FmuBuilder

SOURCE = """
import os

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real

MADE = []


class Moody(Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        MADE.append(1)
        if str(len(MADE)) in os.environ.get("UNMADE", "").split():
            raise RuntimeError("not again")
        self.p, self.y = 1.0, 0.0
        self.register_variable(
            Real("p", causality=Fmi2Causality.parameter, variability=Fmi2Variability.tunable)
        )
        self.register_variable(Real("y", causality=Fmi2Causality.output))

    def do_step(self, t, h):
        self.y = 2.0 * self.p
        return True
"""


@pytest.fixture(scope="module")
def fmu(tmp_path_factory) -> Path:
    """FMU of which some instances of a process cannot be made: numbers, from 1, in UNMADE."""
    folder = tmp_path_factory.mktemp("moody")
    (folder / "moody.py").write_text(SOURCE)
    return Path(FmuBuilder.build_FMU(folder / "moody.py", dest=folder))


def swept(fmu: Path, file: Path, unmade: str, engine: str) -> tuple[int, list[dict], str]:
    """Exit code, lines and stderr of three runs."""
    arguments = ["sweep", fmu, "--grid", "p=1,2,3", "--stop", "1", "--step", "1", "-o", file]
    command = [sys.executable, "-m", "build_fmu", *arguments, "--engine", engine]
    environment = {**os.environ, "UNMADE": unmade}
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    with file.open(newline="") as lines:
        return done.returncode, list(csv.DictReader(lines)), done.stderr


@pytest.mark.parametrize("engine", ["serial", "processes:1"])
def test_a_run_without_an_instance_is_lost_and_what_is_gone_is_not_freed_again(
    fmu, tmp_path, engine
):
    code, lines, err = swept(fmu, tmp_path / "a.csv", "2 3", engine)  # reset, and the next instance
    assert code == 3, err
    assert [line["finished"] for line in lines] == ["true", "false", "true"]
    assert lines[1]["reason"].startswith("Moody cannot be instantiated")
    assert [line["y.final"] for line in lines] == ["2.0", "NaN", "6.0"]


def test_a_last_run_may_leave_no_instance(fmu, tmp_path):
    code, lines, err = swept(fmu, tmp_path / "a.csv", "2 3 4 5", "serial")
    assert code == 3, err
    assert [line["finished"] for line in lines] == ["true", "false", "false"]


def test_an_fmu_that_cannot_be_instantiated_at_all_ends_the_sweep(fmu, tmp_path):
    code, lines, err = swept(fmu, tmp_path / "a.csv", "1 2 3", "serial")
    assert (code, lines) == (2, [])
    assert err.startswith("holonom: Moody cannot be instantiated")
