"""Files that users name: read where they have an end, written whole or not at all.

A device, a pipe or a socket may have no end, or wait for a writer that never comes. Where a disk is
full or a program is ended, the beginning of a file would remain in place of the one before.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import secrets
import stat
from collections.abc import Callable, Iterator, Sequence
from os import PathLike, fspath
from pathlib import Path
from typing import IO, Any

MOST_BYTES = 2**30
"""Of a file that is read; the largest meshes and tables have some hundred million."""
_KINDS = {
    stat.S_IFIFO: "a named pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}
_HANDED_OVER = re.compile(r"/dev/std(in|out|err)|(?:/dev/fd/|/proc/self/fd/)([0-9]+)")
"""Names of what this program was started with, such as `<(command)` of a shell."""
_STANDARD = {"in": 0, "out": 1, "err": 2}
_OF_THE_SYSTEM = ("/proc/", "/sys/")
"""What is there looks like files, but may have no end, or wait for an event (/proc/kmsg)."""

PAGE = (".html", ".htm")
TABLE = (".csv",)
RESULTS = (*TABLE, ".h5", ".hdf5")
"""Endings of files that are written; those with trajectories are of HDF5."""

_DEVICES = re.compile(r"(con|prn|aux|nul|(com|lpt)[1-9\u00b9\u00b2\u00b3]) *(\..*)?", re.IGNORECASE)


def is_reserved(name: str) -> bool:
    """Whether Windows takes the name of a file for a device, or drops the end of it."""
    return _DEVICES.fullmatch(name) is not None or name != name.rstrip(" .")


def wrong_ending(path: str | PathLike[str], endings: Sequence[str]) -> str:
    """Say why no file of this name is written, or what it must end in; empty if it is all right.

    A device that is written into, such as /dev/null, needs no ending.
    """
    target = Path(path)
    if is_reserved(target.name):
        return f"{fspath(path)}: Windows reserves this name of a file; name another"
    if reason := why_unwritable(path):
        return f"{fspath(path)}: {reason}"
    if target.suffix.lower() in endings or (target.exists() and not target.is_file()):
        return ""
    one = "one of " if len(endings) > 1 else ""
    return f"{fspath(path)}: the name must end in {one}{', '.join(endings)}"


def why_unreadable(path: str | PathLike[str]) -> str:
    """Why nothing is read from a file, in small letters; empty if it may be."""
    return _why_not(path, _require_an_end)


def why_unwritable(path: str | PathLike[str]) -> str:
    """Why nothing is written into a file, in small letters; empty if it may be."""
    return _why_not(path, _require_room)


def _why_not(path: str | PathLike[str], require: Callable[[Path], object]) -> str:
    try:
        require(Path(path))
    except FileNotFoundError:
        return "no such file"
    except OSError as error:
        return (error.strerror or str(error)).lower()
    except ValueError as error:  # no name of a file has such characters
        return str(error)
    return ""


def read_whole(path: str | PathLike[str]) -> bytes:
    """Content of a regular file, or of a pipe that this program was given as /dev/stdin or /dev/fd.

    Raises
    ------
    OSError
        If it cannot be read, is a folder, device, socket or named pipe, is of the operating system
        (/proc, /sys), or has more than 1 GiB.
    """
    size = _require_an_end(Path(path))
    with open(path, "rb") as file:
        data = file.read(MOST_BYTES + 1) if size <= MOST_BYTES else b""
    if max(len(data), size) > MOST_BYTES:
        raise OSError(errno.EFBIG, f"larger than {MOST_BYTES} bytes", fspath(path))
    return data


def _require_an_end(path: Path) -> int:
    """Size [bytes] of a file that has an end; 0 for a pipe."""
    known = path.stat()
    if not (stat.S_ISFIFO(known.st_mode) and _handed_over(path) is not None):
        _require_regular(path, known.st_mode, "read")
    return known.st_size


def _require_room(path: Path) -> os.stat_result | None:
    """What is there already, if anything; refuse what would wait for a reader, or keep nothing."""
    try:
        known = path.stat()
    except (FileNotFoundError, NotADirectoryError):  # what its folder is, making it will tell
        return None
    if _handed_over(path) is None and fspath(path.resolve()) != os.devnull:
        _require_regular(path, known.st_mode, "written")
    return known


def _require_regular(path: Path, mode: int, done: str) -> None:
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), fspath(path))
    kind = _KINDS.get(stat.S_IFMT(mode), "no file")
    if stat.S_ISREG(mode):
        if not fspath(path.resolve()).startswith(_OF_THE_SYSTEM):
            return
        kind = "of the operating system"
    raise OSError(errno.EINVAL, f"{kind}, and only regular files are {done}", fspath(path))


def _handed_over(path: Path) -> int | None:
    """Number of the open file that this program was started with and that the name stands for."""
    if not (found := _HANDED_OVER.fullmatch(fspath(path))):
        return None
    return _STANDARD[found[1]] if found[1] else int(found[2])


@contextlib.contextmanager
def writing(path: str | PathLike[str]) -> Iterator[None]:
    """Name the file in an error of writing it, such as that of a full disk, which has no name."""
    try:
        yield
    except OSError as error:
        error.filename = error.filename or fspath(path)
        raise


@contextlib.contextmanager
def written_whole(path: str | PathLike[str], mode: str = "wb") -> Iterator[IO[Any]]:
    """File to write, "wb" or "w" (UTF-8, line ends as written), which takes its name at the end.

    Its folder is made if need be. Until the end, and after any failure, what was there stays as it
    was. What this program was started with, such as /dev/stdout, is written into, as is /dev/null.

    Raises
    ------
    OSError
        With this path; at once if it is a folder, another device, a socket or a named pipe.
    """
    text: dict[str, Any] = {} if "b" in mode else {"encoding": "utf-8", "newline": ""}
    with writing(path):
        before = _require_room(Path(path))
        given = _handed_over(Path(path))
        if given is not None or (before and not stat.S_ISREG(before.st_mode)):
            # Opened by its name, what was handed over would be written from its beginning again.
            with open(path if given is None else os.dup(given), mode, **text) as file:
                yield file
            return
        target = Path(path).resolve()  # a link stays one
        target.parent.mkdir(parents=True, exist_ok=True)
        beside = target.with_name(f".holonom-{secrets.token_hex(8)}")
        try:
            with beside.open(mode.replace("w", "x"), **text) as file:
                yield file
            if before:
                beside.chmod(stat.S_IMODE(before.st_mode))
            beside.replace(target)
        except BaseException as error:
            beside.unlink(missing_ok=True)
            if isinstance(error, OSError) and error.filename == fspath(beside):
                error.filename = fspath(path)
            raise


def write_whole(path: str | PathLike[str], content: bytes | str) -> None:
    """Write a file in one step; see ``written_whole``."""
    with written_whole(path) as file:
        file.write(content.encode() if isinstance(content, str) else content)
