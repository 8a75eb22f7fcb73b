"""Grids and tables of a study: what they mean, and how their mistakes are reported."""

from __future__ import annotations

import numpy as np
import pytest

from build_fmu.errors import UsageError
from build_fmu.study.grid import rows_of


def values(rows) -> list[dict[str, object]]:
    return [{name: entry.value for name, entry in row.items()} for row in rows]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a=2,3", [2, 3]),
        ("a=1:5:9", [1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0]),
        ("a=1:5:5", [1, 2, 3, 4, 5]),
        ("a=5:1:3", [5, 3, 1]),
        ("a=-1:-2:2, 7", [-1, -2, 7]),
        ("a=true,false", [True, False]),
        ("a=nested,simultaneous", ["nested", "simultaneous"]),
        ("a=[0, 1],[1, 0]", [[0, 1], [1, 0]]),
        ("a=1e-3:1e3:4:log", [1e-3, 0.1, 10.0, 1e3]),
    ],
)
def test_a_grid_is_a_list_of_values_and_ranges(text, expected):
    found = [row["a"] for row in values(rows_of([text]))]
    assert [type(value) for value in found] == [type(value) for value in expected]
    if expected and isinstance(expected[0], float):
        assert found == pytest.approx(expected, rel=1e-14)
        assert (found[0], found[-1]) == (expected[0], expected[-1])  # the ends are exact
    else:
        assert found == expected


@pytest.mark.parametrize(
    ("text", "middle"),
    [
        ("a=1e-300:1e300:3:log", 1.0),
        ("a=-1e-300:-1e300:3:log", -1.0),
        ("a=1e-200:1e-180:3:log", 1e-190),  # the product of the ends is no double
        ("a=-1e308:1e308:3", 0.0),
        ("a=1.7e308:1.6e308:3", 1.65e308),
        ("a=0.1:0.3:3", 0.2),
    ],
)
def test_a_range_between_two_doubles_has_only_doubles_between_them(text, middle):
    found = [row["a"] for row in values(rows_of([text]))]
    # Two powers of at most 1e300, whose exponents are rounded: 2 * 690 * 1.1e-16.
    assert found[1] == pytest.approx(middle, rel=2e-13 if "log" in text else 1e-15, abs=0.0)
    assert min(found) in (found[0], found[2])
    assert max(found) in (found[0], found[2])


def test_a_range_of_whole_numbers_is_exact_however_large_they_are():
    large = 3**200
    found = [row["a"] for row in values(rows_of([f"a={large}:{large + 4}:3"]))]
    assert found == [large, large + 2, large + 4]


@pytest.mark.parametrize(
    ("grid", "words"),
    [
        (5, "--grid 5: error: not of the form name=values"),
        ([5], "--grid 5: error: not of the form name=values"),
        ({"a": []}, "grid['a']=[]: error: no values"),
        ({"a": [2, 1, 2]}, "grid['a']=[2, 1, 2]: error: the value 2 is given twice"),
        ({"a": "2,,1"}, "grid['a']=2,,1: error: column 3: a value is missing"),
    ],
    ids=str,
)
def test_mistakes_of_grids_of_python_are_told_like_those_of_texts(grid, words):
    with pytest.raises(UsageError) as caught:
        rows_of(grid)
    assert str(caught.value).startswith(words)


def test_a_single_text_is_a_grid():
    assert values(rows_of("a=1,2")) == [{"a": 1}, {"a": 2}]


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ([], "table: error: has no rows"),
        ([{"a": 1}, {"b": 1}], "table[1]: error: must have the names of table[0]: differs in a, b"),
        ([{"a": 1}, {"a": 1, "b": 1}], "table[1]: error: must have the names of table[0]: differs"),
        (["a", "b"], "table[0]: error: must have values by name, got 'a'"),
    ],
    ids=str,
)
def test_a_table_of_python_has_the_same_names_in_all_rows(table, words):
    with pytest.raises(UsageError) as caught:
        rows_of([], table)
    assert str(caught.value).startswith(words)


def test_grids_multiply_and_the_last_turns_fastest():
    assert values(rows_of(["a=1,2", "b=3,4"])) == [
        {"a": 1, "b": 3},
        {"a": 1, "b": 4},
        {"a": 2, "b": 3},
        {"a": 2, "b": 4},
    ]


def test_a_grid_can_be_given_as_arrays():
    rows = rows_of({"a": np.linspace(0.0, 1.0, 3), "b": "1:2:2", "c": 5, "d": [np.int64(4)]})
    assert values(rows)[1] == {"a": 0.0, "b": 2, "c": 5, "d": 4}
    assert len(rows) == 6
    assert type(rows[0]["d"].value) is int


def test_a_table_has_a_row_for_each_line(tmp_path):
    table = tmp_path / "a.csv"
    table.write_text('a, b\n1, text\n\n2.5, "[0, 1]"\n', encoding="utf-8-sig")
    expected = [{"a": 1, "b": "text"}, {"a": 2.5, "b": [0, 1]}]
    assert values(rows_of([], table)) == expected
    assert values(rows_of([], expected)) == expected
    assert len(rows_of(["c=1,2,3"], table)) == 6


@pytest.mark.parametrize(
    ("grids", "reports"),
    [
        (["a"], ["--grid a: error: not of the form name=values"]),
        (["a="], ["--grid a=: error: column 3: a value is missing"]),
        (["a=1,,2"], ["--grid a=1,,2: error: column 5: a value is missing"]),
        (["a=1:2"], ["--grid a=1:2: error: column 3: '1:2' is not a range from:to:count"]),
        (["a=7,1:x:3"], ["--grid a=7,1:x:3: error: column 7: 'x' is not a number"]),
        (["a=1:nan:3"], ["--grid a=1:nan:3: error: column 5: 'nan' is not a finite number"]),
        (["a=1:5:1"], ["the count must be a whole number from 2 to 1000000, got 1"]),
        (["a=1:5:2.5"], ["the count must be a whole number from 2 to 1000000, got 2.5"]),
        (["a=-1:5:3:log"], ["from and to of a range with log must have one sign, got -1 and 5"]),
        (["a=[1"], ["--grid a=[1: error: column 3: '[1': "]),
        (["a=1,2", "a=3"], ["--grid a=3: error: a: varied by --grid a=1,2 too"]),
        (
            ["a=1:2:2000", "b=1:2:2000"],
            ["error: 4000000 combinations, more than the 1000000 of one study"],
        ),
        (["a=1:1:3"], ["from and to of a range must differ, got 1 and 1"]),
        (["a=2,1:3:3"], ["a=2,1:3:3: error: the value 2 is given twice"]),
        (["a=1,1.0"], ["the value 1.0 is given twice"]),
        (["a=1_0"], ["--grid a=1_0: error: column 3: '1_0': a number has no '_'"]),
        (["a=1:1_0:3"], ["--grid a=1:1_0:3: error: column 5: '1_0': a number has no '_'"]),
        (["a=1:1e400:3"], ["column 5: '1e400' is not a finite number"]),
        ([f"a=1:1{'0' * 400}:3"], ["0' is not a finite number"]),
        (["a", "b=1:2"], ["--grid a: error", "--grid b=1:2: error"]),
    ],
    ids=str,
)
def test_mistakes_of_grids_name_the_place_and_come_all_at_once(grids, reports):
    with pytest.raises(UsageError) as caught:
        rows_of(grids)
    assert not [report for report in reports if report not in str(caught.value)]


@pytest.mark.parametrize(
    ("text", "report"),
    [
        ("", "a.csv:1: error: no header"),
        ("a,b\n", "a.csv: error: has no rows below its header"),
        ("a,\n1,2\n", "a.csv:1: error: column 2 has no name"),
        ("a,a\n1,2\n", "a.csv:1: error: column 2: 'a' is given twice"),
        ("a;b\n1;2\n", "a.csv:1: error: column 1: 'a;b' is not a name"),
        ("1,2\n3,4\n", "a.csv:1: error: column 1: '1' is not a name"),
        ("1_0\n3\n", "a.csv:1: error: column 1: '1_0' is not a name"),
        ("a\n1_0\n", "a.csv:2: error: a: 1_0: a number has no '_'"),
        ("a,b\n1,2\n3\n", "a.csv:3: error: has 1 cell, and the header has 2"),
        ("a,b\n1,2\n3,\n", "a.csv:3: error: b: an empty cell"),
        ("a\n[1\n", "a.csv:2: error: a: [1: "),
    ],
    ids=range(11),
)
def test_mistakes_of_tables_name_line_and_column(tmp_path, monkeypatch, text, report):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text(text)
    with pytest.raises(UsageError) as caught:
        rows_of([], "a.csv")
    assert str(caught.value).startswith(report)


def test_mistakes_of_a_table_come_all_at_once(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text("a,2\n1\n,3\n[1,4\n1,2,3\n")
    with pytest.raises(UsageError) as caught:
        rows_of(["c"], "a.csv")
    lines = str(caught.value).splitlines()
    places = [line.partition(": error")[0] for line in lines if "= help" not in line]
    assert sorted(places) == ["--grid c", *(f"a.csv:{line}" for line in range(1, 6))]


@pytest.mark.parametrize(
    ("text", "report", "help"),
    [
        ('a\n"1\n', "not CSV: unexpected end of data", "close each quote"),
        ('a\n"1"2\n', "not CSV: ',' expected after '\"'", "close each quote"),
        ("a\n" + "1" * 200_000, "a cell has more than 131072 characters", "no value is so long"),
    ],
    ids=["open", "within", "long"],
)
def test_only_mistakes_of_quotes_have_a_help_about_quotes(
    tmp_path, monkeypatch, text, report, help
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.csv").write_text(text)
    with pytest.raises(UsageError) as caught:
        rows_of([], "a.csv")
    assert f"error: {report}\n  = help: {help}" in str(caught.value)
    assert str(caught.value).count("error") == 1


def test_a_name_of_both_a_grid_and_a_table_is_refused(tmp_path):
    table = tmp_path / "a.csv"
    table.write_text("a\n1\n")
    with pytest.raises(UsageError, match=r"--grid a=2: error: a: varied by .*a\.csv:1 too"):
        rows_of(["a=2"], table)
