"""An interpreter with other codes that fails is reported as what it is, never as an absent code.

The interpreters are programs of the shell: one that says a line and ends, one that crashes, one
that never ends.
"""

from __future__ import annotations

import sys

import pytest

from benchmarks.measuring.effort import TINY
from benchmarks.peers import exudyn_peer, peer_processes, stability_peers
from benchmarks.peers.peer_interpreter import (
    VARIABLE,
    InterpreterError,
    Packages,
    answer,
    packages_there,
)
from benchmarks.peers.peer_methods import Limits
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.stability_cases import chain
from benchmarks.sections.stability_runs import prepare

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="interpreters here are scripts")

ENDINGS = {
    "echo Traceback >&2; echo 'ImportError: libm.so.9: no such file' >&2; exit 1": "libm.so.9",
    "kill -s SEGV $$": "code -11",
    "exit 3": "code 3",
    "echo hello": "hello",
    "exit 0": "no answer",
}


@pytest.fixture(params=ENDINGS)
def said(request, tmp_path, monkeypatch):
    """What the interpreter that the variable names says last."""
    interpreter = tmp_path / "python"
    interpreter.write_text(f"#!/bin/sh\n{request.param}\n")
    interpreter.chmod(0o755)
    monkeypatch.setenv(VARIABLE, str(interpreter))
    return ENDINGS[request.param]


def fails_with(text, remarks):
    return all(text in remark and "not installed" not in remark for remark in remarks)


def test_a_failing_interpreter_is_no_absent_package(said):
    packages = packages_there(["exudyn"])
    assert not packages.versions
    assert fails_with(said, [packages.absence("exudyn")])


def test_a_failing_interpreter_is_the_remark_of_every_table(said):
    *remarks, hint = peer_processes.remarks(peer_processes.found())
    assert len(remarks) == len(peer_processes.MODULES)
    assert fails_with(said, remarks)
    assert VARIABLE in hint
    there, (*remarks, hint) = stability_peers.present()
    assert not there
    assert fails_with(said, remarks)
    found, (remark, hint) = exudyn_peer.measured([], TINY)
    assert not found
    assert fails_with(said, [remark])


def test_an_interpreter_that_fails_later_is_the_remark_of_what_it_did_not_measure(
    said, monkeypatch
):
    there = Packages({"exudyn": "1.0"})
    monkeypatch.setattr(exudyn_peer, "packages_there", lambda _: there)
    found, remarks = exudyn_peer.measured([], TINY)
    assert not found
    assert remarks[0] == "Exudyn 1.0"
    assert said in remarks[1]
    found, problem = stability_peers.scanned("MuJoCo", prepare(chain(10), 0.1), [0.1])
    assert not found
    assert said in problem
    problem, limits = PROBLEMS["bricard"](), Limits.of(TINY)
    rows = peer_processes.measured(problem, limits, [[0.0] * 3], there)
    assert rows[0]["remark"].startswith("failed: ")
    assert said in rows[0]["remark"]
    assert all(row["remark"] == "not measured: not installed" for row in rows[1:])


def test_an_interpreter_that_is_not_there_is_said_to_be(tmp_path, monkeypatch):
    monkeypatch.setenv(VARIABLE, str(tmp_path / "nowhere"))
    assert "cannot be started" in packages_there(["exudyn"]).absence("exudyn")


def test_an_interpreter_that_never_ends_is_stopped():
    with pytest.raises(InterpreterError, match=r"no end within 0\.1 s"):
        answer(["-c", "while True: pass"], patience=0.1)


def test_what_is_not_installed_is_said_to_be(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)
    packages = packages_there(["pytest", "no-such-package-as-this"])
    assert packages.versions == {"pytest": pytest.__version__}
    assert packages.absence("no-such-package-as-this") == "not installed"
    assert not packages.absence("pytest")


def test_the_last_line_is_the_answer():
    greets = "import json, sys; print('greeting'); print(json.dumps(2 * json.load(sys.stdin)))"
    assert answer(["-c", greets], [1.0]) == [1.0, 1.0]
