"""Attacks on the public interface, briefly; `make hostile` runs them at length."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.hostile import attack, process
from tests.hostile.__main__ import main

BRIEFLY, CALLS = 40, 150
PATIENCE = 20.0
"""A crowded machine is no finding."""


@pytest.mark.parametrize("name", sorted({*attack.attacks()} - {"native", "laws"}))
def test_bad_input_ends_in_an_answer_or_a_sentence(name, tmp_path):
    count = CALLS if name == "calls" else BRIEFLY
    assert attack.run(name, "0", count, tmp_path, PATIENCE) == []


def test_an_attack_that_lacks_an_extra_is_left_out_and_the_others_are_run(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "trimesh", None)  # as if it were not installed
    assert attack.lacking("native") == "trimesh"
    assert attack.lacking("scenes") == ""
    assert main(["native", "scenes", "--count", "2"]) == 0
    out = capsys.readouterr().out.splitlines()
    assert out[0] == "native: left out, since this machine lacks trimesh"
    assert out[1].startswith("scenes: 2 cases of seed 1, ")


def test_so_is_one_that_cannot_be_imported_without_it(monkeypatch):
    def unable(_: str) -> None:
        raise ModuleNotFoundError(name="igl")

    monkeypatch.setattr(attack, "module_of", unable)
    assert attack.lacking("native") == "igl"


@pytest.fixture
def attack_of(tmp_path, monkeypatch):
    """A made-up attack of four cases, of which number 2 does as told."""

    def made(second_case: str) -> list[attack.Finding]:
        package = tmp_path / "tests" / "hostile"
        package.mkdir(parents=True)
        for name in ("attack.py", "process.py"):
            (package / name).write_text((attack.HERE / name).read_text("utf-8"), "utf-8")
        text = "import os\nCPU_LIMIT = 0.2\ndef prepare(folder): pass\n"
        text += "def case(seed, number, folder):\n    if number == 2:\n        " + second_case
        (package / "madeup.py").write_text(text, "utf-8")
        monkeypatch.setattr(attack, "ROOT", tmp_path)
        monkeypatch.setattr(attack, "module_of", lambda _: process)
        monkeypatch.setattr(process, "prepare", lambda _: None, raising=False)
        return attack.run("madeup", "0", 4, Path(tmp_path))

    return made


@pytest.mark.parametrize(
    ("second_case", "told"),
    [
        ("return 'wrong answer'", "wrong answer"),
        ("raise KeyError(1)", "KeyError: 1 at madeup.py"),
        ("os._exit(3)", "the process ended with 3"),
        ("os.kill(os.getpid(), 11)", "the process ended with -11"),
        ("while True: pass", "took longer than 0.2 s at madeup.py"),
    ],
)
def test_an_attack_tells_of_wrong_answers_tracebacks_crashes_and_hangs(
    attack_of, second_case, told
):
    (finding,) = attack_of(second_case)
    assert finding.number == 2
    assert told in finding.text
