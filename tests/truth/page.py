"""Write docs/truth.md from the corpus: `python -m tests.truth.page`."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

from tests.truth import test_cases
from tests.truth.random_record import LONG, REST, SHORT, fails
from tests.truth.random_systems import KINDS, WAYS, drawn
from tests.truth.system import BEYOND_TOLERANCE, BY_DEFAULT, TOLERANCES
from tests.truth.systems import SYSTEMS

PAGE = Path(__file__).parents[2] / "docs" / "truth.md"

THEMES: Mapping[int, str] = {
    44: "rest, starts and unusual inputs",
    45: "fewer methods",
    46: "default accuracy and tolerances",
    47: "contact laws",
}
"""What each issue mends, in the words of the page."""

INTRODUCTION = f"""# Right values from outside

Energy and constraints that close to round-off do not show that a path is right. `tests/truth/` compares runs with right
values that this project did not compute: closed forms, Kane's equations in fewest coordinates integrated by DOP853 at
1e-13, and published values. `python -m tests.truth.page` writes this page from it, and a test checks the page.

## How a system is judged

* **Errors** are the largest differences at the communication points, over the largest right value of their kind in the
  run: lengths, speeds, turns, forces, torques. Errors of angles are in rad.
* **A tolerance** of {", ".join(TOLERANCES)} may be exceeded {BEYOND_TOLERANCE:g} times,
  by the conserving method and by `fastest`.
* **Equal steps**: with half the step the error falls as the order says. Systems with impacts, friction or laws that jump
  have no such check.
* **Default**: a run without settings has an error of at most {BY_DEFAULT:g}: its tolerance is 1e-4.

What does not hold today is named with what will mend it. It is tested, too: the test fails as soon as it holds.
"""


def failing(fails: Mapping[str, int]) -> str:
    """Checks that fail today, each group with its theme."""
    groups: dict[int, list[str]] = {}
    for check, issue in fails.items():
        groups.setdefault(issue, []).append(check)
    return "; ".join(f"{', '.join(checks)}: {THEMES[i]}" for i, checks in sorted(groups.items()))


def systems() -> Iterator[str]:
    """Lines of the tables of systems, one table for each kind."""
    for kind, group in itertools.groupby(SYSTEMS, key=lambda system: system.kind):
        yield from ("", f"### {kind.capitalize()}", "")
        yield from ("| system | right values from | fails today |", "|---|---|---|")
        for system in group:
            yield f"| `{system.name}` | {system.origin} | {failing(system.fails)} |"


def cases() -> Iterator[str]:
    """Lines of the table of cases."""
    yield from ("| case | what is right | sentences that hold | mended by |", "|---|---|---|---|")
    for case in sorted({check.case for check in test_cases.CHECKS}):
        every = [check for check in test_cases.CHECKS if check.case == case]
        fails = test_cases.FAILS.get(case, {})
        mended = ", ".join(THEMES[issue] for issue in sorted(set(fails.values())))
        holds = f"{len(every) - len(fails)} of {len(every)}"
        yield f"| `{case}` | {test_cases.about(case).replace('|', chr(92) + '|')} | {holds} | {mended} |"


OF_KINDS = {
    "tree": "hinges and slides, springs and dampers",
    "fast": "high speeds at the start",
    "stiff": "stiff springs",
    "driven": "a joint that a driver moves",
    "jumps": "torques that jump in time",
    "loop": "rods that close loops",
    "gear": "two joints with a ratio",
    "rolling": "a wheel that rolls",
    "stop": "a joint that meets its stop",
}
"""What random systems of a kind have."""

RANDOM = f"""## Random systems

`tests/truth/random_systems.py` draws trees and loops of 1 to 5 rigid bodies, in the plane and in space, from the number of
a seed. Kinds take turns, and so do the ways to run them: {", ".join(WAYS)}.
Right values are those of Pinocchio's mass matrix and forces in joint coordinates, integrated by DOP853 at 1e-12; MuJoCo at
small steps agrees in a dozen of them. Each system is run at each tolerance; a run that is restarted or goes on from a saved
state also repeats its values to the bit.

`make test` has {len(SHORT)} seeds, whose right values are recorded in `random_values.json`. `make long` has {len(LONG)} more, and calculates
the recorded ones again; it needs the extra `truth`. Seed {" and ".join(map(str, REST))} is left out: its first link comes to rest at its stop, for
which the reference has no law. `python -m tests.truth.random_record` records values, and what fails, anew.
"""


def random_systems() -> Iterator[str]:
    """Lines of the table of random systems, by kind, with the seeds that fail at each tolerance."""
    found, all_seeds = fails(), sorted((*SHORT, *LONG))
    issues = {issue for checks in found.values() for issue in checks.values()}
    failing_runs = sum(map(len, found.values()))
    runs = len(all_seeds) * len(TOLERANCES)
    yield (
        f"Of {runs} runs, {failing_runs} fail today, of {len(found)} of the {len(all_seeds)} seeds; what mends them: "
        f"{', '.join(THEMES[issue] for issue in sorted(issues))}."
    )
    yield from ("", f"| kind | what it has | seeds | fail at {' | at '.join(TOLERANCES)} |")
    yield "|---|---|---|" + "---|" * len(TOLERANCES)
    for kind in KINDS:
        seeds = [seed for seed in all_seeds if drawn(seed).kind == kind]
        short = sum(seed in SHORT for seed in seeds)
        columns = [
            ", ".join(str(seed) for seed in seeds if check in found.get(seed, {}))
            for check in TOLERANCES
        ]
        cells = (kind, OF_KINDS[kind], f"{len(seeds)}, {short} in `make test`", *columns)
        yield f"| {' | '.join(cells)} |"


def written() -> str:
    """Text of the page."""
    marked = sum(bool(system.fails) for system in SYSTEMS)
    lines = [
        INTRODUCTION,
        f"## {len(SYSTEMS)} systems",
        "",
        f"Of these, {marked} have a check that fails today.",
        *systems(),
        "",
        RANDOM,
        *random_systems(),
        "",
        "## Cases",
        "",
        "Small inputs that a user could write, each with sentences that are right. The files are in `tests/truth/cases/`.",
        "",
        *cases(),
    ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(written(), encoding="utf-8")
    sys.stdout.write("docs/truth.md is written\n")
