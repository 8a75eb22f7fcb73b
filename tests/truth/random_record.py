"""Scenes and right values of random systems in a file: `python -m tests.truth.random_record`.

It needs Pinocchio, the extra `truth`; `make test` reads the file, `make long` calculates anew.
The checks that fail today are written with the number of the issue that mends them.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np

from tests.truth.random_runs import TIMES, error
from tests.truth.random_systems import Array, Scene, System, drawn, scene_of
from tests.truth.system import BEYOND_TOLERANCE, TOLERANCES

FILE = Path(__file__).with_name("random_values.json")
MARKS = Path(__file__).with_name("random_fails.json")

SHORT = (*range(12), 13, 14, 18, 19, 21, 22, 25, 26, 110)
"""Seeds of `make test`: each kind twice or more; none whose error lies close to its bound."""
REST = (161,)
"""The seed whose first link comes to rest at its stop, for which the reference has no law."""
LONG = tuple(seed for seed in range(225) if seed not in (*SHORT, *REST))
MENDED_BY = 46

Case = tuple[System, Scene, dict[str, Array]]


@cache
def calculated(seed: int) -> Case:
    """System, scene and right values of a seed, by Pinocchio."""
    from tests.truth.random_reference import body_rates, right_values

    system = drawn(seed)
    return system, scene_of(system, body_rates(system)), right_values(system, TIMES)


def recorded(seed: int) -> Case:
    """System, scene and right values of a seed, from the file."""
    found = json.loads(FILE.read_text(encoding="utf-8"))[str(seed)]
    values = {name: np.array(row) for name, row in found["right"].items()}
    return drawn(seed), found["scene"], values


def fails() -> dict[int, dict[str, int]]:
    """Checks that fail today by seed, with the issue that mends each."""
    found = json.loads(MARKS.read_text(encoding="utf-8"))
    return {int(seed): checks for seed, checks in found.items()}


def failing(case: Case) -> dict[str, int]:
    """Checks of a case that fail."""
    kept = {}
    for check in TOLERANCES:
        try:
            kept[check] = error(*case, float(check)) < BEYOND_TOLERANCE * float(check)
        except Exception as problem:
            print(f"{case[0].name} at {check}: {problem}")  # noqa: T201
            kept[check] = False
    return {check: MENDED_BY for check, holds in kept.items() if not holds}


def written(case: Case) -> str:
    """Text of a case: a line for its scene, one for each variable."""
    _, scene, right = case
    rows = [
        f"  {json.dumps(name)}: [{', '.join(f'{x + 0.0:.14g}' for x in row)}]"
        for name, row in right.items()
    ]
    return f'{{"scene": {json.dumps(scene)},\n"right": {{\n' + ",\n".join(rows) + "\n}}"


if __name__ == "__main__":
    cases = {seed: calculated(seed) for seed in sorted((*SHORT, *LONG))}
    blocks = [f'"{seed}": {written(cases[seed])}' for seed in SHORT]
    FILE.write_text("{\n" + ",\n".join(blocks) + "\n}\n", encoding="utf-8")
    marks = {seed: found for seed, case in cases.items() if (found := failing(case))}
    lines = [f'"{seed}": {json.dumps(checks)}' for seed, checks in marks.items()]
    MARKS.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
