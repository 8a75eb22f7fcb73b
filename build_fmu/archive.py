"""The zip file: sorted entries, one fixed time, deflated, so that equal content is equal bytes."""

from __future__ import annotations

import os
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path

ENTRY_TIME = (1980, 1, 1, 0, 0, 0)  # the earliest that zip knows
REGULAR_FILE = 0o100644
EXECUTABLE_FILE = 0o100755


def write_archive(path: Path, entries: Mapping[str, bytes]) -> None:
    """Write the archive; a file that is there is replaced in one step, or left as it was."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}-")
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as file, zipfile.ZipFile(file, "w") as archive:
            for entry, data in sorted(entries.items()):
                archive.writestr(_header(entry), data)
        temporary.chmod(0o644)
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def _header(entry: str) -> zipfile.ZipInfo:
    info = zipfile.ZipInfo(entry, ENTRY_TIME)
    info.compress_type = zipfile.ZIP_DEFLATED
    info.create_system = 3  # Unix, whatever the author's machine is
    mode = EXECUTABLE_FILE if entry.startswith("binaries/") else REGULAR_FILE
    info.external_attr = mode << 16
    return info
