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
from collections.abc import Iterator, Sequence
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
_HANDED_OVER = ("/dev/stdin", "/dev/fd/", "/proc/self/fd/")
"""Beginnings of names of what this program was started with, such as `<(command)` of a shell."""


_DEVICES = re.compile(r"(con|prn|aux|nul|(com|lpt)[1-9\u00b9\u00b2\u00b3]) *(\..*)?", re.IGNORECASE)


def is_reserved(name: str) -> bool:
    """Whether Windows takes the name of a file for a device, or drops the end of it."""
    return _DEVICES.fullmatch(name) is not None or name != name.rstrip(" .")


def wrong_ending(path: str | PathLike[str], endings: Sequence[str]) -> str:
    """Say what the name of a file to write must end in; empty if it does, or names a device."""
    target = Path(path)
    if is_reserved(target.name):
        return f"{fspath(path)}: Windows reserves this name of a file; name another"
    if target.suffix.lower() in endings or (target.exists() and not target.is_file()):
        return ""
    one = "one of " if len(endings) > 1 else ""
    return f"{fspath(path)}: the name must end in {one}{', '.join(endings)}"


def why_unreadable(path: str | PathLike[str]) -> str:
    """Why nothing is read from a file, in small letters; empty if it may be."""
    try:
        _require_an_end(Path(path))
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
        If it cannot be read, is a folder, device, socket or named pipe, or has more than 1 GiB.
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
    kind = stat.S_IFMT(known.st_mode)
    if kind == stat.S_IFDIR:
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), fspath(path))
    if kind != stat.S_IFREG and not (
        kind == stat.S_IFIFO and fspath(path).startswith(_HANDED_OVER)
    ):
        text = f"{_KINDS.get(kind, 'no file')}, and only regular files are read"
        raise OSError(errno.EINVAL, text, fspath(path))
    return known.st_size


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
    was. A device, such as /dev/stdout, is written into.

    Raises
    ------
    OSError
        With this path.
    """
    text: dict[str, Any] = {} if "b" in mode else {"encoding": "utf-8", "newline": ""}
    with writing(path):
        target = Path(path).resolve()  # a link stays one
        target.parent.mkdir(parents=True, exist_ok=True)
        before = target.stat() if target.exists() else None
        if before and not stat.S_ISREG(before.st_mode):
            with target.open(mode, **text) as file:
                yield file
            return
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
