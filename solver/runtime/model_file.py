"""The bytes of a model, as ``solver/kernel/run/model_file.h`` lays them out: read here.

``model_writing`` writes them.

header | int32 | doubles | variables | rules | rows | names | texts | JSON. The core uses all but
the JSON where it lies; that has what only Python reads: descriptions and places in the scene.
"""

from __future__ import annotations

import json
import struct
import sys
import zlib
from array import array
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import layout

if TYPE_CHECKING:
    from .model import Row, Rule, Variable

MAGIC = b"HOLONOM\0"
HEADER, VARIABLE, RULE, ROW = (
    struct.Struct("<" + "".join(fields.values()))
    for fields in (layout.HEADER, layout.VARIABLE, layout.RULE, layout.ROW)
)
BEFORE_CHECKED = struct.calcsize("<8sI")

DAMAGED = "the model is damaged, or of an earlier version; build it again"


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
    n_names: int, n_text: int,
) -> dict[str, Any]:  # fmt: skip
    from .model import Experiment, Row, Rule, Variable

    ints, _, numbers, variables, rules, rows, names, texts, rest = _split(
        data[HEADER.size :], 4 * n_ints, 8 * len(layout.HEAD), 8 * n_numbers,
        VARIABLE.size * n_variables, RULE.size * n_rules, ROW.size * n_rows, 4 * n_names, n_text,
    )  # fmt: skip
    told = json.loads(rest)  # what only Python reads
    groups = map(len, (layout.SIZES, layout.OFFSETS, layout.TABLES))
    sizes, offsets, lengths, tables = _pieces(_array("i", ints), *groups)

    def text(at: int, end: bytes = b"\0") -> str:
        return texts[at : texts.index(end, at)].decode()

    def variable(record: tuple, description: str) -> Variable:
        name, unit, *codes, place, start, low, high, _, flags, words = record
        value_type, causality, variability, kind = (
            known[code] for known, code in zip(layout.WORDS.values(), codes, strict=True)
        )
        given = {flag for flag, bit in layout.FLAGS.items() if flags & bit}
        if value_type == "String":
            start = text(words, b"\0\0").split("\0")[int(start)]
        elif value_type == "Boolean":
            start = bool(start)
        return Variable(
            text(name), value_type, causality, variability, text(unit), description,
            start if "has_start" in given else None, low if "has_minimum" in given else None,
            high if "has_maximum" in given else None, kind, 0 if kind == "option" else place,
            "clips" in given, told.get("display_units", {}).get(text(name), ""),
        )  # fmt: skip

    def rule(record: tuple, location: str) -> Rule:
        number, relation, bound, name, message = record
        relation = [*layout.RELATIONS][relation & ~layout.OF_A_LAW]
        return Rule(number, relation, bound, location, text(name), text(message))

    def row(record: tuple, location: str) -> Row:
        name, detail, kind, _ = record
        return Row(location, text(name), layout.ROW_KINDS[kind], text(detail))

    if sizes[layout.SIZES.index("dim")] not in (2, 3):
        raise ValueError(DAMAGED)
    read = tuple(map(variable, VARIABLE.iter_unpack(variables), told["variables"]))
    said, n_sampled = tuple(map(text, _array("I", names))), sizes[layout.SIZES.index("n_sampled")]
    return {
        "name": told["name"],
        "description": told["description"],
        "sizes": dict(zip(layout.SIZES, sizes, strict=True)),
        "tables": dict(zip(layout.TABLES, _pieces(tables, *lengths)[:-1], strict=True)),
        "offsets": dict(zip(layout.OFFSETS, offsets, strict=True)),
        "numbers": _array("d", numbers),
        "variables": read,
        "rules": tuple(map(rule, RULE.iter_unpack(rules), told["rules"])),
        "rows": tuple(map(row, ROW.iter_unpack(rows), told["rows"])),
        "forces": told["forces"],
        "meshes": told["meshes"],
        "sampled": said[:n_sampled],
        "switches": said[n_sampled:],
        "settings": {
            known.name.removeprefix("solver."): known.start
            for known in read
            if known.kind == "option"
        },
        "experiment": Experiment(*told["experiment"]),
    }


def _split(data: bytes, *sizes: int) -> list[bytes]:
    """Return the parts of a model, each filled to 8 bytes, and what is left."""
    parts, at = [], 0
    for size in sizes:
        parts.append(data[at : at + size])
        at += size + -size % 8
    return [*parts, data[at:]]


def _array(code: str, data: bytes) -> array:
    values = array(code, data)
    if sys.byteorder == "big":
        values.byteswap()
    return values


def _pieces(values: array, *lengths: int) -> list[array]:
    """Return consecutive pieces, and what is left."""
    pieces, at = [], 0
    for length in lengths:
        pieces.append(values[at : at + length])
        at += length
    return [*pieces, values[at:]]
