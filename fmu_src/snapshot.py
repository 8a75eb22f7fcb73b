"""Bytes of an FMU state: a version mark, what the slave remembers, the integrator's whole State.

    mark | phase, assembled, status, start time | size of the refusals | refusals (JSON)
    State | CRC-32 of all

The integrator's part is taken and given back untouched, so a restored run repeats bit for bit.
"""

from __future__ import annotations

import json
import math
import struct
import zlib
from collections import namedtuple

from .status import PHASES

MARK = b"HOLFMU\x00\x03"  # the last byte is the version of this format
_HEAD = struct.Struct("<8sB?idI")
_CHECKSUM = struct.Struct("<I")


class SnapshotError(Exception):
    """The bytes are no state of this format."""


class Memory(namedtuple("Memory", "phase assembled status start_time refusals")):
    """What a slave remembers besides its integrator.

    Attributes
    ----------
    phase, status : int
    assembled : bool
    start_time : float or None
    refusals : dict of int or str to str
        What was refused, a value reference or a word, and why.
    """

    __slots__ = ()


def pack(memory: Memory, state: bytes) -> bytes:
    """Bytes that `unpack` takes apart again; equal arguments give equal bytes."""
    *numbers, start, refusals = memory
    text = json.dumps(refusals).encode()
    start = math.nan if start is None else start
    data = _HEAD.pack(MARK, *numbers, start, len(text)) + text + state
    return data + _CHECKSUM.pack(zlib.crc32(data))


def unpack(data: bytes) -> tuple[Memory, bytes]:
    """What `pack` was given, checked, so that taking it over cannot fail.

    Raises
    ------
    SnapshotError
        If the bytes do not start with this version's mark, or are not what `pack` writes.
    """
    if data[: len(MARK)] != MARK:
        text = "the bytes are no FMU state of this version; save the state again with this FMU"
        raise SnapshotError(text)
    content, checksum = data[: -_CHECKSUM.size], data[-_CHECKSUM.size :]
    if len(content) >= _HEAD.size and _CHECKSUM.pack(zlib.crc32(content)) == checksum:
        _, phase, assembled, status, start, length = _HEAD.unpack_from(content)
        end = _HEAD.size + length
        said = json.loads(content[_HEAD.size : end])
        if phase in PHASES and not math.isinf(start) and isinstance(said, dict):
            refusals = {int(k) if k.isdecimal() else k: str(why) for k, why in said.items()}
            start = None if math.isnan(start) else start
            return Memory(phase, assembled, status, start, refusals), content[end:]
    text = "the bytes of the FMU state are damaged; save the state again"
    raise SnapshotError(text)
