"""A code, or a setting of it, that takes the experiments; and its answers, in its own process."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import asdict, dataclass
from importlib import import_module
from typing import Any

from benchmarks.contact_laws.experiments import DEMANDS, Impact, Rest, cases
from benchmarks.problems.parts import Array


class RefusedError(Exception):
    """A code does not take an experiment, or does not come to its end; the text says why."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Method:
    """A row of the table."""

    name: str
    settings: str
    impact: Callable[[Impact, float, float], Array]
    """Velocities after an impact with friction and restitution; raises `RefusedError`."""
    rest: Callable[[float], Rest] | None
    """The parked box under a demand; None where no time passes."""


Answers = dict[str, Any]
"""Of a method: its name and settings, `after` of all cases and `rest` by name; or texts."""


def answers(method: Method, keys: Collection[str] | None = None) -> Answers:
    """Take all experiments, or impacts of these keys alone; JSON can hold what is found."""
    after, rest = [], {}
    for case in cases():
        if keys is not None and case[0].key not in keys:
            after.append("not asked for")
            continue
        try:
            after.append([float(x) for x in method.impact(*case)])
        except RefusedError as error:
            after.append(str(error))
    if method.rest and keys is None:
        for key, demand in DEMANDS.items():
            try:
                rest[key] = asdict(method.rest(demand))
            except RefusedError as error:
                rest[key] = str(error)
    return {"name": method.name, "settings": method.settings, "after": after, "rest": rest}


def run(request: dict[str, Any]) -> list[Answers]:
    """Answers of all methods of a `module`, in an interpreter that has its code.

    `keys`, if there, names the impacts that are taken.
    """
    methods = import_module(f"benchmarks.contact_laws.{request['module']}").METHODS
    return [answers(method, request.get("keys")) for method in methods]
