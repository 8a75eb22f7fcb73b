"""`holonom watch SCENE`: check a scene whenever it is saved, until Ctrl-C; show it live."""

from __future__ import annotations

import argparse
import contextlib
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from build_fmu.errors import CommandError, UsageError
from build_fmu.target import is_fmu, parts_and_model
from solver.files import read_whole

if TYPE_CHECKING:
    from viewer.live_server import Server

SECONDS = 0.3
"""Between two looks at the files."""


def run(arguments: argparse.Namespace) -> int:
    """Check at each save; exit code 0 after Ctrl-C."""
    if is_fmu(arguments.scene):
        text = f"{arguments.scene}: an FMU, not a scene; watch takes a .toml or .json file"
        raise UsageError(text)
    files, page = WatchedFiles(arguments.scene), WatchedPage(arguments)
    read = page.renew if arguments.view else lambda _: parts_and_model(arguments.scene, {})
    with contextlib.suppress(KeyboardInterrupt), contextlib.closing(page):
        while True:
            if files.are_new():
                sys.stdout.write(f"{checked(arguments.scene, read)}\n")
                sys.stdout.flush()
            page.wait(SECONDS)
    return 0


class WatchedFiles:
    """A scene and the files that it names."""

    def __init__(self, scene: str) -> None:
        self._scene = Path(scene)
        self._before: list[tuple[Path, int, int]] = []

    def are_new(self) -> bool:
        """Whether one differs from what it was at the last look, in its time or size.

        An editor that replaces the scene leaves none for a moment, which is no difference.
        """
        try:
            # A file may be named in any field, also of a scene that cannot be read: what stands in
            # quotes and is a file.
            text = read_whole(self._scene).decode("utf-8", errors="replace")
            named = {self._scene.parent / name for name in re.findall(r"""["']([^"'\n]+)""", text)}
            files = [self._scene, *sorted(path for path in named if path.is_file())]
            now = [(path, path.stat().st_mtime_ns, path.stat().st_size) for path in files]
        except OSError:
            return False
        before, self._before = self._before, now
        return now != before


def checked(scene: str, read: Callable[[Iterable[str]], object]) -> str:
    """Sentences about a scene that is read, or that it is fine; `read` takes those so far."""
    from solver.scene import SceneWarning

    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always", SceneWarning)
        sentences, wrong = (str(warning.message) for warning in said), []
        try:
            read(sentences)
        except (CommandError, OSError) as error:
            wrong = [str(error)]
    return "\n".join([*(str(warning.message) for warning in said), *wrong]) or f"{scene}: fine"


class WatchedPage:
    """A live page of a scene as it was when it was last in order; none before it first was."""

    def __init__(self, arguments: argparse.Namespace) -> None:
        self._arguments = arguments
        self._server: Server | None = None
        self._serving, self._shown = contextlib.ExitStack(), contextlib.ExitStack()

    def renew(self, sentences: Iterable[str]) -> None:
        """Show the scene as it is now; if it is wrong, say so on the page."""
        from build_fmu.commands.view import live_session, server_of

        with contextlib.ExitStack() as new:
            try:
                scene = live_session(self._arguments.scene, {}, sentences)
                session, page = new.enter_context(scene)
            except CommandError as error:
                if self._server is not None:
                    self._server.session.say(str(error))
                raise
            if self._server is None:
                serving = server_of(session, page, self._arguments)
                self._server = self._serving.enter_context(serving)
            else:
                self._server.show(session, page)
            self._shown.close()
            self._shown = new.pop_all()

    def wait(self, seconds: float) -> None:
        """Let time pass, in which the mechanism moves."""
        from build_fmu.instance import interrupts_held

        if self._server is None:
            time.sleep(seconds)
        else:
            self._server.run(seconds, interrupts_held)

    def close(self) -> None:
        """End the page."""
        self._serving.close()
        self._shown.close()
