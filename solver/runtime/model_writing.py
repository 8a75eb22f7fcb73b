"""Writes the bytes of a model, as ``solver/kernel/model_file.h`` lays them out; not for a run."""

from __future__ import annotations

import hashlib
import json
import struct
import sys
import zlib
from array import array
from collections.abc import Iterable, Iterator

from solver.options import OPTIONS, Option

from . import layout
from .errors import OptionError
from .model import Model, Rule, Variable
from .model_file import BEFORE_CHECKED, HEADER, MAGIC, ROW, RULE, VARIABLE


class _Texts:
    """Texts one behind the other, each once, each with a zero at its end."""

    def __init__(self) -> None:
        self.data, self._at = bytearray(1), {b"": 0}

    def at(self, text: str) -> int:
        """Return where a text begins."""
        return self._place(text.encode())

    def words(self, words: Iterable[str]) -> int:
        """Return where some words begin; an empty one ends them."""
        return self._place(b"".join(word.encode() + b"\0" for word in words))

    def _place(self, content: bytes) -> int:
        if content not in self._at:
            self._at[content] = len(self.data)
            self.data += content + b"\0"
        return self._at[content]


def rules_of_laws(model: Model) -> set[Rule]:
    """Return the rules that inputs and tunable parameters can break in motion, unnoticed.

    A law that is not finite is noticed: the step fails. So plain loads need no check.
    """
    sizes, offsets = model.sizes, model.offsets
    start = 5 * sizes["n_tape_parameters"]  # an operation is code, target and three arguments
    laws = model.tables["tape"][start : start + 5 * sizes["n_tape_laws"]]
    moved = {*laws[1::5], *range(offsets["input"], offsets["input"] + sizes["n_inputs"])}
    for variable in model.variables:
        if variable.kind == "parameter" and variable.variability == "tunable":
            moved.add(offsets["parameter"] + variable.place)
    return {r for r in model.rules if r.number in moved and r.relation in (">", ">=")}


def stored(option: Option, value: object) -> float:
    """Return what the state's head holds for a value of a setting.

    Raises
    ------
    OptionError
        When the value is not allowed.
    """
    if not option.holds(value):
        message = f"solver.{option.name}: must be {option.rule}, got {value!r}"
        raise OptionError(message)
    return float(option.words.index(value) if option.words else value)  # type: ignore[arg-type]


def _record(variable: Variable, texts: _Texts) -> bytes:
    place, start, words, least = variable.place, variable.start, 0, 0.0
    flags = {"has_minimum": variable.minimum is not None, "clips": variable.clips}
    flags |= {"has_maximum": variable.maximum is not None, "has_start": start is not None}
    if variable.kind == "option":
        option = OPTIONS[variable.name.removeprefix("solver.")]
        start, least = stored(option, start), option.least
        place = layout.PLACE[option.stored_as]
        words = texts.words(option.words or (option.rule,))
        flags |= {"whole": option.whole, "even": bool(option.allowed)}
    codes = [known.index(getattr(variable, field)) for field, known in layout.WORDS.items()]
    numbers = (start, variable.minimum, variable.maximum, least)
    return VARIABLE.pack(
        texts.at(variable.name), texts.at(variable.unit), *codes, place,
        *(float(number or 0.0) for number in numbers),
        sum(layout.FLAGS[flag] for flag in flags if flags[flag]), words,
    )  # fmt: skip


def _records(model: Model, texts: _Texts) -> Iterator[bytes]:
    """Yield the records of variables, rules and rows."""
    laws = rules_of_laws(model)
    for variable in model.variables:
        yield _record(variable, texts)
    for rule in model.rules:
        relation = [*layout.RELATIONS].index(rule.relation)
        relation |= layout.OF_A_LAW if rule in laws else 0
        places = texts.at(rule.name), texts.at(rule.message)
        yield RULE.pack(rule.number, relation, rule.bound, *places)
    for row in model.rows:
        kind = layout.ROW_KINDS.index(row.kind)
        yield ROW.pack(texts.at(row.name), texts.at(row.detail), kind, 0)


def _rest(model: Model) -> dict[str, object]:
    """Return what only Python reads."""
    return {
        "name": model.name, "description": model.description, "forces": model.forces,
        "meshes": model.meshes, "experiment": model.experiment,
        "variables": [variable.description for variable in model.variables],
        "rules": [rule.location for rule in model.rules],
        "rows": [row.location for row in model.rows],
    }  # fmt: skip


def _settings(model: Model) -> array:
    """Return the head of the state that a run begins with."""
    head = array("d", bytes(8 * len(layout.HEAD)))
    for name, value in model.settings.items():
        option = OPTIONS[name]
        head[layout.PLACE[option.stored_as]] = stored(option, value)
    start, stop, *_ = model.experiment
    head[layout.PLACE["time"]], head[layout.PLACE["horizon"]] = start, stop - start
    return head


def _little_endian(values: array) -> bytes:
    if sys.byteorder == "big":
        values = array(values.typecode, values)
        values.byteswap()
    return values.tobytes()


def _filled(data: bytes | bytearray, by: bytes = b"\0") -> bytes:
    return bytes(data) + by * (-len(data) % 8)


def to_bytes(model: Model, guid: str = "") -> bytes:
    """Return the bytes of a model; the same model gives the same ones.

    `guid` is that of the FMU which carries it; the fingerprint does not depend on it.
    """
    assert tuple(model.sizes) == layout.SIZES
    assert tuple(model.tables) == tuple(layout.TABLES)
    assert tuple(model.offsets) == tuple(layout.OFFSETS)
    texts = _Texts()
    numbers = [*model.sizes.values(), *model.offsets.values(), *map(len, model.tables.values())]
    ints = array("i", numbers)
    for table in model.tables.values():
        ints += table
    records = b"".join(_records(model, texts))
    said = model.sampled + model.switches
    names = struct.pack(f"<{len(said)}I", *map(texts.at, said))
    text = _filled(texts.data)
    body = b"".join([
        _filled(_little_endian(ints)), _little_endian(_settings(model)),
        _little_endian(model.numbers), records, _filled(names), text,
        _filled(json.dumps(_rest(model), separators=(",", ":")).encode(), b" "),
    ])  # fmt: skip
    counts = (
        layout.ABI, len(ints), len(model.numbers), len(model.variables), len(model.rules),
        len(model.rows), len(said), len(text),
    )  # fmt: skip
    # A saved state, too, has the layout of its version.
    fingerprint = hashlib.sha256(struct.pack("<I", layout.ABI) + body).hexdigest()[:32].encode()
    length = HEADER.size + len(body)
    data = HEADER.pack(MAGIC, 0, *counts, guid.encode(), fingerprint, length) + body
    checksum = zlib.crc32(data[BEFORE_CHECKED:]).to_bytes(4, "little")
    return MAGIC + checksum + data[BEFORE_CHECKED:]
