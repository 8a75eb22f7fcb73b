"""`python -m benchmarks.stability_peer`: steps that Exudyn or MuJoCo survive.

Input: JSON of `peer`, `mechanism`, `size`, the `grid` of steps [s] and the `case`: `stop` [s],
`reference` [J], `length` [m]. The last line of what it prints is JSON: for each method the steps
that were tried, from the smallest, with their outcomes. Needs the peer and NumPy alone.
"""

from __future__ import annotations

import json
import sys
from dataclasses import asdict
from importlib import import_module
from typing import Any

from benchmarks.stability_rules import scan

MODULES = {
    "Exudyn": "benchmarks.stability_exudyn",
    "MuJoCo": "benchmarks.stability_mujoco",
}


def run(request: dict[str, Any]) -> dict[str, list[tuple[float, dict[str, Any]]]]:
    """Outcomes of growing steps by method, up to the first that is lost."""
    module: Any = import_module(MODULES[request["peer"]])
    mechanism = request["mechanism"], request["size"]
    return {
        method: [
            (h, asdict(outcome))
            for h, outcome in scan(
                request["grid"],
                lambda h, m=method: module.run(*mechanism, m, h, request["case"]),
            )
        ]
        for method in module.METHODS
    }


if __name__ == "__main__":
    results = run(json.load(sys.stdin))
    print()
    print(json.dumps(results))
