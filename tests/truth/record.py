"""Right values of the corpus in a file: `python -m tests.truth.record [NAME ...]` writes it anew.

References take seconds each, so `make test` reads their values; `make long` calculates all anew.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from tests.truth.system import System, Values
from tests.truth.systems import SYSTEMS

FILE = Path(__file__).with_name("right_values.json")


def right_now(system: System) -> Values:
    """Right values at the communication points, from their closed form or reference."""
    times = system.times()
    return {name: np.broadcast_to(x, times.shape) for name, x in system.right(times).items()}


def recorded() -> dict[str, Values]:
    """Right values by system and variable, as the file has them, in the order of the corpus."""
    found = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    return {
        system.name: {name: np.array(values) for name, values in found[system.name].items()}
        for system in SYSTEMS
        if system.name in found
    }


def different(a: Values, b: Values) -> float:
    """Largest difference over the largest value of each variable, at least over 1."""
    assert a.keys() == b.keys()
    return max(float(np.abs(a[x] - b[x]).max() / max(1.0, np.abs(a[x]).max())) for x in a)


def written(values: dict[str, Values]) -> str:
    """Text of the file: a line for each variable, 14 digits."""
    blocks = []
    for system, right in values.items():
        lines = [
            f"  {json.dumps(name)}: [{', '.join(f'{x + 0.0:.14g}' for x in row)}]"
            for name, row in right.items()
        ]
        blocks.append(f"{json.dumps(system)}: {{\n" + ",\n".join(lines) + "\n}")
    return "{\n" + ",\n".join(blocks) + "\n}\n"


RIGHT = recorded()

if __name__ == "__main__":
    named = set(sys.argv[1:])
    unknown = named - {system.name for system in SYSTEMS}
    if unknown:
        sys.exit(f"unknown system: {', '.join(sorted(unknown))}")
    values = {
        system.name: right_now(system)
        if not named or system.name in named or system.name not in RIGHT
        else RIGHT[system.name]
        for system in SYSTEMS
    }
    FILE.write_text(written(values), encoding="utf-8")
