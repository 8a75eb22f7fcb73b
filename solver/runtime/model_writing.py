"""Writes the bytes of a model, laid out as in ``solver/kernel/run/model_file.h``; not for a run."""

from __future__ import annotations

import hashlib
import json
import struct
import sys
import zlib
from array import array
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from itertools import accumulate

from solver.options import OPTIONS, Option

from . import layout
from .errors import OptionError
from .model import Model, Rule, Variable
from .model_file import BEFORE_CHECKED, HEADER, MAGIC, ROW, RULE, VARIABLE


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


def _option(variable: Variable) -> Option:
    return OPTIONS[variable.name.removeprefix("solver.")]


def _words(option: Option) -> str:
    """Return what an option must be, one word behind the other; an empty one ends them."""
    return "".join(f"{word}\0" for word in option.words or (option.rule,))


def _texts(model: Model) -> Iterator[str]:
    """Yield the texts of a model in their order."""
    yield ""
    for variable in model.variables:
        if variable.kind == "option":
            yield _words(_option(variable))
        yield variable.name
        yield variable.unit
    for rule in model.rules:
        yield rule.name
        yield rule.message
    for row in model.rows:
        yield row.name
        yield row.detail
    yield from model.sampled
    yield from model.switches


@cache
def _codes(*kinds: str) -> list[int]:
    """Return the numbers for the words of a variable, in the order of `layout.WORDS`."""
    return [known.index(word) for word, known in zip(kinds, layout.WORDS.values(), strict=True)]


def _record(variable: Variable, at: Mapping[str, int]) -> bytes:
    name, value, causality, variability, unit, _, start, low, high, kind, place, clips, _ = variable
    flags = (
        layout.FLAGS["has_start"] * (start is not None)
        | layout.FLAGS["has_minimum"] * (low is not None)
        | layout.FLAGS["has_maximum"] * (high is not None)
        | layout.FLAGS["clips"] * clips
    )
    least, words = 0.0, 0
    if kind == "option":
        option = _option(variable)
        start, least, words = stored(option, start), option.least, at[_words(option)]
        place = layout.PLACE[option.stored_as]
        flags |= layout.FLAGS["whole"] * option.whole | layout.FLAGS["even"] * bool(option.allowed)
    return VARIABLE.pack(
        at[name], at[unit], *_codes(value, causality, variability, kind), place,
        start or 0.0, low or 0.0, high or 0.0, least, flags, words,
    )  # fmt: skip


def _records(model: Model, at: Mapping[str, int]) -> Iterator[bytes]:
    """Yield the records of variables, rules and rows, with the places of their texts."""
    relations = {relation: code for code, relation in enumerate(layout.RELATIONS)}
    laws = rules_of_laws(model)
    for variable in model.variables:
        yield _record(variable, at)
    for rule in model.rules:
        relation = relations[rule.relation] | (layout.OF_A_LAW if rule in laws else 0)
        yield RULE.pack(rule.number, relation, rule.bound, at[rule.name], at[rule.message])
    for row in model.rows:
        kind = layout.ROW_KINDS.index(row.kind)
        yield ROW.pack(at[row.name], at[row.detail], kind, 0)


def _rest(model: Model) -> dict[str, object]:
    """Return what only Python reads."""
    shown = {x.name: x.display_unit for x in model.variables if x.display_unit}
    return {
        "name": model.name, "description": model.description, "forces": model.forces,
        "meshes": model.meshes, "experiment": model.experiment,
        "variables": [variable.description for variable in model.variables],
        **({"display_units": shown} if shown else {}),
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


def to_bytes(model: Model) -> bytes:
    """Return the bytes of a model; the same model gives the same ones."""
    assert tuple(model.sizes) == layout.SIZES
    assert tuple(model.tables) == tuple(layout.TABLES)
    assert tuple(model.offsets) == tuple(layout.OFFSETS)
    numbers = [*model.sizes.values(), *model.offsets.values(), *map(len, model.tables.values())]
    ints = array("i", numbers)
    for table in model.tables.values():
        ints += table
    at = dict.fromkeys(_texts(model), 0)
    contents = [text.encode() for text in at]
    begin = accumulate([len(content) + 1 for content in contents], initial=0)
    at.update(zip([*at], begin, strict=False))
    said = model.sampled + model.switches
    names = struct.pack(f"<{len(said)}I", *[at[name] for name in said])
    text = _filled(b"\0".join([*contents, b""]))
    body = b"".join([
        _filled(_little_endian(ints)), _little_endian(_settings(model)),
        _little_endian(model.numbers), *_records(model, at), _filled(names), text,
        _filled(json.dumps(_rest(model), separators=(",", ":")).encode(), b" "),
    ])  # fmt: skip
    counts = (
        layout.ABI, len(ints), len(model.numbers), len(model.variables), len(model.rules),
        len(model.rows), len(said), len(text),
    )  # fmt: skip
    # A saved state, too, has the layout of its version.
    fingerprint = hashlib.sha256(struct.pack("<I", layout.ABI))
    fingerprint.update(body)
    return _checked(counts, b"", fingerprint.hexdigest()[:32].encode(), body)


def with_guid(data: bytes, guid: str) -> bytes:
    """Return the bytes of a model with the GUID of the FMU that carries it.

    The fingerprint does not depend on it.
    """
    _, _, *counts, _, fingerprint, _ = HEADER.unpack_from(data)
    return _checked(counts, guid.encode(), fingerprint, data[HEADER.size :])


def _checked(counts: Sequence[int], guid: bytes, fingerprint: bytes, body: bytes) -> bytes:
    """Return the header with its checksum, and what follows."""
    known = MAGIC, 0, *counts, guid, fingerprint, HEADER.size + len(body)
    header = HEADER.pack(*known)[BEFORE_CHECKED:]
    checksum = zlib.crc32(body, zlib.crc32(header))
    return b"".join([MAGIC, checksum.to_bytes(4, "little"), header, body])
