"""Random settings, files of parameters, tables and inputs: the command answers in words."""

from __future__ import annotations

import contextlib
import io
import json
import random
import warnings
from pathlib import Path

from build_fmu import build
from build_fmu.command_line import main
from tests.hostile.archives import CODES, SCENE

CPU_LIMIT = 5.0
NAMES = (
    *("length", "push", "points.A.mass", "solver.step_size", "solver.order", "solver.start"),
    *("nonsense", "a b", "", "time", "1", "é", "name", "points", "points.A", "points.A.position"),
    *("points.A.position[0]", "points.A.position[99999999999]", "[0]", "..", '""', "solver"),
    *("name.x",),
    *("parameters.length.value", "inputs.push.start", "experiment.stop_time"),
    *("joints.rod.points[1]",),
    *("parameters.length", "dimension", "points.\ud800", "\x07", "gravity"),
)
VALUES = (
    *("1", "2.5", "-1", "nan", "inf", "-inf", "1e400", "1" * 5000, "0x" + "f" * 5000, "0x10"),
    *("1_0",),
    *("true", "false", "null", "[1,2]", "[" * 3000, "[1" + "0" * 5000 + "]", "{}", '"x"', "x", ""),
    *("conserving-al", "2*length", "1/0", "9**9**9", "(" * 300, "[nan]", "[[1]]", "mod(1, 0)"),
    *("1e308", "5e-324", "1e-200", "\x07", "\u0661", "1979-05-27", "1:2:3", "Infinity", "\ud800"),
    *("max(" + "length," * 3000 + "1)", "90 deg", "1 mm", "é", '{"a": 1}'),
)
SSV = """<?xml version="1.0"?>%s<p:ParameterSet version="1.0" name="x"
 xmlns:p="http://ssp-standard.org/SSP1/SystemStructureParameterValues"
 xmlns:c="http://ssp-standard.org/SSP1/SystemStructureCommon"><p:Parameters>%s</p:Parameters>
<p:Units><c:Unit name="g"><c:BaseUnit kg="1" factor="%s"/></c:Unit></p:Units></p:ParameterSet>"""
ENTITIES = "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 12))
DOCTYPES = (
    *("", "", "", f'<!DOCTYPE x [<!ENTITY a0 "ha">{ENTITIES}]>'),
    '<!DOCTYPE x [<!ENTITY a11 SYSTEM "file:///etc/passwd">]>',
)
SIGNS = [
    "\ufeff",
    "\x00",
    "<!ENTITY",
    "&lol;",
    "]]>",
    "<![CDATA[",
    "<?x?>",
    *"[]{}=\"'#.,\n\t\r:;<>&%eE9",
]


def prepare(folder: Path) -> None:
    """Write a scene and its FMU."""
    (folder / "good.toml").write_text(SCENE, encoding="utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        build(folder / "good.toml", folder / "good.fmu")


def case(seed: str, number: int, folder: Path) -> str | None:
    """Give a setting or a damaged file to a command."""
    chance = random.Random(f"{seed}/{number}")
    kind = chance.choice(
        ["set", "grid", "table", "inputs", "scene", ".toml", ".json", ".csv", ".ssv"]
    )
    arguments = _arguments(chance, kind, folder)
    said, wrong = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(wrong):
        try:
            code = main(arguments)
        except SystemExit as end:  # of argparse
            code = end.code
    text = said.getvalue() + wrong.getvalue()
    if code not in CODES or "Traceback" in text:
        return f"{arguments}: exit code {code}: {text[-300:]}"
    if not text.strip():
        return f"{arguments}: exit code {code} without a word"
    answer = said.getvalue()  # the standard error escapes what it cannot print
    return None if answer == answer.encode("utf-8", "replace").decode() else "cannot be printed"


def _arguments(chance: random.Random, kind: str, folder: Path) -> list[str]:
    """Arguments of a command that reads something bad; its runs are short."""
    scene, unit = str(folder / "good.toml"), str(folder / "good.fmu")
    name, value = chance.choice(NAMES), chance.choice(VALUES)
    results = ["-o", str(folder / "results.csv"), "--fresh", "--engine", "serial", "--stop", "0.01"]
    if kind == "set":
        command = chance.choice([["info", scene], ["simulate", unit, "--stop", "0.01"]])
        return [*command, "--set", f"{name}={value}"]
    if kind == "grid":
        other, count = (
            chance.choice(VALUES),
            chance.choice(["3", "0", "-1", "2.0", "x", "99999999"]),
        )
        ends = ("", ",", f",{other}", f":{other}:{count}", ":5:3:log", ":5:3", f":{other}")
        return ["sweep", unit, "--grid", f"{name}={value}{chance.choice(ends)}", *results]
    path = folder / (f"bad{kind}" if kind.startswith(".") else "bad.csv")
    if kind == "scene":
        path = folder / "bad.toml"
    path.write_bytes(_damaged(chance, _text(chance, kind)))
    if kind == "scene":
        return ["info", str(path)]
    if kind == "table":
        return ["sweep", unit, "--table", str(path), *results]
    if kind == "inputs":
        command = chance.choice(["simulate", "check"])
        return [command, unit, "--stop", "0.01", "--step", "0.005", "--inputs", str(path)]
    command = chance.choice([["info", scene], ["simulate", unit, "--stop", "0.01"]])
    return [*command, "--parameters", str(path)]


def _text(chance: random.Random, kind: str) -> str:
    """Text of a file that is, but for its names and values, one of its kind."""
    count = chance.choice([1, 1, 2, 4])
    pairs = [(chance.choice(NAMES), chance.choice(VALUES)) for _ in range(count)]
    if kind == "scene":
        return SCENE
    if kind == ".toml":
        return "\n".join(
            f"{chance.choice([n, json.dumps(n)])} = {chance.choice([v, v, json.dumps(v)])}"
            for n, v in pairs
        )
    if kind == ".json":
        entries = (f"{json.dumps(n)}: {chance.choice([v, json.dumps(v)])}" for n, v in pairs)
        return "{" + ",".join(entries) + "}"
    if kind == ".csv":
        head = chance.choice(["name,value\n", "name,value,unit\n", "", "value\n"])
        units = ["", ",kg", ",g", ",mm", ",deg", ",1", ",m" + "9" * 400]
        return head + "".join(f'{n},"{v}"{chance.choice(units)}\n' for n, v in pairs)
    if kind == ".ssv":
        kinds = ["Real", "Integer", "Boolean", "String", "Enumeration", "Binary"]
        body = "".join(
            f'<p:Parameter name="{_escaped(n)}"><p:{chance.choice(kinds)} value="{_escaped(v)}" '
            f'unit="{chance.choice(["kg", "g", "m", "", "deg"])}"/></p:Parameter>'
            for n, v in pairs
        )
        doctype = chance.choice(DOCTYPES)
        return SSV % (doctype, body + ("&a11;" if doctype else ""), chance.choice(VALUES[:9]))
    if kind == "table":
        rows = [[name for name, _ in pairs]]
        rows += [[_cell(chance) for _ in pairs] for _ in range(chance.choice([0, 1, 3]))]
    else:
        names = ["push", "push", "nonsense", "length", ""]
        rows = [["time", *(chance.choice(names) for _ in range(chance.choice([0, 1, 1, 2])))]]
        times = sorted(chance.uniform(-0.001, 0.02) for _ in range(chance.choice([0, 1, 2, 5])))
        rows += [[repr(time), *(_cell(chance) for _ in rows[0][1:])] for time in times]
    return "".join(",".join(row) + "\n" for row in rows)


def _cell(chance: random.Random) -> str:
    return chance.choice(VALUES) if chance.random() < 0.1 else repr(chance.uniform(-2.0, 2.0))


def _escaped(text: str) -> str:
    for sign, name in (
        ("&", "&amp;"),
        ("<", "&lt;"),
        ('"', "&quot;"),
        ("\ud800", ""),
        ("\x07", ""),
    ):
        text = text.replace(sign, name)
    return text


def _damaged(chance: random.Random, text: str) -> bytes:
    data = bytearray(text.encode("utf-8", "surrogatepass"))
    for _ in range(chance.choice([0, 1, 1, 2, 8])):
        at, from_ = chance.randrange(len(data) + 1), chance.randrange(len(data) + 1)
        sign = chance.choice(SIGNS).encode()
        new = chance.choice([b"", sign, data[from_ : from_ + chance.randrange(1, 40)], b"\xff"])
        data[at : at + chance.choice([0, 0, 1, 15])] = new
    return bytes(data)
