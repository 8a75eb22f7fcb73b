"""Bytes of an FMU state: a version mark, what the slave remembers, the integrator's whole State.

    mark (8) | length of the header (4, little-endian) | header (JSON) | State

The integrator's part is taken and given back untouched, so a restored run repeats bit for bit.
"""

from __future__ import annotations

import json
import struct

MARK = b"HOLFMU\x00\x01"  # the last byte is the version of this format


class SnapshotError(Exception):
    """The bytes are no state of this format."""


def pack(header: dict[str, object], state: bytes) -> bytes:
    """Bytes that `unpack` takes apart again; equal arguments give equal bytes."""
    text = json.dumps(header, sort_keys=True).encode()
    return b"".join((MARK, struct.pack("<I", len(text)), text, state))


def unpack(data: bytes) -> tuple[dict, bytes]:
    """Header and State of what `pack` wrote.

    Raises
    ------
    SnapshotError
        If the bytes do not start with this version's mark, or end too early.
    """
    start = len(MARK) + 4
    if data[: len(MARK)] != MARK or len(data) < start:
        text = "the bytes are no FMU state of this version; save the state again with this FMU"
        raise SnapshotError(text)
    (length,) = struct.unpack("<I", data[len(MARK) : start])
    try:
        header = json.loads(data[start : start + length])
    except ValueError:
        text = "the bytes of the FMU state are damaged; save the state again"
        raise SnapshotError(text) from None
    return header, data[start + length :]
