"""`holonom watch SCENE`: check a scene whenever it is saved, until Ctrl-C."""

from __future__ import annotations

import argparse
import contextlib
import sys
import time
import warnings
from collections.abc import Iterable, Iterator
from itertools import count
from pathlib import Path

from build_fmu.errors import CommandError, UsageError
from build_fmu.target import is_fmu, parts_and_model

SECONDS = 0.3
"""Between two looks at the file."""
Stamp = tuple[int, int] | None
"""Time [ns] and size of a file, which differ after a save; None while there is none."""


def run(arguments: argparse.Namespace) -> int:
    """Check at each save; exit code 0 after Ctrl-C."""
    if is_fmu(arguments.scene):
        text = f"{arguments.scene}: an FMU, not a scene; watch takes a .toml or .json file"
        raise UsageError(text)
    with contextlib.suppress(KeyboardInterrupt):
        for text in findings(arguments.scene, _stamps(arguments.scene)):
            sys.stdout.write(f"{text}\n")
            sys.stdout.flush()
    return 0


def findings(scene: str, stamps: Iterable[Stamp]) -> Iterator[str]:
    """What a check finds at the first stamp and at each that differs from the one before.

    An editor that replaces a file leaves none for a moment.
    """
    before: Stamp = None
    for stamp in stamps:
        if stamp not in (None, before):
            yield checked(scene)
        before = stamp or before


def checked(scene: str) -> str:
    """Sentences about a scene that is read and assembled, or that it is fine."""
    from solver.scene import SceneWarning

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always", SceneWarning)
        try:
            parts_and_model(scene, {})
            wrong = []
        except (CommandError, OSError) as error:
            wrong = [str(error)]
    sentences = [*(str(warning.message) for warning in said), *wrong]
    return "\n".join(sentences) or f"{scene}: fine"


def _stamps(scene: str) -> Iterator[Stamp]:
    """Stamp of a file, again and again."""
    for turn in count():
        if turn:
            time.sleep(SECONDS)
        try:
            found = Path(scene).stat()
        except OSError:
            yield None
        else:
            yield found.st_mtime_ns, found.st_size
