"""What ends a command, each with its exit code.

0 done; 1 a check failed; 2 usage or scene error; 3 the simulation did not finish or logged an
error, or no equilibrium was found; 4 the environment lacks something. Ctrl-C ends it with 130.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from os import PathLike, fspath

CHECK_FAILED = 1
USAGE = 2
UNFINISHED = 3
LACK = 4


@contextlib.contextmanager
def writing(path: str | PathLike[str]) -> Iterator[None]:
    """Name the file in an error of writing it, such as that of a full disk, which has no name."""
    try:
        yield
    except OSError as error:
        error.filename = error.filename or fspath(path)
        raise


class CommandError(Exception):
    """Base: the text is for the user, complete and without a traceback."""

    code = CHECK_FAILED


class UsageError(CommandError):
    """The command line, the scene or a file is wrong."""

    code = USAGE


class UnfinishedError(CommandError):
    """What was asked for was computed in vain: no equilibrium, say."""

    code = UNFINISHED


class EnvironmentLackError(CommandError):
    """Something is missing on this machine; the text says what and how to get it."""

    code = LACK
