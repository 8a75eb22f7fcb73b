"""`python -m benchmarks.contact.run`: measure a problem with impacts by the methods of a code.

Input: JSON of `module` (such as `mujoco_soft`), `problem` and `limits`. The last line of what it
prints is JSON, the rows. Needs NumPy and the code alone.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module
from typing import Any

from benchmarks.contact.methods import Limits, Row, measured
from benchmarks.contact.problems import PROBLEMS


def run(request: dict[str, Any]) -> list[Row]:
    """Rows of all methods of a module."""
    methods = import_module(f"benchmarks.contact.{request['module']}").METHODS
    return measured(PROBLEMS[request["problem"]], methods, Limits(**request["limits"]))


if __name__ == "__main__":
    rows = run(json.load(sys.stdin))
    print()
    print(json.dumps(rows))
