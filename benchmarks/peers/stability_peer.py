"""Steps that Exudyn or MuJoCo survive, as a request asks (`benchmarks.peers.peer_run`)."""

from __future__ import annotations

from dataclasses import asdict
from importlib import import_module
from typing import Any

from benchmarks.sections.stability_rules import scan

MODULES = {
    "Exudyn": "benchmarks.peers.stability_exudyn",
    "MuJoCo": "benchmarks.peers.stability_mujoco",
}


def run(request: dict[str, Any]) -> dict[str, list[tuple[float, dict[str, Any]]]]:
    """Outcomes of growing steps by method, up to the first that is lost.

    The request has `peer`, `mechanism`, `size`, the `grid` of steps [s] and the `case`: `stop` [s],
    `reference` [J], `length` [m].
    """
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
