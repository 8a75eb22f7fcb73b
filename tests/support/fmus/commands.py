"""Commands of `holonom`, run in this process."""

from __future__ import annotations

from build_fmu.command_line import main


def run(capsys, *arguments):
    """Exit code, stdout and stderr of a command."""
    code = main([str(argument) for argument in arguments])
    captured = capsys.readouterr()
    return code, captured.out, captured.err
