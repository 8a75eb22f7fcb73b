"""Grids, tables and files of values: what is read is what was written, in every notation."""

from __future__ import annotations

import csv
import itertools
import json
import math
import tempfile
from fractions import Fraction
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from build_fmu.errors import UsageError
from build_fmu.study.grid import rows_of
from build_fmu.study.parameter_files import entries_of_files
from build_fmu.study.ssv import COMMON, VALUES
from build_fmu.study.values import is_number, refuse

SET = (
    f'<ssv:ParameterSet xmlns:ssv="{VALUES}" xmlns:ssc="{COMMON}" version="1.0" name="set">\n'
    "{}\n</ssv:ParameterSet>"
)
TYPES = {int: "Integer", float: "Real", bool: "Boolean", str: "String"}
NOTATIONS = ("toml", "json", "csv", "ssv")

finite = st.floats(allow_nan=False, allow_infinity=False)
numbers = st.one_of(st.integers(-(10**30), 10**30), finite)
letters = st.text(st.sampled_from("bcdäöß _.-'\"&<"), max_size=6)
texts = letters.map(lambda text: f"x{text}y")
scalars = st.one_of(numbers, st.booleans(), texts)
values = st.one_of(scalars, st.lists(numbers, max_size=3))
names = st.sampled_from(["n", "mass", "points.A.mass", "points.B.mass", "solver.step_size"])


def cell(value: object) -> str:
    """Value as people write it in a cell or behind a command."""
    return value if isinstance(value, str) else json.dumps(value)


def same(value: object) -> object:
    """What tells values apart in a grid: 1 and 1.0 are one, 1 and true are two."""
    return value if is_number(value) else repr(value)


def plain(rows) -> list[dict[str, object]]:
    return [{name: entry.value for name, entry in row.items()} for row in rows]


def read(*paths: Path) -> dict[str, object]:
    """Values of files of parameters, or all their mistakes."""
    entries = entries_of_files(paths)
    refuse(entry.wrong for entry in entries.values() if entry.wrong)
    return {name: entry.value for name, entry in entries.items()}


def lines_of(data: dict[str, object], notation: str) -> list[str]:
    """A line for each value."""
    if notation == "toml":
        return [f"{json.dumps(name)} = {json.dumps(x)}" for name, x in data.items()]
    if notation == "json":
        return [f"{json.dumps(name)}: {json.dumps(x)}" for name, x in data.items()]
    if notation == "csv":
        doubled = {name: cell(x).replace('"', '""') for name, x in data.items()}
        return [f'{name},"{text}"' for name, text in doubled.items()]
    return [
        f'<ssv:Parameter name="{name}"><ssv:{TYPES[type(x)]} value={quoteattr(cell(x))}/>'
        "</ssv:Parameter>"
        for name, x in data.items()
    ]


def written(folder: Path | str, lines: list[str], notation: str) -> Path:
    """File of such lines, of which the first is line 2."""
    between = ",\n" if notation == "json" else "\n"
    frame = {"toml": "\n{}\n", "json": "{{\n{}}}", "csv": "name,value\n{}\n", "ssv": SET}
    path = Path(folder, f"a.{notation}")
    path.write_text(frame[notation].format(between.join(lines)), encoding="utf-8")
    return path


# ----------------------------------------------------------------------------------------- read


@given(st.lists(values, min_size=1, max_size=6, unique_by=same))
def test_a_grid_that_is_read_is_the_one_that_was_written(expected):
    by_text = [row["a"].value for row in rows_of(["a=" + ", ".join(map(cell, expected))])]
    by_name = [row["a"].value for row in rows_of({"a": expected})]
    assert repr(by_text) == repr(by_name) == repr(expected)


@given(numbers, numbers, st.integers(2, 30))
def test_a_range_is_exact_between_its_decimals_and_rounded_once(first, last, count):
    assume(first != last)
    found = [row["a"].value for row in rows_of([f"a={first}:{last}:{count}"])]
    a, b = Fraction(str(first)), Fraction(str(last))
    exact = [a + (b - a) * i / (count - 1) for i in range(count)]
    whole = isinstance(first, int) and isinstance(last, int)
    if whole and all(each.denominator == 1 for each in exact):
        assert repr(found) == repr([int(each) for each in exact])
    else:
        assert repr(found) == repr([float(first), *map(float, exact[1:-1]), float(last)])


positive = st.floats(1e-300, 1e300)


@given(positive, positive, st.integers(2, 30), st.sampled_from([1, -1]))
def test_a_range_with_log_has_fixed_quotients_and_exact_ends(first, last, count, sign):
    assume(abs(math.log(first / 2) - math.log(last / 2)) > 1e-3)
    text = f"a={sign * first!r}:{sign * last!r}:{count}:log"
    found = [sign * row["a"].value for row in rows_of([text])]
    assert (found[0], found[-1], len(found)) == (first, last, count)
    # Two powers of at most 1e300, whose exponents are rounded: 2 * 690 * 1.1e-16.
    expected = np.linspace(math.log(first), math.log(last), count)
    np.testing.assert_allclose(np.log(found), expected, rtol=0.0, atol=3e-13)
    assert sorted(found, reverse=first > last) == found


columns = st.lists(names, min_size=1, max_size=3, unique=True)


@given(st.data(), columns)
def test_a_table_of_a_file_is_that_of_python(data, head):
    row = st.tuples(*[values] * len(head)).map(lambda cells: dict(zip(head, cells, strict=True)))
    rows = data.draw(st.lists(row, min_size=1, max_size=4))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.csv")
        with path.open("w", newline="", encoding="utf-8-sig") as file:
            writer = csv.writer(file)
            writer.writerows([head, *([cell(x) for x in row.values()] for row in rows)])
        assert repr(plain(rows_of([], path))) == repr(plain(rows_of([], rows))) == repr(rows)


few = st.lists(st.integers(), min_size=1, max_size=3, unique=True)


@given(few, few, few)
def test_grids_and_a_table_multiply_and_the_last_turns_fastest(a, b, c):
    found = plain(rows_of({"b": b, "c": c}, [{"a": x} for x in a]))
    assert [tuple(row.values()) for row in found] == list(itertools.product(a, b, c))


def test_a_grid_can_be_a_text_an_array_or_one_value():
    rows = rows_of({"a": np.linspace(0.0, 1.0, 3), "b": "1:2:2", "c": 5, "d": [np.int64(4)]})
    assert plain(rows)[1] == {"a": 0.0, "b": 2, "c": 5, "d": 4}
    assert type(rows[0]["d"].value) is int
    assert plain(rows_of("a=1,2")) == [{"a": 1}, {"a": 2}]


@given(st.dictionaries(names, values, min_size=1, max_size=4), st.sampled_from(NOTATIONS))
def test_a_file_says_the_same_in_every_notation(data, notation):
    if notation == "ssv":
        data = {name: x for name, x in data.items() if not isinstance(x, list)}
    with tempfile.TemporaryDirectory() as folder:
        found = read(written(folder, lines_of(data, notation), notation))
    assert repr(found) == repr(data)


# ------------------------------------------------------------------------------------- mistakes


def mistakes_of(path: Path, of_file=read) -> dict[int, str]:
    """Mistakes by line; each is told once."""
    with pytest.raises(UsageError) as caught:
        of_file(path)
    told = [text for text in str(caught.value).splitlines() if "  = help: " not in text]
    where = [text.removeprefix(f"{path}:").partition(": error: ") for text in told]
    assert len({place for place, _, _ in where}) == len(told)
    return {int(place): message for place, _, message in where}


@given(
    st.dictionaries(names, scalars, min_size=1, max_size=5),
    st.sampled_from(NOTATIONS),
    st.sets(st.integers(0, 4), min_size=1),
)
def test_every_number_that_is_not_finite_is_told_with_its_line(data, notation, wrong):
    assume(max(wrong) < len(data))
    bad = {name: math.nan if i in wrong else x for i, (name, x) in enumerate(data.items())}
    lines = lines_of(bad, notation)
    lines = [text.replace("NaN", "nan") if notation == "toml" else text for text in lines]
    with tempfile.TemporaryDirectory() as folder:
        found = mistakes_of(written(folder, lines, notation))
    expected = {i + 2: f"{[*data][i]}: must be a finite number, got nan" for i in wrong}
    assert found == expected


WRONG_CELLS = {"": "an empty cell", "[1": "[1: Expecting", "1_0": "1_0: a number has no '_'"}


@given(st.lists(st.lists(numbers, min_size=2, max_size=2), min_size=1, max_size=5), st.data())
def test_every_wrong_cell_of_a_table_is_told_with_its_line_and_column(rows, data):
    lines = [[str(x) for x in row] for row in rows]
    expected = {}
    for at in data.draw(st.sets(st.integers(0, len(rows) - 1), min_size=1)):
        column, wrong = data.draw(st.tuples(st.integers(0, 1), st.sampled_from([*WRONG_CELLS])))
        lines[at][column] = wrong
        expected[at + 2] = f"{'ab'[column]}: {WRONG_CELLS[wrong]}"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "a.csv")
        path.write_text("a,b\n" + "".join(",".join(line) + "\n" for line in lines))
        found = mistakes_of(path, lambda path: rows_of([], path))
    assert found.keys() == expected.keys()
    assert all(found[line].startswith(words) for line, words in expected.items())


WRONG_ITEMS = ["", "1:2", "1:x:3", "[1", "1_0", "1:5:1", "1:1:3", "-1:5:3:log", "1:nan:3"]


@given(st.lists(st.integers(), min_size=1, max_size=5, unique=True), st.data())
def test_every_wrong_item_of_a_grid_is_told_with_its_column(items, data):
    texts_of_items = [*map(str, items)]
    at = data.draw(st.integers(0, len(items) - 1))
    wrong = texts_of_items[at] = data.draw(st.sampled_from(WRONG_ITEMS))
    text = "a=" + ",".join(texts_of_items)
    with pytest.raises(UsageError) as caught:
        rows_of([text])
    place, _, words = str(caught.value).partition(": error: column ")
    column = int(words.partition(":")[0]) - 1
    begin = len("a=" + ",".join([*texts_of_items[:at], ""]))
    assert place == f"--grid {text}"
    assert begin <= column <= begin + len(wrong)
    assert str(caught.value).endswith("a=1:5:9, which is 9 values from 1 to 5")
