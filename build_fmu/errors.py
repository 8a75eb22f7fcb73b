"""What ends a command, each with its exit code."""

from __future__ import annotations

DONE, CHECK_FAILED, USAGE, UNFINISHED, LACK, INTERRUPTED = 0, 1, 2, 3, 4, 128 + 2
EXIT_CODES = {
    DONE: "done",
    CHECK_FAILED: "a check failed",
    USAGE: "usage or scene error",
    UNFINISHED: "the simulation did not finish or logged an error, or no equilibrium was found",
    LACK: "the environment lacks something",
    INTERRUPTED: "interrupted (Ctrl-C)",  # as a shell says it: 128 + SIGINT
}
"""What the exit codes of the command mean."""


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
