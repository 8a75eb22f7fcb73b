"""Runs the cases of an attack in processes of their own, so that a crash or a hang is a finding.

An attack is a module of this folder with

    prepare(folder)              make once what its cases need, such as an FMU
    case(seed, number, folder)   run one case; None, or what it found in one line

and, where a case may take longer, ``CPU_LIMIT`` in seconds, and ``NEEDS``, packages and programs
that not every machine has. It uses public interfaces alone.
"""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from shutil import which
from types import ModuleType

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
CHUNK = 250
"""Cases of one process."""


@dataclass(frozen=True)
class Finding:
    """A case that ended otherwise than in an answer or a sentence."""

    number: int
    text: str


def attacks() -> list[str]:
    """Names of the attacks: modules of this folder that have cases."""
    others = ("__main__", "attack", "process")
    return sorted(path.stem for path in HERE.glob("*.py") if path.stem not in others)


def module_of(attack: str) -> ModuleType:
    """Import an attack."""
    return import_module(f"tests.hostile.{attack}")


def lacking(attack: str) -> str:
    """Packages and programs that an attack needs and this machine lacks; empty if it has all."""
    try:
        needs = getattr(module_of(attack), "NEEDS", ())
    except ModuleNotFoundError as error:
        return str(error.name)
    return ", ".join(x for x in needs if find_spec(x) is None and which(x) is None)


def run(attack: str, seed: str, count: int, folder: Path, patience: float = 1.0) -> list[Finding]:
    """Run the cases 0 to `count` of an attack and return what they found.

    `patience` multiplies the time that a case may take.
    """
    module_of(attack).prepare(folder)
    findings, first = [], 0
    while first < count:
        last = min(first + CHUNK, count)
        ended, more = _run_chunk(attack, seed, range(first, last), folder, patience)
        findings += more
        first = ended
    return findings


def _run_chunk(
    attack: str, seed: str, numbers: range, folder: Path, patience: float
) -> tuple[int, list[Finding]]:
    """Run cases in a process; return the number of the next case and the findings."""
    words = (attack, seed, str(numbers.start), str(numbers.stop), str(folder), str(patience))
    command = [sys.executable, "-m", "tests.hostile.process", *words]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace")
    lines = [json.loads(line[2:]) for line in run.stdout.splitlines() if line.startswith("> ")]
    findings = [Finding(number, text) for number, text in lines if text]
    if run.returncode == 0:
        return numbers.stop, findings
    begun = lines[-1][0] + 1 if lines else numbers.start
    why = [line for line in run.stderr.splitlines() if line.strip()][-8:]
    text = f"the process ended with {run.returncode}: {' | '.join(why)[-600:]}"
    return begun + 1, [*findings, Finding(begun, text)]
