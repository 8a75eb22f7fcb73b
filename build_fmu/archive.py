"""The zip file: entries of one fixed time, deflated, so that equal content is equal bytes.

Of a thousand variants of one mechanism all but a few entries are the same. So these stand first,
and the zip file of them is remembered.
"""

from __future__ import annotations

import functools
import io
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path

from solver.files import write_whole

SHARED = ("binaries/", "documentation/licenses/", "resources/holonom_")
"""Beginnings of the names of entries that the FMUs of many mechanisms share."""
LARGE = 1_000_000
"""Bytes of an entry above which it is compressed quickly: in a third of the time, 7 % larger."""
QUICK = 2
"""Level of that compression."""
_EARLIEST = (1980, 1, 1, 0, 0, 0)
_UNIX, _REGULAR_FILE, _EXECUTABLE_FILE = 3, 0o100644, 0o100755


def write_archive(path: Path, entries: Mapping[str, bytes]) -> None:
    """Write the archive; a file that is there is replaced in one step, or left as it was."""
    write_whole(path, archive(entries))


def archive(entries: Mapping[str, bytes]) -> bytes:
    """Bytes of the zip file with these entries: those that FMUs share, and then the others."""
    shared = tuple(item for item in entries.items() if item[0].startswith(SHARED))
    others = tuple(item for item in entries.items() if not item[0].startswith(SHARED))
    return _extended(_remembered(shared), others)


def _extended(content: bytes, entries: Iterable[tuple[str, bytes]]) -> bytes:
    """Bytes of a zip file with more entries, sorted by name."""
    file = io.BytesIO()
    file.write(content)
    with zipfile.ZipFile(file, "a") as target:
        for name, data in sorted(entries):
            entry = zipfile.ZipInfo(name, _EARLIEST)
            entry.compress_type, entry.create_system = zipfile.ZIP_DEFLATED, _UNIX
            mode = _EXECUTABLE_FILE if name.startswith("binaries/") else _REGULAR_FILE
            entry.external_attr = mode << 16
            target.writestr(entry, data, compresslevel=QUICK if len(data) > LARGE else None)
    return file.getvalue()


@functools.lru_cache(2)
def _remembered(entries: tuple[tuple[str, bytes], ...]) -> bytes:
    return _extended(b"", entries)
