"""A model: the structure of a mechanism as integers, and one vector of numbers.

    M (v_1 - v_n) + h [ Gm' mu + dU - Q ] = 0,   (v_n + v_1)/2 = (q_1 - q_n)/h,   Phi(q_1) = 0

Every term is a function of forms s = u . w of the nodes (``solver/kernel/holonom.h``). Names appear
only in `variables`, `rules` and `row_names`: they were turned into indices when the model was
assembled. A model is the only thing that assembly and kernel share, and what travels in an FMU.

Symbols: q coordinates, v velocities, M mass matrix, Phi constraint rows, G their Jacobian, lambda
multipliers held fixed in the inner iteration, mu total multipliers, alpha penalties, h step.
"""

from __future__ import annotations

import hashlib
import json
import sys
from array import array
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

from .layout import OFFSETS, SIZES, TABLES

FORMAT = 1
"""Version of the byte format of a model."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Variable:
    """A named quantity that a user reads or sets.

    `kind` and `place` say where it lies: "parameter", "input" (in the state), "number" (in the
    vector of numbers), "measured" (behind the offset of the measurements) or "option".
    """

    name: str
    type: str
    causality: str
    variability: str
    unit: str = ""
    description: str = ""
    start: float | str | bool | None = None
    minimum: float | None = None
    maximum: float | None = None
    kind: str = "measured"
    place: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Rule:
    """A condition on a number that is checked whenever the mechanism is assembled.

    `relation` is ">", ">=" (against `bound`) or "finite"; `message` says what, with ``{value}``.
    """

    number: int
    relation: str
    bound: float
    message: str

    def holds(self, value: float) -> bool:
        """Whether `value` keeps the rule; NaN never does."""
        if self.relation == "finite":
            return abs(value) < float("inf")
        return value > self.bound if self.relation == ">" else value >= self.bound


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment:
    """Default run: times in s, relative tolerance or None."""

    start_time: float = 0.0
    stop_time: float = 1.0
    step_size: float = 0.1
    tolerance: float | None = None


Record = TypeVar("Record", Variable, Rule, Experiment)


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """Structure and numbers of a mechanism; never modified."""

    name: str
    description: str
    sizes: Mapping[str, int]
    tables: Mapping[str, array]
    offsets: Mapping[str, int]
    numbers: array
    variables: tuple[Variable, ...]
    rules: tuple[Rule, ...]
    row_names: tuple[str, ...]
    settings: Mapping[str, float | str | bool]
    experiment: Experiment
    fingerprint: str = field(default="", compare=False)
    _places: dict[str, int] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Take the fingerprint: the hash of all that a run depends on."""
        assert tuple(self.sizes) == SIZES
        assert tuple(self.tables) == TABLES
        assert tuple(self.offsets) == OFFSETS
        if not self.fingerprint:
            object.__setattr__(self, "fingerprint", _hash(self.to_bytes()))

    def index(self, name: str) -> int:
        """Return the index of a variable; raises KeyError if there is none of that name."""
        if not self._places:
            self._places.update((v.name, index) for index, v in enumerate(self.variables))
        return self._places[name]

    def to_bytes(self) -> bytes:
        """Return the model as bytes: a JSON header, then the raw arrays, little-endian.

        The same model gives the same bytes.
        """
        header = {
            "format": FORMAT,
            "name": self.name,
            "description": self.description,
            "sizes": dict(self.sizes),
            "offsets": dict(self.offsets),
            "tables": {name: len(table) for name, table in self.tables.items()},
            "numbers": len(self.numbers),
            "variables": [_row(variable) for variable in self.variables],
            "rules": [_row(rule) for rule in self.rules],
            "row_names": list(self.row_names),
            "settings": dict(self.settings),
            "experiment": _row(self.experiment),
        }
        text = json.dumps(header, separators=(",", ":")).encode()
        blocks = [_little_endian(table) for table in (*self.tables.values(), self.numbers)]
        return b"".join([len(text).to_bytes(8, "little"), text, *blocks])

    @staticmethod
    def from_bytes(data: bytes) -> Model:
        """Return the model that `to_bytes` wrote.

        Raises
        ------
        ValueError
            When the bytes are of another format version, or cut off.
        """
        length = int.from_bytes(data[:8], "little")
        header = json.loads(data[8 : 8 + length])
        if header["format"] != FORMAT:
            message = f"model of format {header['format']}, this code reads format {FORMAT}"
            raise ValueError(message)
        position, tables = 8 + length, {}
        for name, count in header["tables"].items():
            tables[name], position = _from_little_endian("i", count, data, position)
        numbers, position = _from_little_endian("d", header["numbers"], data, position)
        if position != len(data):
            message = f"model is {len(data)} bytes long, its header says {position}"
            raise ValueError(message)
        return Model(
            name=header["name"],
            description=header["description"],
            sizes=header["sizes"],
            tables=tables,
            offsets=header["offsets"],
            numbers=numbers,
            variables=tuple(_from_row(Variable, row) for row in header["variables"]),
            rules=tuple(_from_row(Rule, row) for row in header["rules"]),
            row_names=tuple(header["row_names"]),
            settings=header["settings"],
            experiment=_from_row(Experiment, header["experiment"]),
            fingerprint=_hash(data),
        )


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:32]


def _row(record: Variable | Rule | Experiment) -> list[Any]:
    return [getattr(record, part.name) for part in fields(record)]


def _from_row(kind: type[Record], row: Sequence[Any]) -> Record:
    return kind(**dict(zip((part.name for part in fields(kind)), row, strict=True)))


def _little_endian(values: array) -> bytes:
    if sys.byteorder == "big":
        values = array(values.typecode, values)
        values.byteswap()
    return values.tobytes()


def _from_little_endian(code: str, count: int, data: bytes, position: int) -> tuple[array, int]:
    values = array(code)
    end = position + count * values.itemsize
    values.frombytes(data[position:end])
    if sys.byteorder == "big":
        values.byteswap()
    return values, end
