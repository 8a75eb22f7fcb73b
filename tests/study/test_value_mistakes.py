"""Mistakes of grids, tables and files of values: each with place, value, rule and remedy.

What is wrong with a number, a cell or an item, whatever its place, is a property
(test_values_read.py); here are the mistakes of headers, names, structure and notation.
"""

from __future__ import annotations

import itertools
from pathlib import Path

import pytest

from build_fmu.errors import UsageError
from build_fmu.study.grid import rows_of
from tests.study.test_values_read import SET, read

QUOTES = "help: close each quote"
HEADER = "the header is 'parameter,value'\n  = help: it must be name,value or name,value,unit\n"
REAL = '<ssv:Parameter name="a"><ssv:Real value="1"/>{}</ssv:Parameter>'
UNIT = '<ssc:Unit name="u"><ssc:BaseUnit factor="{}"/></ssc:Unit>'
FACTOR = "a.ssv:2: error: unit 'u': factor must be "
DEEP = 100_000


def table(text: str):
    """Rows of a table in a file."""
    Path("a.csv").write_text(text)
    return rows_of([], "a.csv")


def rows(table):
    return rows_of([], table)


def of_file(name: str):
    """Reader of the text of a file of parameters."""

    def read_text(text: str):
        Path(name).write_text(text)
        return read(Path(name))

    return read_text


csv, json, toml, ssv, yaml = map(of_file, ("a.csv", "a.json", "a.toml", "a.ssv", "a.yaml"))

MISTAKES = [
    (rows_of, ["a"], "--grid a: error: not of the form name=values\n  = help: write values, a=2"),
    (rows_of, 5, "--grid 5: error: not of the form name=values"),
    (rows_of, ["a", "b=1:2"], "--grid a: error: not of the form", "--grid b=1:2: error: column 3"),
    (rows_of, ["a=1:5:2.5"], "the count must be a whole number from 2 to 1000000, got 2.5"),
    (rows_of, ["a=1:1e400:3"], "column 5: '1e400' is not a finite number"),
    (rows_of, [f"a=1:1{'0' * 400}:3"], "0' is not a finite number"),
    (rows_of, ["a=1,1.0"], "the value 1.0 is given twice; give it once"),
    (rows_of, {"a": [2, 1, 2]}, "grid['a']=[2, 1, 2]: error: the value 2 is given twice"),
    (rows_of, {"a": []}, "grid['a']=[]: error: no values"),
    (rows_of, {"a": "2,,1"}, "grid['a']=2,,1: error: column 3: a value is missing"),
    (rows_of, ["a=1,2", "a=3"], "--grid a=3: error: a: varied by --grid a=1,2 too"),
    (rows_of, ["a=1:2:2000", "b=1:2:2000"], "4000000 combinations, more than the 1000000 of one"),
    (rows, [], "table: error: has no rows"),
    (rows, [{"a": 1}, {"b": 1}], "table[1]: error: must have the names of table[0]: differs in a"),
    (rows, ["a", "b"], "table[0]: error: must have values by name, got 'a'"),
    (rows, "none.csv", "none.csv: error: cannot be read: No such file", "look at its name"),
    (table, "", "a.csv:1: error: no header\n  = help: write the names of parameters"),
    (table, "a,b\n", "a.csv: error: has no rows below its header"),
    (table, "a,\n1,2\n", "a.csv:1: error: column 2 has no name"),
    (table, "a,a\n1,2\n", "a.csv:1: error: column 2: 'a' is given twice"),
    (table, "a;b\n1;2\n", "a.csv:1: error: column 1: 'a;b' is not a name"),
    (table, "1_0,2\n3,4\n", "a.csv:1: error: column 1: '1_0' is not a", "column 2: '2' is not a"),
    (table, "a,b\n1,2\n3\n", "a.csv:3: error: has 1 cell, and the header has 2\n  = help: put"),
    (table, "a,2\n1\n,3\n", "a.csv:1: ", "a.csv:2: ", "a.csv:3: "),
    (table, 'a\n"1\n', "a.csv:2: error: not CSV: unexpected end of data", QUOTES),
    (table, 'a\n"1"2\n', "a.csv:2: error: not CSV: ',' expected after '\"'", QUOTES),
    (table, "a\n" + "1" * 200_000, "a.csv:2: error: a cell has more than 131072 characters"),
    (csv, "parameter,value\nmass,1\nx\n", "a.csv:1: error: " + HEADER, "a.csv:3: error: has 1"),
    (csv, '"name,value"\n"mass,1"\n', "'name,value' in quotes, as one cell\n  = help: write it w"),
    (csv, "name;value\nmass;1\n", "the header is 'name;value'", "name,value,unit, separated by c"),
    (csv, "name,value\na,1,2\n", "a.csv:2: error: has 3 cells, and the header has 2"),
    (csv, "name,value\na,\n", "a.csv:2: error: a: an empty cell"),
    (csv, "name,value\na,2\na,3\n", "a.csv:3: error: a: given twice, first at a.csv:2"),
    (csv, f"name,value\na,{'[' * DEEP}\n", "a.csv:2: error: a: nested too deeply"),
    (toml, "a = 1\nb = = 2\n", "a.toml:2:5: error: TOML: Invalid value"),
    (toml, "a = 2\na = 4\n", "a.toml:2:6: error: TOML: Cannot", "given twice, first in line 1"),
    (toml, '"s.b" = 2\n[s]\nb = 4\n', "a.toml:3: error: s.b: given twice, first at a.toml:1"),
    (toml, "a = 2\nparameters.a = 4\n", "parameters.a: given twice, first as a at a.toml:1"),
    (toml, f"a = {'[' * DEEP}", "a.toml: error: TOML: nested too deeply"),
    (json, '{"a": 1,\n "b": }', "a.json:2:7: error: JSON: Expecting value"),
    (json, "[1]", "a.json: error: must be a table of fields, got [1]"),
    (json, '{"a": 1,\n "a": 2}', "a.json:2: error: a: given twice, first in line 1"),
    (json, '{"s.b": 2,\n "s": {"b": 4}}', "a.json:2: error: s.b: given twice, first at a.json:1"),
    (json, '{"g": [0, Infinity]}', "a.json:1: error: g: must be a finite number, got inf"),
    (json, '{"a":' * DEEP, "a.json: error: JSON: nested too deeply"),
    (json, '{"a":' * 200 + "1" + "}" * 200, "a.json: error: nested too deeply"),
    (yaml, "a: 1", "unknown kind of file '.yaml'\n  = help: known: .toml, .json, .csv, .ssv"),
    (ssv, "", "a.ssv:1:1: error: not XML: Document is empty"),
    (ssv, "<a>\n</b>", "a.ssv:2:5: error: not XML: Opening and ending tag mismatch"),
    (ssv, '<?xml version="1.0" encoding="klingon"?><a/>', "a.ssv:1:39: error: not XML: Unsupp"),
    (ssv, "<a/>", "a.ssv:1: error: not a parameter set of SSP 1.0, but 'a'\n  = help: the root"),
    (ssv, SET.format("<ssv:Parameter/>"), "a.ssv:2: error: a Parameter without a name"),
    (ssv, SET.format(REAL.format('\n<ssv:Real value="2"/>')), "a.ssv:3: error: a: has two values"),
    (ssv, SET.format(REAL.replace("Real", "Binary")), "a: has no value\n  = help: write an"),
    (ssv, SET.format(f"{REAL}\n{REAL}"), "a.ssv:3: error: a: given twice, first at a.ssv:2"),
    (ssv, SET.format(REAL.replace("1", "long")), "a.ssv:2: error: a: must be a number, got 'long'"),
    (ssv, SET.format(UNIT.format(1) + "\n" + UNIT.format(1)), "a.ssv:3: error: unit 'u': defined"),
    (ssv, SET.format(UNIT.format("x")), FACTOR + "a number, got 'x'"),
    *(
        (ssv, SET.format(UNIT.format(x)), f"{FACTOR}a finite number > 0, got '{x}'")
        for x in ("0", "nan", "INF", "-1")
    ),
]  # fmt: skip


@pytest.mark.parametrize("mistake", MISTAKES, ids=itertools.count())
def test_a_mistake_is_told_with_place_value_rule_and_remedy(tmp_path, monkeypatch, mistake):
    monkeypatch.chdir(tmp_path)
    reader, given, *reports = mistake
    with pytest.raises(UsageError) as caught:
        reader(given)
    assert [report for report in reports if report not in str(caught.value)] == []
    assert str(caught.value).count("error: ") <= max(len(reports), 3)


def test_a_name_of_both_a_grid_and_a_table_is_refused(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("a\n1\n")
    with pytest.raises(UsageError, match=r"--grid a=2: error: a: varied by .*a\.csv:1 too"):
        rows_of(["a=2"], path)
