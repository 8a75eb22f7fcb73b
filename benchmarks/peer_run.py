"""`python -m benchmarks.peer_run`: measure a problem with the methods of another code.

Input: JSON of `module` (such as `peer_exudyn`), `problem`, `expected` (places at the end) and
`limits`. The last line of what it prints is JSON, the rows. Needs NumPy and the code alone.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module
from typing import Any

from benchmarks.peer_methods import Limits, Row, measured
from benchmarks.problems import PROBLEMS


def run(request: dict[str, Any]) -> list[Row]:
    """Rows of all methods of a module."""
    methods = import_module(f"benchmarks.{request['module']}").METHODS
    problem = PROBLEMS[request["problem"]]()
    return measured(problem, methods, Limits(**request["limits"]), request["expected"])


if __name__ == "__main__":
    rows = run(json.load(sys.stdin))
    print()
    print(json.dumps(rows))
