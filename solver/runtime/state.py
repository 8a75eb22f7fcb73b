"""The state: all that survives from one step to the next, in one block of doubles."""

from __future__ import annotations

import ctypes
import math
import struct
import zlib
from collections.abc import Iterator, Mapping

from .errors import OptionError
from .layout import ENDLESS, HEAD, PLACE, state_sections
from .model import Model

MAGIC = b"holonom4"
"""Begins every saved state; the digit is the version of its format."""

PHASES = CONFIGURED, ASSEMBLED, MOVING = 0, 1, 2
"""Of a run: values may change; initial configuration taken; at least one step done."""

_PREFIX = struct.Struct("<8s32sqq")
_CHECKSUM = struct.Struct("<I")
"""CRC-32 of prefix and block; it stands between them."""

_START = _PREFIX.size + _CHECKSUM.size

_ENDLESS = {PLACE[name] for name in ENDLESS}


class Head(Mapping[str, float]):
    """The scalars at the head of a state, by name."""

    def __init__(self, block: ctypes.Array[ctypes.c_double]) -> None:
        self._block = block

    def __getitem__(self, name: str) -> float:
        """Return a scalar."""
        return self._block[PLACE[name]]

    def __setitem__(self, name: str, value: float) -> None:
        """Set a scalar."""
        self._block[PLACE[name]] = value

    def __iter__(self) -> Iterator[str]:
        """Names in their order in memory."""
        return iter(HEAD)

    def __len__(self) -> int:
        """Return the number of scalars."""
        return len(HEAD)


class State:
    """Named views of a state's block; writing to them writes the state.

    `head` maps names to scalars, `vectors` those of ``layout.state_sections`` to memory views of
    doubles, which `numpy.asarray` shares.
    """

    def __init__(self, model: Model, block: ctypes.Array[ctypes.c_double]) -> None:
        self.block = block
        self.head = Head(block)
        view: memoryview[float] = memoryview(block).cast("B").cast("d")
        self.vectors: dict[str, memoryview[float]] = {
            name: view[start : start + length]
            for name, (start, length) in state_sections(model.sizes).items()
        }
        self._model = model

    def to_bytes(self, phase: int) -> bytes:
        """Return the whole state and the phase of the run, bit for bit."""
        prefix = _PREFIX.pack(MAGIC, self._model.fingerprint.encode(), phase, len(self.block))
        block = bytes(self.block)
        return prefix + _CHECKSUM.pack(zlib.crc32(block, zlib.crc32(prefix))) + block

    def phase_of(self, data: bytes) -> int:
        """Check that `data` is a state of this model and return its phase.

        Raises
        ------
        OptionError
            When it is not, was cut off or changed, or has a number that is not finite.
        """
        if len(data) < _START or data[:8] != MAGIC:
            message = "the saved state is not one of this format; save it again with this FMU"
            raise OptionError(message)
        _, fingerprint, phase, length = _PREFIX.unpack_from(data)
        if fingerprint != self._model.fingerprint.encode():
            message = "the saved state belongs to another model; restore it where it was saved"
            raise OptionError(message)
        if len(data) != _START + 8 * length or length != len(self.block):
            message = f"the saved state is {len(data)} bytes long, not what its header says"
            raise OptionError(message)
        # Counters and indices of the block steer the kernel, which does not check them again.
        (checksum,) = _CHECKSUM.unpack_from(data, _PREFIX.size)
        found = zlib.crc32(data[_START:], zlib.crc32(data[: _PREFIX.size]))
        if found != checksum or phase not in PHASES:
            message = "the saved state is damaged: its checksum does not fit; save it again"
            raise OptionError(message)
        numbers: memoryview[float] = memoryview(data)[_START:].cast("d")
        strange = [place for place, number in enumerate(numbers) if not abs(number) < math.inf]
        if any(place not in _ENDLESS or numbers[place] != math.inf for place in strange):
            message = "the saved state has a number that is not finite; save it again"
            raise OptionError(message)
        return phase

    def fill(self, data: bytes) -> None:
        """Take over the block that `to_bytes` wrote."""
        ctypes.memmove(self.block, data[_START:], 8 * len(self.block))
