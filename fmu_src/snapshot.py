"""Bytes of an FMU state: a version mark, what the slave remembers, the integrator's whole State.

    mark (8) | length of the header (4, little-endian) | header (JSON) | State | CRC-32 of all (4)

The integrator's part is taken and given back untouched, so a restored run repeats bit for bit.
"""

from __future__ import annotations

import json
import math
import struct
import zlib
from collections import namedtuple

MARK = b"HOLFMU\x00\x02"  # the last byte is the version of this format
_NUMBER = struct.Struct("<I")


class SnapshotError(Exception):
    """The bytes are no state of this format."""


class Memory(namedtuple("Memory", "phase start_time assembled status refusals")):
    """What a slave remembers besides its integrator.

    Attributes
    ----------
    phase, status : int
    start_time : float or None
    assembled : bool
    refusals : dict of int or str to str
        What was refused, a value reference or a word, and why.
    """

    __slots__ = ()


def memory(header: object, phases: tuple[int, ...]) -> Memory:
    """Contents of a header, checked, so that taking them over cannot fail.

    Raises
    ------
    SnapshotError
        If the header lacks something, or a part of it has another type than `pack` was given.
    """
    if isinstance(header, dict) and set(header) == set(Memory._fields):
        found = Memory(**header)
        if (
            _is_whole(found.phase)
            and found.phase in phases
            and _is_time(found.start_time)
            and isinstance(found.assembled, bool)
            and _is_whole(found.status)
            and isinstance(found.refusals, list)
            and all(_is_refusal(entry) for entry in found.refusals)
        ):
            return found._replace(refusals=dict(found.refusals))
    text = "the header of the FMU state is damaged; save the state again"
    raise SnapshotError(text)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _is_time(value: object) -> bool:
    if value is None or isinstance(value, bool):
        return value is None
    return isinstance(value, int | float) and math.isfinite(value)


def _is_refusal(entry: object) -> bool:
    if not isinstance(entry, list) or len(entry) != 2:
        return False
    what, why = entry
    return (_is_whole(what) or isinstance(what, str)) and isinstance(why, str)


def pack(header: dict[str, object], state: bytes) -> bytes:
    """Bytes that `unpack` takes apart again; equal arguments give equal bytes."""
    text = json.dumps(header, sort_keys=True).encode()
    data = b"".join((MARK, _NUMBER.pack(len(text)), text, state))
    return data + _NUMBER.pack(zlib.crc32(data))


def unpack(data: bytes) -> tuple[dict, bytes]:
    """Header and State of what `pack` wrote.

    Raises
    ------
    SnapshotError
        If the bytes do not start with this version's mark, or their checksum does not fit.
    """
    if data[: len(MARK)] != MARK:
        text = "the bytes are no FMU state of this version; save the state again with this FMU"
        raise SnapshotError(text)
    content, checksum = data[: -_NUMBER.size], data[-_NUMBER.size :]
    start = len(MARK) + _NUMBER.size
    if len(content) < start or _NUMBER.pack(zlib.crc32(content)) != checksum:
        text = "the bytes of the FMU state are damaged; save the state again"
        raise SnapshotError(text)
    (length,) = _NUMBER.unpack_from(content, len(MARK))
    return json.loads(content[start : start + length]), content[start + length :]
