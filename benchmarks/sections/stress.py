"""Numbers far from one: masses, lengths, stiffnesses, dependent rows, singular phases, fast spins.

And a thousand random mechanisms. Whatever is not kept must be refused with a sentence.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.problems.stress_scenes import (
    four_bar,
    linked_bodies,
    nearly_parallel,
    spinning,
    stiff_chain,
)
from benchmarks.sections.stress_random import mechanism
from benchmarks.sections.stress_runs import CONSTRAINT, ENERGY, Found, run

STEPS = 300
RANDOM, RANDOM_STEP, RANDOM_STEPS = 1000, 0.01, 100
PHASES = 40

COLUMNS = {
    "what": "what",
    "value": ("value", "g"),
    "h": ("h, s", ".2g"),
    "energy": ("largest energy.error", ".1e"),
    "constraint": ("largest constraint.position", ".1e"),
    "newton": ("Newton iterations", ".1f"),
    "divided": ("solves over those asked for", ".2f"),
    "outcome": "outcome",
}
COUNTS = {
    "outcome": "outcome",
    "number": ("mechanisms", ".0f"),
    "energy": ("largest energy.error", ".1e"),
}

Case = tuple[str, float, str, float]
"""What, its value, the scene, the step [s]."""


def measure(effort: Effort) -> Section:
    count = effort.count(STEPS, least=2)
    phases, number = effort.count(PHASES, least=2), effort.count(RANDOM, least=5)
    remarks, rows = [], []
    for what, value, text, h in _extremes():
        found = run(text, h, count)
        rows.append(_row(what, value, h, found))
        if found.refused:
            remarks.append(f"{what} = {value:g}: {found.refused}")
    for dimension in (2, 3):
        rows += [_phases(dimension, h, count, phases) for h in (0.1, 0.02, 0.005)]
    sentences, random = _random(number)
    lost = sum(float(row["number"] or 0) for row in random if "kept" not in str(row["outcome"]))
    wrong = sum(row["outcome"] == "wrong" for row in rows)
    return Section(
        name="stress",
        title="Numbers far from one",
        method=(
            f"Pairs of half steps with default settings, {count} of them. A run is *kept* while "
            f"`energy.error` stays below {ENERGY:.0e} and `constraint.position` below "
            f"{CONSTRAINT:.0e}; *refused*: the solver ended it with a sentence; *wrong*: neither. "
            f"The phases are {phases} starts of a parallelogram that differ by parts of a step, so "
            "that it passes its flat position at every phase; the worst of them counts. Random "
            "mechanisms have two to six rigid bodies of 0.01 to 100 kg, in the plane or in space, "
            "with joints of every kind, up to two loops, springs of up to 1e4 N/m and dampers; "
            f"{RANDOM_STEPS} steps of {RANDOM_STEP:g} s."
        ),
        tables=[
            Table(title="One number far from one", columns=COLUMNS, rows=rows),
            Table(title="Random mechanisms", columns=COUNTS, rows=random),
        ],
        goals=[
            Goal(what="share of wrong runs, one number far from one", unit="1", goal=1e-3,
                 value=wrong / len(rows)),
            Goal(what="share of random mechanisms that are not kept", unit="1", goal=1e-3,
                 value=lost / number),
        ],
        remarks=[*remarks, *sentences],
    )  # fmt: skip


def _extremes() -> Iterator[Case]:
    for ratio in (1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9):
        yield "mass ratio, bodies in a row", ratio, linked_bodies(ratio=ratio), 0.01
        yield "mass ratio, planar loop", ratio, four_bar(ratio=ratio), 0.01
        yield "mass ratio, spatial loop", ratio, four_bar(ratio=ratio, dimension=3), 0.01
    for length in (1e-6, 1e-3, 1e3, 1e6):
        rate, h = 2.0 / math.sqrt(length), 0.01 * math.sqrt(length)
        yield "length, m, bodies in a row", length, linked_bodies(length=length), h
        text = four_bar(length=length, dimension=3, rate=rate)
        yield "length, m, spatial loop", length, text, h
    for soft, stiff in ((1.0, 1e6), (1e-3, 1e6), (1e-3, 1e9), (1.0, 1e12)):
        yield "stiffness ratio", stiff / soft, stiff_chain(soft, stiff), 0.01
    for copies in (2, 5):
        text = four_bar(dimension=3, copies=copies)
        yield "copies of each hinge, spatial loop", copies, text, 0.01
    for k in range(2, 15, 2):
        apart = 10.0**-k
        yield "ends of two rods apart, m", apart, nearly_parallel(apart), 0.01
    for rate in (1e1, 1e3, 1e6, 1e9):
        yield "angular velocity, rad/s, free", rate, spinning(rate), 0.2 / rate
        yield "angular velocity, rad/s, pinned", rate, spinning(rate, pinned=True), 0.2 / rate
    for turn in (0.5, 1.0, 2.0, 10.0, 1000.0):
        yield "radians in a step", turn, spinning(100.0), turn / 100.0


def _row(what: str, value: float, h: float, found: Found) -> dict[str, Value]:
    return {
        "what": what, "value": value, "h": h, "energy": found.energy,
        "constraint": found.constraint, "newton": found.newton, "divided": found.divided,
        "outcome": found.outcome,
    }  # fmt: skip


def _phases(dimension: int, h: float, count: int, phases: int) -> dict[str, Value]:
    """The worst of all phases; a step turns the cranks by up to 6 rad/s."""
    worst, kind = Found(), "planar" if dimension == 2 else "spatial"
    for k in range(phases):
        text = four_bar(angle=0.3 + 6.0 * h * k / phases, dimension=dimension)
        found = run(text, h, max(2, min(count, round(1.0 / h))))
        worst.energy = max(worst.energy, found.energy)
        worst.constraint = max(worst.constraint, found.constraint)
        worst.newton = max(worst.newton, found.newton)
        worst.divided = max(worst.divided, found.divided)
        worst.refused = worst.refused or found.refused
    return _row(f"phases of a singular passage, {kind}", phases, h, worst)


def _random(number: int) -> tuple[list[str], list[dict[str, Value]]]:
    """Remarks on mechanisms that were not kept, and how many there are of each outcome."""
    remarks: list[str] = []
    counts: Counter[str] = Counter()
    energy: dict[str, float] = {}
    for seed in range(number):
        found = run(mechanism(seed), RANDOM_STEP, RANDOM_STEPS)
        counts[found.outcome] += 1
        energy[found.outcome] = max(energy.get(found.outcome, 0.0), found.energy)
        if "kept" not in found.outcome:
            sentence = found.refused or "no sentence"
            remarks.append(f"random mechanism {seed}, energy {found.energy:.0e}: {sentence}")
    rows: list[dict[str, Value]] = [
        {"outcome": outcome, "number": float(n), "energy": energy[outcome]}
        for outcome, n in counts.most_common()
    ]
    return remarks, rows
