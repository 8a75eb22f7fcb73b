"""Bytes of a saved state: mark, fingerprint, phase, length, checksum, a filler, and the numbers."""

from __future__ import annotations

import struct
import zlib

PREFIX = struct.Struct("<8s32sqqII")
NUMBERS_AT, CHECKSUM_AT, PHASE_AT = PREFIX.size, PREFIX.size - 8, 40


def signed(data: bytearray) -> bytes:
    """Bytes with the checksum that they should have."""
    struct.pack_into("<I", data, CHECKSUM_AT, 0)
    struct.pack_into("<I", data, CHECKSUM_AT, zlib.crc32(data))
    return bytes(data)
