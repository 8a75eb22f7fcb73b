"""The zip file: sorted entries, one fixed time, deflated, so that equal content is equal bytes.

Of a thousand variants of one mechanism all but three entries are the same. So what was deflated is
remembered, which `zipfile` cannot do, and the headers are written here (APPNOTE.TXT 4.3).
"""

from __future__ import annotations

import functools
import os
import struct
import tempfile
import zlib
from collections.abc import Mapping
from pathlib import Path

from build_fmu.errors import writing

MOST_BYTES = 2**32 - 1
"""Of an archive: beyond it stands the format zip64."""
MOST_REMEMBERED = 256
"""Deflated entries; an archive has some sixty."""

_LOCAL, _CENTRAL, _END = struct.Struct("<4s5H3L2H"), struct.Struct("<4s6H3L5H2L"), "<4s4H2LH"
_VERSION, _UNIX, _UTF8, _DEFLATED = 20, 3 << 8, 0x800, 8
_EARLIEST = (0, 1 << 5 | 1)
"""Time and date of 1980-01-01, the earliest that zip knows."""
_REGULAR_FILE, _EXECUTABLE_FILE = 0o100644, 0o100755


def write_archive(path: Path, entries: Mapping[str, bytes]) -> None:
    """Write the archive; a file that is there is replaced in one step, or left as it was."""
    content = archive(entries)  # first: a process that is ended meanwhile leaves no file
    with writing(path):
        _replace(path, content)


def _replace(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}-")
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        temporary.chmod(0o644)
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def archive(entries: Mapping[str, bytes]) -> bytes:
    """Bytes of the zip file with these entries."""
    parts, directory, at = [], [], 0
    for entry, data in sorted(entries.items()):
        name = entry.encode()
        checksum, deflated = _deflated(data)
        sizes = (checksum, len(deflated), len(data), len(name), 0)
        flags = 0 if entry.isascii() else _UTF8
        shared = (_VERSION, flags, _DEFLATED, *_EARLIEST, *sizes)
        mode = _EXECUTABLE_FILE if entry.startswith("binaries/") else _REGULAR_FILE
        outer = (0, 0, 0, mode << 16, at)
        parts += [_LOCAL.pack(b"PK\3\4", *shared), name, deflated]
        directory += [_CENTRAL.pack(b"PK\1\2", _UNIX | _VERSION, *shared, *outer), name]
        at += _LOCAL.size + len(name) + len(deflated)
    size = sum(map(len, directory))
    if at + size > MOST_BYTES:
        text = f"the archive would have {at + size} bytes, more than the {MOST_BYTES} of a zip file"
        raise ValueError(text)
    count = len(entries)
    end = struct.pack(_END, b"PK\5\6", 0, 0, count, count, size, at, 0)
    return b"".join([*parts, *directory, end])


@functools.lru_cache(MOST_REMEMBERED)
def _deflated(data: bytes) -> tuple[int, bytes]:
    """Checksum and deflated form."""
    compressor = zlib.compressobj(wbits=-zlib.MAX_WBITS)
    return zlib.crc32(data), compressor.compress(data) + compressor.flush()
