"""The commands: usage, arguments and exit codes, from the parsers that read them."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from build_fmu import command_line
from build_fmu.errors import EXIT_CODES

HEAD = """# Commands

Results go to stdout, progress and messages to stderr. The exit code says how a command ended;
[the FMU](../fmu.md#4-when-something-fails) says how failures are reported.
"""


def write(folder: Path) -> None:
    """Write commands.md into a folder."""
    parser = command_line._parser()
    commands = next(x for x in parser._actions if isinstance(x, argparse._SubParsersAction))
    said = {x.dest: x.help or "" for x in commands._choices_actions}
    codes = [f"| {code} | {meaning} |" for code, meaning in EXIT_CODES.items()]
    parts = [HEAD, "\n".join(["| exit code | meaning |", "|---|---|", *codes]) + "\n"]
    for name, command in commands.choices.items():
        parts += [f"## holonom {name}\n", f"{said[name][:1].upper()}{said[name][1:]}.\n"]
        usage = re.sub(r"\s+", " ", command.format_usage().partition(":")[2]).strip()
        rows = [
            f"| {_named(action)} | {_plain((action.help or '') % vars(action))} |"
            for action in command._actions
            if not isinstance(action, argparse._HelpAction)
        ]
        parts += [f"```text\n{_broken(usage)}\n```\n"]
        parts += ["\n".join(["| argument | meaning |", "|---|---|", *rows]) + "\n"] if rows else []
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "commands.md").write_text("\n".join(parts), encoding="utf-8")


def _named(action: argparse.Action) -> str:
    """How an argument is written."""
    value = action.metavar if isinstance(action.metavar, str) else ""
    if action.choices:
        value = "{" + ",".join(map(str, action.choices)) + "}"
    taken = value if action.nargs != 0 else ""
    words = [f"{name} {taken}".strip() for name in action.option_strings] or [taken]
    return ", ".join(f"`{word}`" for word in words).replace("|", "\\|")


def _plain(text: str) -> str:
    """Text in which no sign is markup."""
    return re.sub(r"([|*<\[])", r"\\\1", text)


def _broken(usage: str, width: int = 84) -> str:
    """Lines of a usage, broken between arguments."""
    lines = [""]
    for word in re.findall(r"\[[^\]]*\]|\S+", usage):
        if len(lines[-1]) + len(word) > width:
            lines.append("   ")
        lines[-1] = f"{lines[-1]} {word}" if lines[-1] else word
    return "\n".join(lines)
