"""The bytes of a model, as ``solver/kernel/model_file.h`` lays them out: read here.

``model_writing`` writes them.

header | int32 | doubles | variables | rules | rows | sampled | texts | JSON. The core uses all but
the JSON where it lies; that has what only Python reads: descriptions and places in the scene.
"""

from __future__ import annotations

import json
import struct
import sys
import zlib
from array import array
from collections.abc import Sequence

from . import layout

TYPE_CHECKING = False  # typing's own would be imported with the FMU, for nothing
if TYPE_CHECKING:
    from typing import Any

    from .model import Row, Rule, Variable

MAGIC = b"HOLONOM\0"
HEADER, VARIABLE, RULE, ROW = (
    struct.Struct("<" + "".join(fields.values()))
    for fields in (layout.HEADER, layout.VARIABLE, layout.RULE, layout.ROW)
)
BEFORE_CHECKED = struct.calcsize("<8sI")

DAMAGED = "the model is damaged, or of an earlier version; build it again"


class _ModelBytes:
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

        name, unit, *codes, place, start, low, high, _, flags, words = record
        value_type, causality, variability, kind = (
            known[code] for known, code in zip(layout.WORDS.values(), codes, strict=True)
        )
        given = {flag for flag, bit in layout.FLAGS.items() if flags & bit}
        if value_type == "String":
            start = self.words(words)[int(start)]
        elif value_type == "Boolean":
            start = bool(start)
        return Variable(
            self.text(name), value_type, causality, variability, self.text(unit), description,
            start if "has_start" in given else None, low if "has_minimum" in given else None,
            high if "has_maximum" in given else None, kind, 0 if kind == "option" else place,
            "clips" in given,
        )  # fmt: skip

    def rule(self, record: tuple, location: str) -> Rule:
        """Return a rule from its record."""
        from .model import Rule

        number, relation, bound, name, message = record
        relation = [*layout.RELATIONS][relation & ~layout.OF_A_LAW]
        return Rule(number, relation, bound, location, self.text(name), self.text(message))

    def row(self, record: tuple, location: str) -> Row:
        """Return what a constraint row belongs to from its record."""
        from .model import Row

        name, detail, kind, _ = record
        return Row(location, self.text(name), layout.ROW_KINDS[kind], self.text(detail))


def fingerprint(data: bytes) -> str:
    """Return the hash of all that a run of a model depends on, from its bytes."""
    return HEADER.unpack_from(data)[-2].decode()


def _counts(data: bytes) -> Sequence[int]:
    """Return how long the parts of a model are, after its header was checked."""
    if len(data) < HEADER.size or data[: len(MAGIC)] != MAGIC:
        raise ValueError(DAMAGED)
    _, checksum, *counts, _, _, length = HEADER.unpack_from(data)
    if length != len(data) or checksum != zlib.crc32(data[BEFORE_CHECKED:]):
        raise ValueError(DAMAGED)
    if counts[0] != layout.ABI:
        message = "the model is of another version of holonom; build it again"
        raise ValueError(message)
    return counts[1:]


def from_bytes(data: bytes) -> dict[str, Any]:
    """Return the fields of the model that `model_writing.to_bytes` wrote.

    Raises
    ------
    ValueError
        When the bytes are of another version, or damaged.
    """
    counts = _counts(data)
    try:
        return _fields(data, *counts)
    except (ArithmeticError, LookupError, TypeError, ValueError, struct.error) as error:
        raise ValueError(DAMAGED) from error  # though its checksum is right


def _fields(
    data: bytes, n_ints: int, n_numbers: int, n_variables: int, n_rules: int, n_rows: int,
    n_sampled: int, n_text: int,
) -> dict[str, Any]:  # fmt: skip
    from .model import Experiment

    reader = _ModelBytes(data)
    ints = reader.numbers("i", n_ints)
    reader.numbers("d", len(layout.HEAD))  # the core's: a state at the start of a run
    numbers = reader.numbers("d", n_numbers)
    variables = reader.records(VARIABLE, n_variables)
    rules, rows = reader.records(RULE, n_rules), reader.records(ROW, n_rows)
    sampled = reader.numbers("I", n_sampled)
    reader.texts(n_text)
    rest = reader.rest()
    dimension = ints[layout.SIZES.index("dim")]
    if dimension not in (2, 3):
        raise ValueError(DAMAGED)
    groups = layout.SIZES, layout.OFFSETS, layout.TABLES
    sizes, offsets, lengths, tables = _split(ints, *map(len, groups))
    read = tuple(map(reader.variable, variables, rest["variables"]))
    return {
        "name": rest["name"],
        "description": rest["description"],
        "sizes": dict(zip(layout.SIZES, sizes, strict=True)),
        "tables": dict(zip(layout.TABLES, _split(tables, *lengths)[:-1], strict=True)),
        "offsets": dict(zip(layout.OFFSETS, offsets, strict=True)),
        "numbers": numbers,
        "variables": read,
        "rules": tuple(map(reader.rule, rules, rest["rules"])),
        "rows": tuple(map(reader.row, rows, rest["rows"])),
        "forces": rest["forces"],
        "sampled": tuple(map(reader.text, sampled)),
        "settings": {
            variable.name.removeprefix("solver."): variable.start
            for variable in read
            if variable.kind == "option"
        },
        "experiment": Experiment(*rest["experiment"]),
    }


def _split(values: array, *lengths: int) -> list[array]:
    """Return consecutive pieces, and what is left."""
    pieces, at = [], 0
    for length in lengths:
        pieces.append(values[at : at + length])
        at += length
    return [*pieces, values[at:]]
