"""Random damage to scenes: a scene that is assembled and takes a step, or a report."""

from __future__ import annotations

import copy
import json
import random
import re
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import solver
from tests.support.mechanisms.scene_files import ALL

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

LONGEST = 4000
"""Characters of a scene that is damaged; the longer ones are not of other kinds."""
NUMBERS = (
    *("0", "-0.0", "-1", "1e9", "1e-9", "1e16", "1e-12", "1e-150", "1e150", "1e-308", "5e-324"),
    *("1e308", "-1e308", "1e400", "nan", "inf", "-inf", "9007199254740993", "1" * 30, "1" * 5000),
    *("0x" + "f" * 5000, "0b1", "true", '""', "[]", "{}", "[[]]", "[1, 2]", "[1, 2, 3, 4]"),
    *("1979-05-27", '"1/0"', '"9**9**9**9"', '"sqrt(-1)"', '"exp(1000)"', '"mod(1, 0)"', '"t"'),
    *("[nan, nan, nan]", "[0, 0, 0]", "[1e200, 1e200, 1e200]", "[1e-200, 0, 0]", "{ value = 1.0 }"),
)
WORDS = (
    *("A.B", "a\nb", 'a"b', "<x>", "&amp;", "]]>", "é", "\u202e", "", "t", "pi", "ground"),
    *("lambda",),
    *("energy", "solver", "__class__", "A" * 10_000, "x.y.z", "\x00", "%s%n", "../x", "None", "1a"),
    *("floor", "Nm", "90 deg", "A", "O", "B", "distance(A, A)", "2 m9", "m" + "9" * 400),
)
VALUES = (
    *(None, True, False, 0, -1, 1e308, -1e200, 1e-200, 5e-324, 10**400, 2**64, [], {}, [[]]),
    *([None],),
    *({"type": "x"}, {"": 1}, [1, 2], [1, 2, 3], [[1, 2, 3]] * 3, {"value": 1}, "\ud800"),
    *("x" * 50_000, list(range(9000)), {f"k{i}": i for i in range(2000)}, {"a\nb": {}}, *WORDS),
)
SIGNS = [*"[]{}=\"'#.,\n \t\r\\:;()*/+-<>&%$@!_09aAeE\x00\x7f", "\ufeff", "\u2028", '"""', "[["]
LINES = (
    *("[points]", "[[points]]", "a.b.c = 1", "[" + "a." * 500 + "a]", "x = " + "[" * 400, "'' = 1"),
    *("x = " + "[" * 40 + "]" * 40, "x = " + "{a=" * 40 + "1" + "}" * 40, '[parameters]\np = "p"'),
    *("[solver]\norder = 8", "[solver]\ntolerance = 1e-9", '[solver]\nstart = "equilibrium"'),
    *("[solver]\nassemble = true", "[solver]\nstep_size = 1e-300", "gravity = [1e200, 1e200, 0]"),
    '[parameters]\np = "q"\nq = "p"',
    "[parameters]\n" + "\n".join(f'k{i} = "k{i + 1} + 1"' for i in range(1500)),
    "[parameters]\n" + "\n".join(f'k{i} = "w{i}"' for i in range(3000)),
)  # fmt: skip
NESTS = (("(", ")"), ("sin(", ")"), ("-", ""), ("not ", ""), ("max(1, ", ")"), ("2**", ""))
JOINTS = ("+", "-", "*", "/", "**", " and ", " < ", ".", " if t else ", ", ")
TOKEN = re.compile(r'"[^"\n]*"|[A-Za-z_][A-Za-z_0-9]*|-?\d+\.?\d*(?:[eE][-+]?\d+)?|\S')
NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:[eE][-+]?\d+)?(?!\w)")


def prepare(_folder: Path) -> None:
    """Nothing: the cases damage scenes of the repository."""


def case(seed: str, number: int, _folder: Path) -> str | None:
    """Damage a scene, then read it, assemble it and take a step."""
    chance = random.Random(f"{seed}/{number}")
    texts = [text for path in ALL if len(text := path.read_text("utf-8")) < LONGEST]
    damage = chance.choice((_tokens, _numbers, _numbers, _signs, _lines, _tables))
    text = damage(chance, chance.choice(texts))
    notation = "json" if damage is _tables else "toml"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", solver.SceneWarning)
        try:
            scene = solver.loads(text, format=notation)
            run = solver.Integrator(solver.assemble(scene))
            run.advance(run.time, scene.solver.step_size or 1e-3)
        except solver.SceneError as error:
            return None if _printable(str(error)) else "the report cannot be printed"
        except (solver.StepError, solver.OptionError):
            return None
    return None


def _printable(text: str) -> bool:
    return bool(text) and text == text.encode("utf-8", "replace").decode()


def _expression(chance: random.Random) -> str:
    """A long, deep or broken expression."""
    size, name = (
        chance.choice([3, 10, 50, 100, 999, 3000]),
        chance.choice(["t", "A.x", "length", "1"]),
    )
    before, after = chance.choice(NESTS)
    joint = chance.choice(JOINTS)
    return chance.choice([
        before * size + name + after * size,
        joint.join([name] * size),
        f"max({', '.join([name] * size)})",
        "*".join(f"({name} + {i})" for i in range(min(size, 300))),
        "".join(chance.choice([*JOINTS, "(", ")", name, "2", "mod(", "floor("]) for _ in range(30)),
        chance.choice(WORDS),
    ])  # fmt: skip


def _quoted(text: str) -> str:
    return json.dumps(text)


def _tokens(chance: random.Random, text: str) -> str:
    """Words, numbers and signs replaced, doubled or left out."""
    for _ in range(chance.choice([1, 1, 1, 2, 4])):
        tokens = list(TOKEN.finditer(text))
        if chance.random() < 0.7:  # values alone, so that the file remains one of TOML
            tokens = [token for token in tokens if token[0][0] in '"-0123456789']
        if not tokens or len(text) > 5 * LONGEST:
            break
        token, other = chance.choice(tokens), chance.choice(tokens)
        new = chance.choice([
            "", other[0], chance.choice(NUMBERS), f"{token[0]} {token[0]}",
            _quoted(_expression(chance)), _quoted(chance.choice(WORDS)), chance.choice(WORDS[:20]),
        ])  # fmt: skip
        text = text[: token.start()] + new + text[token.end() :]
    return text


def _numbers(chance: random.Random, text: str) -> str:
    """Numbers replaced by others: most of these scenes are read, and meet the mechanics."""
    for _ in range(chance.choice([1, 1, 2, 3, 6])):
        found = chance.choice(list(NUMBER.finditer(text)))
        usual = [repr(chance.uniform(-5, 5)), repr(10.0 ** chance.uniform(-30, 30)), "1", "2", "3"]
        new = chance.choice([chance.choice(NUMBERS[:19]), f"-{found[0].lstrip('-')}", *usual])
        text = text[: found.start()] + new + text[found.end() :]
    return text


def _signs(chance: random.Random, text: str) -> str:
    """Characters put in, taken out or copied."""
    for _ in range(chance.choice([1, 1, 2, 5, 20])):
        at, from_ = chance.randrange(len(text) + 1), chance.randrange(len(text) + 1)
        new = chance.choice(["", chance.choice(SIGNS), text[from_ : from_ + chance.randrange(40)]])
        text = text[:at] + new + text[at + chance.choice([0, 0, 1, 9]) :]
    return text


def _lines(chance: random.Random, text: str) -> str:
    """Lines left out, doubled, moved, cut off or put in."""
    lines = text.split("\n")
    for _ in range(chance.choice([1, 1, 2, 5])):
        line = lines.pop(chance.randrange(len(lines))) if lines else ""
        new = chance.choice([[], [line, line], [line], [line[: len(line) // 2]], None])
        at = chance.randrange(len(lines) + 1)
        lines[at:at] = [line, chance.choice(LINES)] if new is None else new
    return "\n".join(lines)


def _tables(chance: random.Random, text: str) -> str:
    """Values and keys of the tables replaced, written as JSON."""
    data = tomllib.loads(text)
    for _ in range(chance.choice([1, 1, 2, 3])):
        path = chance.choice(list(_paths(data)))
        if not path:
            continue
        owner = data
        for step in path[:-1]:
            owner = owner[step]
        value = owner.pop(path[-1])
        key = chance.choice(WORDS) if chance.random() < 0.2 else path[-1]
        new = chance.choice([value, *chance.choices(VALUES, k=2), _expression(chance)])
        if isinstance(owner, list):
            owner.insert(path[-1], copy.deepcopy(new))
        elif chance.random() < 0.9:
            owner[key] = copy.deepcopy(new)
    return json.dumps(data)


def _paths(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield path
    keys = range(len(data)) if isinstance(data, list) else data if isinstance(data, dict) else ()
    for key in [*keys][:100]:
        yield from _paths(data[key], (*path, key))
