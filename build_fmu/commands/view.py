"""`holonom view SCENE|FMU`: a live page of it on this machine, with sliders."""

from __future__ import annotations

import argparse
import contextlib
import sys
import webbrowser

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.instance import interrupts_held
from build_fmu.package import PYTHON, Package, chosen_package
from build_fmu.study.settings import fmu_settings, given_on_the_command_line
from build_fmu.target import runnable


def run(arguments: argparse.Namespace) -> int:
    """Serve the page until it is closed or Ctrl-C is pressed; exit code 0 either way."""
    from build_fmu.reporting import Carried
    from build_fmu.stepping import SteppedFmu
    from viewer.live import Server, Session, StoppedError, live_page

    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    with runnable(arguments.target, entries, _package()) as (path, left):
        carried = Carried(path, arguments.target)
        values = fmu_settings(carried.description, [left])[0]
        with contextlib.closing(SteppedFmu(carried, values)) as fmu:
            controls, model = fmu.controls(), carried.model
            session = Session(fmu, controls)
            try:
                page = live_page(
                    session, fmu, controls, name=model.name, description=model.description,
                    variables=model.variables, outputs=carried.scene_outputs,
                    warnings=arguments.warnings,
                )  # fmt: skip
            except StoppedError as stopped:
                raise UsageError(str(stopped)) from None
            server = Server(session, page, arguments.port)
            sys.stdout.write(f"{server.address}\n")
            sys.stdout.flush()
            sys.stderr.write("it ends with Ctrl-C, and when its last page is closed\n")
            if not arguments.no_browser and not webbrowser.open(server.address):
                sys.stderr.write("no browser could be opened: open the address yourself\n")
            with contextlib.suppress(KeyboardInterrupt), interrupts_held() as pass_interrupts:
                server.run(pass_interrupts)
    return 0


def _package() -> Package:
    """Native, which is the fastest, where FMI has a name for this platform."""
    try:
        return chosen_package(True, 2, None, False)
    except EnvironmentLackError:
        return PYTHON
