"""The bytes of a model, as ``solver/kernel/model_file.h`` lays them out: written and read here.

header | int32 | doubles | variables | rules | rows | sampled | texts | JSON. The core uses all but
the JSON where it lies; that has what only Python reads: descriptions and places in the scene.
"""

from __future__ import annotations

import json
import struct
import sys
import zlib
from array import array
from collections.abc import Iterable, Iterator, Sequence

from .layout import ABI, HEAD, OFFSETS, PLACE, SIZES, TABLES
from .options import CHOICES, DEFAULTS, LEAST, WHOLE, decode, encode

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from typing import Any

    from .model import Model, Row, Rule, Variable

VERSION = 5
MAGIC = b"HOLONOM\0"
HEADER = struct.Struct("<8sI13I40s32sQ")
_BEFORE_CHECKED = struct.calcsize("<8sI")
VARIABLE, RULE, ROW = struct.Struct("<IIBBBBidddd2I"), struct.Struct("<iidII"), struct.Struct("<4I")

DAMAGED = "the model is damaged, or of an earlier version; build it again"

TYPES = ("Real", "Boolean", "String")
CAUSALITIES = ("parameter", "input", "output", "calculatedParameter")
VARIABILITIES = ("fixed", "tunable", "continuous")
KINDS = ("parameter", "input", "number", "measured", "option")
RELATIONS = ("finite", ">", ">=")
ROW_KINDS = (
    "length", "apart", "off", "height", "turned", "angle", "axes", "value", "driver", "velocity",
)  # fmt: skip
HAS_MINIMUM, HAS_MAXIMUM, HAS_START, CLIPS, IS_WHOLE, IS_ORDER = 1, 2, 4, 8, 16, 32
OF_A_LAW = 256


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
    return {rule for rule in model.rules if rule.number in moved and rule.relation != "finite"}


def _record(variable: Variable, texts: _Texts) -> bytes:
    place, start, flags, words, least = variable.place, variable.start, 0, 0, 0.0
    if variable.kind == "option":
        setting = variable.name.removeprefix("solver.")
        name, start = encode(setting, start)
        place = PLACE[name]
        words = texts.words(CHOICES[setting]) if setting in CHOICES else 0
        flags = (IS_WHOLE if setting in WHOLE else 0) | (IS_ORDER if setting == "order" else 0)
        least = LEAST.get(setting, 0.0)
    for flag, value in (
        (HAS_MINIMUM, variable.minimum), (HAS_MAXIMUM, variable.maximum), (HAS_START, start),
    ):  # fmt: skip
        flags |= 0 if value is None else flag
    return VARIABLE.pack(
        texts.at(variable.name), texts.at(variable.unit), TYPES.index(variable.type),
        CAUSALITIES.index(variable.causality), VARIABILITIES.index(variable.variability),
        KINDS.index(variable.kind), place, float(start or 0.0), float(variable.minimum or 0.0),
        float(variable.maximum or 0.0), least, flags | (CLIPS if variable.clips else 0), words,
    )  # fmt: skip


def _records(model: Model, texts: _Texts) -> Iterator[bytes]:
    """Yield the records of variables, rules and rows."""
    laws = rules_of_laws(model)
    for variable in model.variables:
        yield _record(variable, texts)
    for rule in model.rules:
        relation = RELATIONS.index(rule.relation) | (OF_A_LAW if rule in laws else 0)
        places = texts.at(rule.name), texts.at(rule.message)
        yield RULE.pack(rule.number, relation, rule.bound, *places)
    for row in model.rows:
        yield ROW.pack(texts.at(row.name), texts.at(row.detail), ROW_KINDS.index(row.kind), 0)


def _rest(model: Model) -> dict[str, object]:
    """Return what only Python reads."""
    return {
        "name": model.name, "description": model.description, "forces": model.forces,
        "experiment": model.experiment,
        "variables": [variable.description for variable in model.variables],
        "rules": [rule.location for rule in model.rules],
        "rows": [row.location for row in model.rows],
    }  # fmt: skip


def _settings(model: Model) -> array:
    """Return the head of the state that a run begins with."""
    head = array("d", bytes(8 * len(HEAD)))
    for name, value in model.settings.items():
        stored, number = encode(name, value)
        head[PLACE[stored]] = number
    start, stop, *_ = model.experiment
    head[PLACE["time"]], head[PLACE["horizon"]] = start, stop - start
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
    import hashlib  # only where models are built: it loads OpenSSL

    assert tuple(model.sizes) == SIZES
    assert tuple(model.tables) == TABLES
    assert tuple(model.offsets) == OFFSETS
    texts = _Texts()
    numbers = [*model.sizes.values(), *model.offsets.values(), *map(len, model.tables.values())]
    ints = array("i", numbers)
    for table in model.tables.values():
        ints += table
    records = b"".join(_records(model, texts))
    sampled = struct.pack(f"<{len(model.sampled)}I", *map(texts.at, model.sampled))
    text = _filled(texts.data)
    body = b"".join([
        _filled(_little_endian(ints)), _little_endian(_settings(model)),
        _little_endian(model.numbers), records, _filled(sampled), text,
        _filled(json.dumps(_rest(model), separators=(",", ":")).encode(), b" "),
    ])  # fmt: skip
    counts = (
        VERSION, ABI, len(SIZES), len(OFFSETS), len(TABLES), len(HEAD), len(ints),
        len(model.numbers), len(model.variables), len(model.rules), len(model.rows),
        len(model.sampled), len(text),
    )  # fmt: skip
    fingerprint = hashlib.sha256(body).hexdigest()[:32].encode()
    length = HEADER.size + len(body)
    data = HEADER.pack(MAGIC, 0, *counts, guid.encode(), fingerprint, length) + body
    checksum = zlib.crc32(data[_BEFORE_CHECKED:]).to_bytes(4, "little")
    return MAGIC + checksum + data[_BEFORE_CHECKED:]


class _Reader:
    """Takes parts off the bytes of a model, from the header on."""

    def __init__(self, data: bytes) -> None:
        self._data, self._at = data, HEADER.size
        self._texts = b""

    def numbers(self, code: str, count: int) -> array:
        """Take numbers, and what fills them to 8 bytes."""
        values = array(code)
        values.frombytes(self._part(count * values.itemsize))
        if sys.byteorder == "big":
            values.byteswap()
        return values

    def records(self, record: struct.Struct, count: int) -> list[tuple]:
        """Take records."""
        return [*record.iter_unpack(self._part(count * record.size))]

    def texts(self, count: int) -> None:
        """Take the texts that `text` finds."""
        self._texts = self._part(count)

    def rest(self) -> dict[str, Any]:
        """Take what only Python reads."""
        return json.loads(self._data[self._at :])

    def _part(self, size: int) -> bytes:
        part = self._data[self._at : self._at + size]
        self._at += size + -size % 8
        return part

    def text(self, at: int) -> str:
        """Return the text that begins at a place."""
        return self._texts[at : self._texts.index(0, at)].decode()

    def words(self, at: int) -> list[str]:
        """Return the words that begin at a place."""
        return self._texts[at : self._texts.index(b"\0\0", at)].decode().split("\0")

    def variable(self, record: tuple, description: str) -> Variable:
        """Return a variable from its record."""
        from .model import Variable

        name, unit, kind_of_value, causality, variability, kind, place, *numbers = record
        start, low, high, _, flags, words = numbers
        value_type, option = TYPES[kind_of_value], KINDS[kind] == "option"
        if value_type == "String":
            start = self.words(words)[int(start)]
        elif value_type == "Boolean":
            start = bool(start)
        return Variable(
            self.text(name), value_type, CAUSALITIES[causality], VARIABILITIES[variability],
            self.text(unit), description, start if flags & HAS_START else None,
            low if flags & HAS_MINIMUM else None, high if flags & HAS_MAXIMUM else None,
            KINDS[kind], 0 if option else place, bool(flags & CLIPS),
        )  # fmt: skip

    def rule(self, record: tuple, location: str) -> Rule:
        """Return a rule from its record."""
        from .model import Rule

        number, relation, bound, name, message = record
        relation = RELATIONS[relation & ~OF_A_LAW]
        return Rule(number, relation, bound, location, self.text(name), self.text(message))

    def row(self, record: tuple, location: str) -> Row:
        """Return what a constraint row belongs to from its record."""
        from .model import Row

        name, detail, kind, _ = record
        return Row(location, self.text(name), ROW_KINDS[kind], self.text(detail))


def fingerprint(data: bytes) -> str:
    """Return the hash of all that a run of a model depends on, from its bytes."""
    return HEADER.unpack_from(data)[-2].decode()


def _counts(data: bytes) -> Sequence[int]:
    """Return how long the parts of a model are, after its header was checked."""
    if len(data) < HEADER.size or data[: len(MAGIC)] != MAGIC:
        raise ValueError(DAMAGED)
    _, checksum, *counts, _, _, length = HEADER.unpack_from(data)
    if length != len(data) or checksum != zlib.crc32(data[_BEFORE_CHECKED:]):
        raise ValueError(DAMAGED)
    version = (VERSION, ABI, len(SIZES), len(OFFSETS), len(TABLES), len(HEAD))
    if tuple(counts[: len(version)]) != version:
        message = "the model is of another version of holonom; build it again"
        raise ValueError(message)
    return counts[len(version) :]


def from_bytes(data: bytes) -> dict[str, Any]:
    """Return the fields of the model that `to_bytes` wrote.

    Raises
    ------
    ValueError
        When the bytes are of another version, or damaged.
    """
    counts = _counts(data)
    try:
        return _fields(data, *counts)
    except (ArithmeticError, LookupError, TypeError, ValueError, struct.error) as error:
        raise ValueError(DAMAGED) from error  # with a good checksum: made so


def _fields(
    data: bytes, n_ints: int, n_numbers: int, n_variables: int, n_rules: int, n_rows: int,
    n_sampled: int, n_text: int,
) -> dict[str, Any]:  # fmt: skip
    from .model import Experiment

    reader = _Reader(data)
    ints, head = reader.numbers("i", n_ints), reader.numbers("d", len(HEAD))
    numbers = reader.numbers("d", n_numbers)
    variables = reader.records(VARIABLE, n_variables)
    rules, rows = reader.records(RULE, n_rules), reader.records(ROW, n_rows)
    sampled = reader.numbers("I", n_sampled)
    reader.texts(n_text)
    rest = reader.rest()
    dimension = ints[SIZES.index("dim")]
    if dimension not in (2, 3):
        raise ValueError(DAMAGED)
    sizes, offsets, lengths, tables = _split(ints, len(SIZES), len(OFFSETS), len(TABLES))
    scalars: dict[str, float] = dict(zip(HEAD, head, strict=True))
    return {
        "name": rest["name"],
        "description": rest["description"],
        "sizes": dict(zip(SIZES, sizes, strict=True)),
        "tables": dict(zip(TABLES, _split(tables, *lengths)[:-1], strict=True)),
        "offsets": dict(zip(OFFSETS, offsets, strict=True)),
        "numbers": numbers,
        "variables": tuple(map(reader.variable, variables, rest["variables"])),
        "rules": tuple(map(reader.rule, rules, rest["rules"])),
        "rows": tuple(map(reader.row, rows, rest["rows"])),
        "forces": rest["forces"],
        "sampled": tuple(map(reader.text, sampled)),
        "settings": {name: decode(name, scalars) for name in DEFAULTS},
        "experiment": Experiment(*rest["experiment"]),
    }


def _split(values: array, *lengths: int) -> list[array]:
    """Return consecutive pieces, and what is left."""
    pieces, at = [], 0
    for length in lengths:
        pieces.append(values[at : at + length])
        at += length
    return [*pieces, values[at:]]
