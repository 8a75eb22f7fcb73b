"""Odd calls of FMI 2.0, most of which pythonfmu's library answers before our code hears of them.

docs/fmu.md, section 5, lists them: where an answer changes with a newer library, so must the page.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import fmpy
import pytest

from tests.support.fmus.fmu_instance import pendulum
from tests.support.fmus.odd_calls import CALLS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="signals are those of Linux")
ROOT = Path(__file__).parents[2]
ENDS = "ends the process"
ANSWERS = {
    "model exchange": "an instance",
    "empty name": "the name of an instance must not be empty",
    "name NULL": ENDS,
    "name not UTF-8": ENDS,
    "GUID NULL": "an instance",
    "resources NULL": ENDS,
    "no such resources": ENDS,
    "resources file:/path": ENDS,
    "resources file://localhost/path": ENDS,
    "resources FILE:///path": ENDS,
    "callbacks NULL": "an instance",
    "logger NULL": ENDS,
    "text NULL": "0, 2",
    "text not UTF-8": "fatal",
    "unknown log category": "0",
    "last successful time": "nan",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("unpacked")
    fmpy.extract(str(pendulum()), str(made))
    return made


def answer(call: str, folder: Path) -> str:
    command = [sys.executable, "-m", "tests.support.fmus.odd_calls", call, str(folder)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    return run.stdout.strip() if run.returncode == 0 else ENDS


@pytest.mark.parametrize("call", CALLS)
def test_the_page_says_what_an_odd_call_does(call, folder):
    assert ANSWERS[call] in answer(call, folder)


def test_without_a_model_there_is_no_instance_and_a_sentence(tmp_path):
    fmpy.extract(str(pendulum()), str(tmp_path))
    (tmp_path / "resources" / "model.bin").unlink()
    text = answer("GUID NULL", tmp_path)
    assert text.startswith("none: ")
    assert "model.bin cannot be read: No such file" in text
