"""Which laws of contact each code keeps: figures of small experiments, beside other codes."""

from __future__ import annotations

from benchmarks.contact_laws import by_holonom, judge, textbook
from benchmarks.contact_laws.method import Answers, answers
from benchmarks.measuring.effort import Effort
from benchmarks.pages.report import Section, Table
from benchmarks.peers.peer_interpreter import (
    VARIABLE,
    InterpreterError,
    answer,
    packages_there,
    remarks,
)
from benchmarks.peers.peer_processes import ONE

PEERS = {
    "by_mujoco": ("MuJoCo", "mujoco", VARIABLE),
    "by_exudyn": ("Exudyn", "exudyn", VARIABLE),
    "by_drake": ("Drake", "drake", VARIABLE),
    "by_siconos": ("Siconos", "siconos", "SICONOS_PYTHON"),
}
"""Module of each code; its name, that of its package, and the variable of its interpreter."""
PATIENCE = 1200.0
"""Seconds after which a code is stopped."""

LAWS = {
    "solver": "code",
    "energy": ("energy made", ".1e"),
    "cone": ("friction beyond its cone", ".1e"),
    "restitution": ("error of restitution, no friction", ".1e"),
    "elastic": ("change of energy, e = 1, no friction", ".1e"),
    "limit": ("change by friction of 1e-9", ".1e"),
    "springs": ("e = 1, one contact: against springs", ".1e"),
    "order": ("change by the order of contacts", ".1e"),
    "momentum": ("change of momentum", ".1e"),
    "answered": "impacts answered",
}
REST = {
    "solver": "code",
    "parked": ("demand 0.561: drift, m", ".1e"),
    "lift": ("across the ground, m", ".1e"),
    "changes": ("changes of contacts", ".0f"),
    "below": ("demand 0.599: drift, m", ".1e"),
    "above": ("demand 0.601: error of the way, m", ".1e"),
}
SETTINGS = {"solver": "code", "settings": "settings"}


def measure(_: Effort) -> Section:
    """Take all experiments with all codes; their size does not depend on the effort."""
    rows = [answers(method) for method in (*by_holonom.METHODS, *textbook.METHODS)]
    said = []
    for module, (code, package, variable) in PEERS.items():
        packages = packages_there([package], variable)
        said += remarks(packages, {code: package}, variable)
        if packages.absence(package):
            continue
        try:
            rows += _of_peer(module, variable)
        except InterpreterError as error:
            said.append(f"{code}: {error}")
    return Section(
        name="contact-laws",
        title="Laws of contact",
        method=METHOD,
        tables=tables(rows),
        remarks=[*_refusals(rows), *said, *REMARKS],
    )


def _of_peer(module: str, variable: str) -> list[Answers]:
    program = ["-m", "benchmarks.peers.peer_run", "benchmarks.contact_laws.method"]
    request = {"module": module}
    return answer(program, request, patience=PATIENCE, environment=ONE, variable=variable)


def tables(rows: list[Answers]) -> list[Table]:
    """Tables of what methods answered."""
    lost = {"impact": "impact", "mu": ("friction", "g"), "e": ("e", "g")}
    return [
        Table(title="Impacts: 0 where the law holds", columns=LAWS,
              rows=[judge.figures(row) for row in rows]),
        Table(title="A box at rest for 1 s: 0 where the law holds", columns=REST,
              rows=[judge.parked(row) for row in rows if row["rest"]]),
        Table(title="Energy that an impact takes, over the energy before",
              columns=lost | {row["name"]: (row["name"], ".4f") for row in rows},
              rows=judge.losses(rows)),
        Table(title="Settings", columns=SETTINGS,
              rows=[{"solver": row["name"], "settings": row["settings"]} for row in rows]),
    ]  # fmt: skip


def _refusals(rows: list[Answers]) -> list[str]:
    """What codes said that did not come to an end, once each."""
    told = []
    for row in rows:
        texts = [x for x in [*row["after"], *row["rest"].values()] if isinstance(x, str)]
        told += [f"{row['name']}, {texts.count(text)} x: {text}" for text in dict.fromkeys(texts)]
    return told


METHOD = (
    "Each code gets the same impacts of one instant, without gravity: a rod of 1 m at 0.5 rad "
    "whose slip reverses; Kane's double pendulum; a box of 0.4 x 0.3 x 0.2 m on one corner, "
    "turned, and flat on four; Newton's cradles of 3 and 7 balls that touch; restitution 0, 0.5 "
    "and 1, friction 0 to 0.5. All figures are from velocities before and after, impulses as "
    "well. *Energy made* is the largest gain over the energy before. *Friction beyond its cone* "
    "is |T|/N less the coefficient, of the impulses. *Error of restitution* is that of gap rates "
    "over the speed of the approach. *Change by friction of 1e-9* is that of the rod's gap rate "
    "and slip against no friction. *Against springs* is the energy taken, over that before, "
    "against a stiff spring with Coulomb's friction of each instant, integrated apart. The order "
    "of contacts is that in which the code is told of them. Then a box on four corners, with "
    "friction 0.6, stands for 1 s on a ground where gravity along it is 0.561, 0.599 and 0.601 of "
    "that across: the last slides by 4.905 mm."
)
REMARKS = (
    "Newton's and Poisson's law and springs are solved apart, in "
    "`benchmarks/contact_laws/textbook.py`.",
    "With friction and a restitution between 0 and 1 each law takes something else, and so does "
    "each damping of a soft contact: the third table has what.",
    "With several contacts at once even springs without damping give something else than the laws: "
    "[impact experiments](explanation/impact_experiments.md) tell why.",
)
