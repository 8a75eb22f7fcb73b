"""Microseconds per inner step: pendulum, four-bar and short chains, in the plane and in space."""

from __future__ import annotations

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import Repeated
from benchmarks.measuring.timing import Times, interleave
from benchmarks.pages.report import Goal, Section, Table, Value
from benchmarks.problems.mechanisms import Content, four_bar, hanging_chain, start, waving_chain

STEP = 1e-3
STEPS_TIMES_POINTS = 20_000
CHAINS = {10: 8.0, 100: 80.0, 1000: 700.0}
DOUBLE_PENDULUM = 2.5

COLUMNS = {
    "mechanism": "mechanism",
    "solve": ("µs per inner step", ".2f"),
    "step": ("µs per step of 1 ms", ".2f"),
    "node": ("µs per inner step and point", ".3f"),
    "newton": ("Newton iterations per inner step", ".2f"),
    "noise": ("noise", ".2f"),
    "remark": "",
}


def measure(effort: Effort) -> Section:
    cases = {
        name: Repeated(
            start(content, step_size=STEP),
            STEP,
            effort.count(max(5, STEPS_TIMES_POINTS // points), least=5),
        )
        for name, (content, points, _) in mechanisms(effort.largest).items()
    }
    able = {name: case.entry for name, case in cases.items() if not case.failure}
    times = interleave(able, effort)
    rows = [_row(name, case, times.get(name), effort) for name, case in cases.items()]
    return Section(
        name="steps",
        title="Microseconds per inner step",
        method=(
            "Internal step of 1 ms from the initial configuration (after 20 steps), settings as "
            "by default: a pair of two inner steps of 0.5 ms. Double pendulum: m = L = 1, from the "
            "horizontal. Chains: N points of 0.1 kg on rods of 0.1 m, straight along x, the first "
            "rod pinned, v_y,i = 0.5 sin(2πi/N) m/s, without gravity. Four-bar: IFToMM benchmark "
            "A02 with two loops."
        ),
        tables=[Table(title="", columns=COLUMNS, rows=rows)],
        goals=_goals(rows, effort.largest),
        remarks=[f"{name}: {x.failure}" for name, x in cases.items() if name not in able],
    )


def mechanisms(largest: int) -> dict[str, tuple[Content, int, float | None]]:
    """Content, number of moving points and goal [µs] of each mechanism, by name."""
    found: dict[str, tuple[Content, int, float | None]] = {
        "double pendulum": (hanging_chain(2), 2, DOUBLE_PENDULUM),
        "four-bar": (four_bar(), 3, None),
    }
    for dimension, word in ((2, "planar"), (3, "spatial")):
        for n, goal in CHAINS.items():
            if n <= largest:
                found[f"{word} chain N = {n}"] = (waving_chain(n, dimension), n, goal)
    return found


def _row(name: str, case: Repeated, times: Times | None, effort: Effort) -> dict[str, Value]:
    row = {"mechanism": name, **case.row(times)}
    if times is not None:
        row["step"] = 1e6 * times.minimum / case.count
        row["node"] = float(row["solve"]) / mechanisms(effort.largest)[name][1]
    return row


def _goals(rows: list[dict[str, Value]], largest: int) -> list[Goal]:
    goals = {name: goal for name, (_, _, goal) in mechanisms(largest).items() if goal is not None}
    of_goals = ((str(row["mechanism"]), row) for row in rows if row["mechanism"] in goals)
    return [Goal.of_row(f"inner step, {name}", goals[name], x, "solve") for name, x in of_goals]
