"""`holonom schema`: the JSON Schema of scenes, with which editors complete and check them."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from build_fmu.printing import json_text
from solver.files import write_whole


def run(arguments: argparse.Namespace) -> int:
    """Write the schema to a file, or to stdout; exit code 0."""
    if arguments.output:
        write_schema(Path(arguments.output))
    else:
        sys.stdout.write(_text())
    return 0


def write_schema(path: Path) -> None:
    """Write the schema of this version into a file."""
    write_whole(path, _text())
    sys.stdout.write(f"{path}: the schema of scenes\n")


def _text() -> str:
    from solver.scene import json_schema

    return json_text(json_schema()) + "\n"
