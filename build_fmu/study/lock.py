"""One sweep at a time writes into a file.

The lock is the operating system's (flock), so it ends with the process however that ends. Where
there is none (Windows, some network drives) nothing is locked here.
"""

from __future__ import annotations

import errno
from pathlib import Path
from typing import BinaryIO

from build_fmu.errors import UsageError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LOCKS = fcntl is not None
"""Whether files are locked here."""
TAKEN = (errno.EAGAIN, errno.EACCES)


def lock(path: Path, results: Path) -> BinaryIO:
    """File, made if it is not there, that is ours until it is closed.

    Raises
    ------
    UsageError
        If another one has it; the text names its results.
    """
    file = path.open("ab")
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in TAKEN:
                file.close()
                text = (
                    f"{results} is in use: another sweep writes into it, or a program has it open; "
                    "wait for its end, or name another file"
                )
                raise UsageError(text) from None
    return file
