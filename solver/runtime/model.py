"""A model: the structure of a mechanism as integers, and one vector of numbers.

    M (v_1 - v_n) + h [ Gm' mu + dU - Q ] = 0,   (v_n + v_1)/2 = (q_1 - q_n)/h,   Phi(q_1) = 0

Every term is a function of forms s = u . w of the nodes (``solver/kernel/holonom.h``). Names appear
only in `variables`, `rules` and `rows`: they were turned into indices when the model was
assembled. A model is the only thing that assembly and kernel share, and what travels in an FMU.

Symbols: q coordinates, v velocities, M mass matrix, Phi constraint rows, G their Jacobian, lambda
multipliers held fixed in the inner iteration, mu total multipliers, alpha penalties, h step.

Records are named tuples: `dataclasses` and `typing` would double the time to import the FMU's code.
"""

from __future__ import annotations

import json
import sys
import zlib
from array import array
from collections import namedtuple
from functools import cached_property

from .errors import UnknownNameError
from .layout import OFFSETS, SIZES, TABLES

FORMAT = 4
"""Version of the byte format of a model."""


class Variable(
    namedtuple(
        "Variable",
        "name type causality variability unit description start minimum maximum kind place clips",
        defaults=("", "", None, None, None, "measured", 0, False),
    )
):
    """A named quantity that a user reads or sets.

    Attributes
    ----------
    name, unit, description : str
    type : {"Real", "String", "Boolean"}
    causality : {"parameter", "calculatedParameter", "input", "output"}
    variability : {"fixed", "tunable", "continuous"}
    start : float, str, bool or None
        Value at the beginning of a parameter or input.
    minimum, maximum : float or None
    kind, place
        Where it lies: "parameter", "input" (in the state), "number" (in the vector of numbers),
        "measured" (behind the offset of the measurements) or "option"; and the index there.
    clips : bool
        Whether a value beyond minimum or maximum is the limit instead of an error.
    """

    __slots__ = ()


class Rule(namedtuple("Rule", "number relation bound location name message")):
    """A condition that is checked whenever the mechanism is assembled.

    Attributes
    ----------
    number : int
        Place in the vector of numbers.
    relation : {">", ">=", "finite"}
        Against `bound`.
    bound : float
    location, name : str
        Where it stands in the scene, ``bodies.rod``, and what it is called in a sentence.
    message : str
        What is said when it does not hold, with ``{value}``.
    """

    __slots__ = ()

    def holds(self, value: float) -> bool:
        """Whether `value` keeps the rule; NaN never does."""
        if self.relation == "finite":
            return abs(value) < float("inf")
        return value > self.bound if self.relation == ">" else value >= self.bound


class Row(namedtuple("Row", "location name kind detail", defaults=("",))):
    """What a constraint row belongs to, for what is said when the drawn mechanism contradicts it.

    Attributes
    ----------
    location, name : str
        Where the part stands in the scene, ``joints.bearing``, and what it is called in a sentence.
    kind, detail : str
        Which of the sentences of ``assembly_checks``, and what stands in it, such as the bodies.
    """

    __slots__ = ()


class Experiment(
    namedtuple(
        "Experiment", "start_time stop_time step_size tolerance", defaults=(0.0, 1.0, 0.1, None)
    )
):
    """Default run: start and stop time and communication step [s]; relative tolerance or None."""

    __slots__ = ()


class Model(
    namedtuple(
        "Model",
        "name description sizes tables offsets numbers variables rules rows forces sampled "
        "settings experiment",
    )
):
    """Structure and numbers of a mechanism; never modified.

    Attributes
    ----------
    name, description : str
    sizes : mapping of str to int
        As in ``layout.SIZES``.
    tables : mapping of str to array of int
        As in ``layout.TABLES``.
    offsets : mapping of str to int
        As in ``layout.OFFSETS``.
    numbers : array of float
    variables : tuple of Variable
    rules : tuple of Rule
    rows : tuple of Row
        What each constraint row belongs to, in the order of the multipliers.
    forces : mapping of str to str
        Type of each force of the scene, by name, such as "torsion_damper".
    sampled : tuple of str
        What each load that reads the mechanism is called in a sentence.
    settings : mapping of str to float, str or bool
        Of the solver, as in ``options.DEFAULTS``.
    experiment : Experiment
    """

    @cached_property
    def fingerprint(self) -> str:
        """Hash of all that a run depends on."""
        import hashlib  # only where states are saved or archives built: it loads OpenSSL

        return hashlib.sha256(self.to_bytes()).hexdigest()[:32]

    @property
    def row_names(self) -> tuple[str, ...]:
        """What each constraint row is called in a sentence, ``joint 'bearing'``."""
        return tuple(row.name for row in self.rows)

    @cached_property
    def _places(self) -> dict[str, int]:
        return {variable.name: index for index, variable in enumerate(self.variables)}

    def index(self, name: str) -> int:  # type: ignore[override]
        """Return the index of a variable; `UnknownNameError` if there is none of that name."""
        if name not in self._places:
            raise UnknownNameError(name, self._places)
        return self._places[name]

    def to_bytes(self) -> bytes:
        """Return the model as bytes: a JSON header, the raw arrays, CRC-32; little-endian.

        The same model gives the same bytes.
        """
        assert tuple(self.sizes) == SIZES
        assert tuple(self.tables) == TABLES
        assert tuple(self.offsets) == OFFSETS
        header = {
            "format": FORMAT,
            **{name: value for name, value in self._asdict().items() if name != "numbers"},
            "tables": {name: len(table) for name, table in self.tables.items()},
            "numbers": len(self.numbers),
        }
        text = json.dumps(header, separators=(",", ":")).encode()
        blocks = [_little_endian(table) for table in (*self.tables.values(), self.numbers)]
        data = b"".join([len(text).to_bytes(8, "little"), text, *blocks])
        return data + zlib.crc32(data).to_bytes(4, "little")

    @staticmethod
    def from_bytes(data: bytes) -> Model:
        """Return the model that `to_bytes` wrote.

        Raises
        ------
        ValueError
            When the bytes are of another format version, or damaged.
        """
        # Indices of the tables steer the kernel, which does not check them.
        data, checksum = data[:-4], data[-4:]
        if zlib.crc32(data).to_bytes(4, "little") != checksum:
            message = "the model is damaged, or of an earlier version; build it again"
            raise ValueError(message)
        length = int.from_bytes(data[:8], "little")
        header = json.loads(data[8 : 8 + length])
        names = [tuple(header[group]) for group in ("sizes", "tables", "offsets")]
        if header.pop("format") != FORMAT or names != [SIZES, TABLES, OFFSETS]:
            message = "the model is of another version of holonom; build it again"
            raise ValueError(message)
        position = 8 + length
        for name, count in header["tables"].items():
            header["tables"][name], position = _from_little_endian("i", count, data, position)
        header["numbers"], _ = _from_little_endian("d", header["numbers"], data, position)
        header["variables"] = tuple(Variable(*row) for row in header["variables"])
        header["rules"] = tuple(Rule(*row) for row in header["rules"])
        header["rows"] = tuple(Row(*row) for row in header["rows"])
        header["sampled"] = tuple(header["sampled"])
        header["experiment"] = Experiment(*header["experiment"])
        return Model(**header)


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
