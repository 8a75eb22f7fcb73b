"""Bytes of an FMU state: a version mark, what the slave remembers, the integrator's whole State.

    mark | CRC-32 of all that follows | memory as JSON in one line | State

The integrator's part is taken and given back untouched, so a restored run repeats bit for bit.
"""

from __future__ import annotations

import json
import math
import zlib
from collections import namedtuple

from .status import PHASES

MARK = b"HOLFMU\x00\x04"  # the last byte is the version of this format


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
    data = json.dumps(memory).encode() + b"\n" + state
    return MARK + zlib.crc32(data).to_bytes(4, "little") + data


def unpack(data: bytes) -> tuple[Memory, bytes]:
    """What `pack` was given, checked, so that taking it over cannot fail.

    Raises
    ------
    SnapshotError
        If the bytes do not start with this version's mark, or are not what `pack` writes.
    """
    if not data.startswith(MARK):
        text = "the bytes are no FMU state of this version; save the state again with this FMU"
        raise SnapshotError(text)
    content = data[len(MARK) + 4 :]
    if content and zlib.crc32(content).to_bytes(4, "little") == data[len(MARK) :][:4]:
        head, _, state = content.partition(b"\n")
        phase, assembled, status, start, said = json.loads(head)
        if phase in PHASES and math.isfinite(start or 0.0) and isinstance(said, dict):
            refusals = {int(k) if k.isdecimal() else k: str(why) for k, why in said.items()}
            return Memory(phase, assembled, status, start, refusals), state
    text = "the bytes of the FMU state are damaged; save the state again"
    raise SnapshotError(text)
