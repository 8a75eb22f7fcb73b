"""One file of libraries for several processors, as macOS loads it (mach-o/fat.h)."""

from __future__ import annotations

import struct
from collections.abc import Sequence

ALIGNMENT = 14
"""Exponent of 2: places of the libraries in the file are multiples of it, a page of every Mac."""


def universal(libraries: Sequence[bytes]) -> bytes:
    """Universal file of Mach-O libraries, one for each processor."""
    start, page = 8 + 20 * len(libraries), 1 << ALIGNMENT
    header, body = struct.pack(">II", 0xCAFEBABE, len(libraries)), b""
    for library in libraries:
        body += bytes(-(start + len(body)) % page)
        processor = struct.unpack_from("<ii", library, 4)
        header += struct.pack(">iiIII", *processor, start + len(body), len(library), ALIGNMENT)
        body += library
    return header + body
