"""Which laws the answers of a code keep: figures that are 0 where a law holds."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

import numpy as np

from benchmarks.contact_laws.experiments import DEMANDS, IMPACTS, Case, Impact, cases, slid
from benchmarks.contact_laws.method import Answers
from benchmarks.contact_laws.textbook import springs
from benchmarks.pages.report import Value
from benchmarks.problems.parts import Array

Found = list[tuple[Case, Array]]
"""Cases that a code came to an end of, with the velocities after them."""

SHOWN = 5e-5
"""Of the energy: what a table of four digits shows as 0, whatever its sign."""


def found(answers: Answers) -> Found:
    """Of all cases those with an answer."""
    pairs = zip(cases(), answers["after"], strict=True)
    return [(case, np.array(after)) for case, after in pairs if not isinstance(after, str)]


def loss(impact: Impact, after: Array) -> float:
    """Energy that an impact takes [J]; negative where it makes some."""
    return impact.energy(impact.before) - impact.energy(after)


def figures(answers: Answers) -> dict[str, Value]:
    """Row of the table of laws; None where nothing was measured."""
    all_cases = found(answers)
    first = [(case, after) for case, after in all_cases if case[0].order != case[0].turned]
    return {
        "solver": answers["name"],
        "energy": max((max(0.0, -loss(c[0], v)) / c[0].energy(c[0].before) for c, v in first),
                      default=None),
        "cone": max((_beyond(c, v) for c, v in first if c[1] > 0.0), default=None),
        "restitution": max((_restitution(c, v) for c, v in first
                            if c[1] == 0.0 and c[0].tangents), default=None),
        "elastic": max((abs(loss(c[0], v)) / c[0].energy(c[0].before) for c, v in first
                        if c[1] == 0.0 and c[2] == 1.0), default=None),
        "limit": _limit(first),
        "springs": max((abs(loss(c[0], v) - loss(c[0], _sprung(c[0].key, c[1])))
                        / c[0].energy(c[0].before) for c, v in first
                        if c[2] == 1.0 and c[1] > 1e-3 and len(c[0].order) == 1), default=None),
        "order": _order(all_cases),
        "momentum": max((_momentum(c[0], v) for c, v in first if not c[0].tangents), default=None),
        "answered": f"{len(all_cases)} of {len(cases())}",
    }  # fmt: skip


@cache
def _sprung(key: str, mu: float) -> Array:
    return springs(IMPACTS[key], mu)


def _beyond(case: Case, after: Array) -> float:
    """By how much friction leaves its cone, over the normal impulse; of parallel contacts the sum.

    Impulses of redundant contacts are not unique, and their sum is.
    """
    impact, mu, _ = case
    normal, *tangents = impact.impulse(after).sum(axis=0)
    return max(0.0, float(np.linalg.norm(tangents) / normal) - mu)


def _restitution(case: Case, after: Array) -> float:
    """Error of the gap rates over the speed of the approach."""
    impact, _, e = case
    rates = [(impact.G @ v)[impact.normals] for v in (impact.before, after)]
    return float(np.max(np.abs(rates[1] + e * rates[0]))) / impact.speed


def _limit(first: Found) -> float | None:
    """By how much a friction of 1e-9 changes both rates of the rod's end, over its speed."""
    ends = {
        (mu, e): (impact, impact.G @ after)
        for (impact, mu, e), after in first
        if impact.key == "rod" and mu in (0.0, 1e-9)
    }
    changes = [
        float(np.max(np.abs(rate - ends[0.0, e][1]))) / impact.speed
        for (mu, e), (impact, rate) in ends.items()
        if mu and (0.0, e) in ends
    ]
    return max(changes, default=None)


def _order(all_cases: Found) -> float | None:
    """Largest change of a velocity where contacts are told in another order, over the speed."""
    told: dict[tuple[str, float, float], Array] = {}
    changes = []
    for (impact, mu, e), after in all_cases:
        before = told.setdefault((impact.key, mu, e), after)
        if impact.order == impact.turned:
            changes.append(float(np.max(np.abs(after - before))) / impact.speed)
    return max(changes, default=None)


def _momentum(impact: Impact, after: Array) -> float:
    """Change of the momentum of a cradle over its momentum."""
    change = impact.M @ (after - impact.before)
    return float(abs(change.sum()) / (impact.M @ impact.before).sum())


def parked(answers: Answers) -> dict[str, Value]:
    """Row of the table of rest."""
    row: dict[str, Value] = {"solver": answers["name"]}
    for key, demand in DEMANDS.items():
        rest: dict[str, Any] | str | None = answers["rest"].get(key)
        told = rest if isinstance(rest, dict) else {}
        slip = told.get("slip")
        row[key] = None if slip is None else abs(slip - slid(demand))
        if key == "parked":
            row |= {"lift": _size(told.get("lift")), "changes": told.get("changes")}
    return row


def _size(value: float | None) -> float | None:
    return None if value is None else abs(value)


def losses(rows: Iterable[Answers]) -> list[dict[str, Value]]:
    """Energy that each code takes from each impact, over the energy before."""
    table = []
    for k, (impact, mu, e) in enumerate(cases()):
        if impact.order == impact.turned:
            continue
        row: dict[str, Value] = {"impact": impact.title, "mu": mu, "e": e}
        for answers in rows:
            after = answers["after"][k]
            share = None
            if not isinstance(after, str):
                share = loss(impact, np.array(after)) / impact.energy(impact.before)
                share = 0.0 if abs(share) < SHOWN else share
            row[answers["name"]] = share
        table.append(row)
    return table
