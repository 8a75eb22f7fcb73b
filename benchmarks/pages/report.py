"""Results as data, as JSON and as a page of Markdown tables, goals beside what was measured."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace

Value = float | str | None
Column = str | tuple[str, str]
"""Its header, or header and format of numbers, which is .3g unless told."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Goal:
    """A number to reach; smaller is better."""

    what: str
    unit: str
    goal: float
    value: float | None
    """None where the measurement came to no end."""
    noise: float | None = None
    """Median over minimum of the repetitions."""

    @classmethod
    def of_row(cls, what: str, goal: float, row: Mapping[str, Value], column: str) -> Goal:
        """Of a time [µs] of a row, which has none where a step failed."""
        value, noise = (float(row[x]) if row.get(x) else None for x in (column, "noise"))
        return cls(what=what, unit="µs", goal=goal, value=value, noise=noise)

    @property
    def verdict(self) -> str:
        """Whether the goal was met, and by which factor."""
        if self.value is None:
            return "**missed** (no value)"
        ratio = self.value / self.goal
        return f"met ({ratio:.2f} of it)" if ratio <= 1.0 else f"**missed** ({ratio:.2f} times it)"


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """Rows of values by key of their column."""

    title: str
    columns: Mapping[str, Column]
    rows: Sequence[Mapping[str, Value]]
    picture: str | None = None
    """A file beside the page that shows these rows; `draw` of the section's module writes it."""
    on_page: bool = True
    """Whether the rows are on the page as well, not in the data alone."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Section:
    """What one benchmark found."""

    name: str
    title: str
    method: str
    tables: Sequence[Table] = ()
    goals: Sequence[Goal] = ()
    remarks: Sequence[str] = ()
    picture: str | None = None


def exponent(rows: Sequence[Mapping[str, Value]], ends: Sequence[int], column: str) -> float | None:
    """P of a column ~ n^p between rows of two sizes; None where it was not measured at both."""
    found = {row["n"]: float(row[column]) for row in rows if row["n"] in ends and row.get(column)}
    if len(found) != 2:
        return None
    (small, first), (large, last) = found.items()
    return math.log(last / first) / math.log(float(large) / float(small))


def as_json(machine: Mapping[str, Value], effort: str, sections: Sequence[Section]) -> str:
    """All that was measured, with all digits."""
    content = {"machine": dict(machine), "effort": effort, "sections": {}}
    for section in sections:
        record = asdict(section)
        for goal, written in zip(section.goals, record["goals"], strict=True):
            written["verdict"] = goal.verdict.replace("*", "")
        for written in record["tables"]:
            written["columns"] = {key: _header(x)[0] for key, x in written["columns"].items()}
        content["sections"][record.pop("name")] = record
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def as_markdown(machine: Mapping[str, Value], effort: str, sections: Sequence[Section]) -> str:
    """The page: machine, goals, sections."""
    parts = [
        "# Benchmarks",
        "Written by `make benchmark` (`python -m benchmarks`); the same numbers with all digits "
        "are in [benchmarks.json](benchmarks.json).",
    ]
    if effort != "full":
        parts.append(
            f"> **A {effort} run**: short, and not meant as a measurement. Only a full run on a "
            "machine without other work is one."
        )
    parts += [_machine(machine), METHOD]
    goals = [goal for section in sections for goal in section.goals]
    if goals:
        parts += ["## Goals", _goals(goals)]
    for section in sections:
        parts += _section(section)
    return "\n\n".join(parts) + "\n"


def merged(
    page: str, data: str, machine: Mapping[str, Value], effort: str, sections: Sequence[Section]
) -> tuple[str, str]:
    """Page and data with sections in the place of older ones, each saying when it was measured."""
    when = f"Measured on {machine['day']} on {machine['processor']}, not with the other sections."
    dated = [replace(section, method=f"{when}\n\n{section.method}") for section in sections]
    content = json.loads(data)
    content["sections"] |= json.loads(as_json(machine, effort, dated))["sections"]
    head, *parts = page.rstrip().split("\n\n## ")
    written = {part.partition("\n")[0]: part for part in parts}
    for section in dated:
        written[section.title] = "\n\n".join(_section(section)).removeprefix("## ")
    names = [part.name for part in fields(Goal)]
    goals = [
        Goal(**{name: goal[name] for name in names})
        for section in content["sections"].values()
        for goal in section["goals"]
    ]
    written["Goals"] = f"Goals\n\n{_goals(goals)}"
    text = json.dumps(content, indent=1, ensure_ascii=False) + "\n"
    return "\n\n## ".join([head, *written.values()]) + "\n", text


METHOD = (
    "One thread. Times are CPU times of the process (user and system); each is the minimum of "
    "several repetitions of the same work in one run, entries that are compared taking turns. "
    "*Noise* is the median of the repetitions over their minimum. An *inner step* is one implicit "
    "solve; a *pair* is two of them, of half the step each, and what equal steps of order 2 are "
    "made of. Where neither a row nor the section it comes from says otherwise, holonom ran by its "
    "*conserving* method, the default."
)


def _machine(machine: Mapping[str, Value]) -> str:
    return markdown_table(("machine", ""), [(key, str(value)) for key, value in machine.items()])


def _goals(goals: Sequence[Goal]) -> str:
    rows = [
        (
            goal.what,
            goal.unit,
            f"{goal.goal:g}",
            formatted(goal.value, ".3g"),
            formatted(goal.noise, ".2f"),
            goal.verdict,
        )
        for goal in goals
    ]
    return markdown_table(("what", "unit", "goal", "measured", "noise", "verdict"), rows)


def _section(section: Section) -> list[str]:
    parts = [f"## {section.title}", section.method]
    for table in section.tables:
        if table.title:
            parts.append(f"**{table.title}**")
        if table.on_page:
            parts.append(_rows(table))
        if table.picture:
            parts.append(f"![{table.title}]({table.picture})")
    if section.picture:
        parts.append(f"![{section.title}]({section.picture})")
    if section.remarks:
        parts.append("\n".join(f"* {remark}" for remark in section.remarks))
    return parts


def _rows(table: Table) -> str:
    used = {
        key: _header(column)
        for key, column in table.columns.items()
        if any(row.get(key) != "" for row in table.rows)
    }
    rows = [
        [formatted(row.get(key), form) for key, (_, form) in used.items()] for row in table.rows
    ]
    return markdown_table([header for header, _ in used.values()], rows)


def _header(column: Column) -> tuple[str, str]:
    return (column, ".3g") if isinstance(column, str) else column


def formatted(value: Value, form: str) -> str:
    """A value as text; what there is not is a dash."""
    if value is None:
        return "–"
    return value if isinstance(value, str) else format(value, form)


def markdown_table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Markdown table whose columns line up in the source too."""
    cells = [[cell.replace("|", "\\|") for cell in row] for row in (header, *rows)]
    widths = [max(3, *(len(row[i]) for row in cells)) for i in range(len(header))]
    lines = [
        "| " + " | ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)) + " |"
        for row in cells
    ]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in widths) + "|")
    return "\n".join(lines)
