"""`holonom init NAME --like slider_crank`: a scene to begin with, and its schema for editors."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from build_fmu.commands.schema import write_schema
from build_fmu.errors import UsageError
from solver.files import is_reserved, write_whole
from solver.scene.scene import LONGEST, NAME
from solver.scene.words import nearest

SCHEMA = "scene.schema.json"
HOMES = [Path(__file__).parents[1] / "scenes", Path(__file__).parents[2] / "scenes"]
"""Where scenes lie in a wheel and in a clone."""


def run(arguments: argparse.Namespace) -> int:
    """Write the scene, and beside it the schema unless one is there; exit code 0."""
    path = Path(arguments.name)
    path = path if path.suffix == ".toml" else path.with_name(f"{path.name}.toml")
    if not NAME.fullmatch(path.stem) or is_reserved(path.stem) or len(path.stem) > LONGEST:
        text = f"{path.stem!r} cannot be the name of a scene; write letters, digits and _, "
        text += f"of which the first is a letter, at most {LONGEST}; Windows reserves some names"
        raise UsageError(text)
    text = text_like(arguments.like, path.stem)
    schema = path.with_name(SCHEMA)
    if path.exists():
        text = f"{path}: there is such a file already; choose another name or remove it"
        raise UsageError(text)
    write_whole(path, text)
    sys.stdout.write(f"{path}: a scene like {arguments.like}; try: holonom check {path}\n")
    if not schema.exists():
        write_schema(schema)
    return 0


def text_like(like: str, name: str) -> str:
    """Text of a scene of this package under another name.

    Raises
    ------
    UsageError
        If there is no such scene; the sentence lists all.
    """
    home = next(folder for folder in HOMES if folder.is_dir())
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(home.glob("*.toml"))}
    known = [each for each, text in texts.items() if not re.search(r"\bfile = ", text)]  # of others
    if like not in known:
        near = nearest(like, known)
        help = f"did you mean {near!r}? " if near else ""
        text = f"--like {like}: there is no such scene; {help}scenes are {', '.join(known)}"
        raise UsageError(text)
    text = re.sub(r"^#:schema .*", f"#:schema ./{SCHEMA}", texts[like])
    return re.sub(r'^name = ".*"$', f'name = "{name}"', text, count=1, flags=re.MULTILINE)
