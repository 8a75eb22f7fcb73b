"""`holonom view SCENE|FMU`: a live page of it on this machine, with sliders."""

from __future__ import annotations

import argparse
import contextlib
import sys
import webbrowser
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.instance import interrupts_held
from build_fmu.package import PYTHON, Package, chosen_package
from build_fmu.study.settings import fmu_settings, given_on_the_command_line
from build_fmu.target import runnable

if TYPE_CHECKING:
    from build_fmu.study.values import Entry
    from viewer.live import Session
    from viewer.live_server import Server


def run(arguments: argparse.Namespace) -> int:
    """Serve the page until it is closed or Ctrl-C is pressed; exit code 0 either way."""
    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with (
        live_session(arguments.target, entries, arguments.warnings) as (session, page),
        contextlib.suppress(KeyboardInterrupt),
        server_of(session, page, arguments, ", and when its last page is closed") as server,
    ):
        server.run(hold=interrupts_held)
    return 0


@contextlib.contextmanager
def live_session(
    target: str, entries: Mapping[str, Entry], warnings: Iterable[str]
) -> Iterator[tuple[Session, str]]:
    """Session of a scene or FMU, which is stepped as long as this lasts, and its page."""
    from build_fmu.run_page import Carried
    from build_fmu.stepping import SteppedFmu
    from viewer.live import Session, StoppedError, live_page

    with runnable(target, entries, _package()) as (path, left):
        carried = Carried(path, target)
        values = fmu_settings(carried.description, [left])[0]
        with contextlib.closing(SteppedFmu(carried, values)) as fmu:
            controls, model = fmu.controls(), carried.model
            session = Session(fmu, controls)
            try:
                page = live_page(
                    session, fmu, controls, name=model.name, description=model.description,
                    variables=model.variables, outputs=carried.scene_outputs,
                    warnings=[*warnings],
                )  # fmt: skip
            except StoppedError as stopped:
                raise UsageError(str(stopped)) from None
            yield session, page


@contextlib.contextmanager
def server_of(
    session: Session, page: str, arguments: argparse.Namespace, end: str = ""
) -> Iterator[Server]:
    """Server of a page whose address is said, and opened in a browser."""
    from viewer.live_server import Server

    try:
        made = Server(session, page, arguments.port)
    except (OSError, OverflowError) as error:
        text = f"port {arguments.port}: {getattr(error, 'strerror', None) or error}; "
        text += "leave out --port, and one that is free is taken"
        raise UsageError(text) from None
    with made as server:
        sys.stdout.write(f"{server.address}\n")
        sys.stdout.flush()
        sys.stderr.write(f"it ends with Ctrl-C{end}\n")
        if not arguments.no_browser and not webbrowser.open(server.address):
            sys.stderr.write("no browser could be opened: open the address yourself\n")
        yield server


def _package() -> Package:
    """Native, which is the fastest, where FMI has a name for this platform."""
    try:
        return chosen_package(True, 2, None, False)
    except EnvironmentLackError:
        return PYTHON
