"""The command line: arguments, streams and exit codes; what a command does is in `commands/`.

Results go to stdout, progress and messages to stderr. A command's module is imported when it runs,
so that `--help` need not wait for NumPy.
"""

from __future__ import annotations

import argparse
import errno
import importlib
import os
import sys
from collections.abc import Sequence
from typing import Any

from build_fmu.errors import EXIT_CODES, INTERRUPTED, LACK, USAGE, CommandError
from build_fmu.printing import scene_warnings
from build_fmu.study.values import read_value
from build_fmu.version import VERSION
from solver.files import PAGE, RESULTS, TABLE, wrong_ending

OTHER_WORDS = {
    **dict.fromkeys(("--duration", "--end", "--until", "--tend", "--time"), "--stop"),
    **dict.fromkeys(("--dt", "--interval"), "--step"),
}
"""Options that other programs have, and what they are called here."""
ENDINGS = {
    "csv": TABLE,
    "report": PAGE,
    "report output": PAGE,
    "schema output": (".json",),
    "sweep results": RESULTS,
}
"""Of the names of files that options of all commands, or of one, write."""
OPTIONS = {"csv": "--csv", "report": "--report"}
"""Others are -o."""
MANY: dict[str, Any] = {"action": "append", "default": []}
"""Of an option that may be given several times."""


class _Parser(argparse.ArgumentParser):
    """A parser that suggests the option that an unknown one may mean."""

    def parse_known_args(  # type: ignore[override]
        self, args: Any = None, namespace: Any = None
    ) -> tuple[Any, list[str]]:
        """Parse, and report what is unknown here, where the options of the command are known."""
        chosen, unknown = super().parse_known_args(args, namespace)
        if unknown:
            from difflib import get_close_matches

            word = unknown[0].partition("=")[0]
            known = [name for name in self._option_string_actions if name.startswith("--")]
            near = OTHER_WORDS.get(word) or next(iter(get_close_matches(word, known)), "")
            hint = f"; did you mean {near}?" if near in known else ""
            self.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
        return chosen, unknown


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; the exit code."""
    chosen = _parser().parse_args(arguments)
    if wrong := _wrong_output(chosen):
        return _say(wrong, USAGE)
    try:
        with scene_warnings() as chosen.warnings:
            code = importlib.import_module(f"build_fmu.commands.{chosen.command}").run(chosen)
        sys.stdout.flush()
        return code
    except CommandError as failure:
        return _say(str(failure), failure.code)
    except ModuleNotFoundError as error:
        return _say(f"the package {error.name} is missing; install it: pip install holonom", LACK)
    except BrokenPipeError:
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115 - nobody reads the rest
        return 0
    except OSError as error:
        full = error.errno == errno.ENOSPC and not error.filename  # who writes files names them
        sys.stdout = open(os.devnull, "w") if full else sys.stdout  # noqa: SIM115 - tried again
        name = error.filename or ("the standard output" if full else "file")
        return _say(f"{name}: {error.strerror or error}", USAGE)
    except KeyboardInterrupt as stop:  # perhaps with what is to be known after it
        return _say("; ".join(["interrupted", *map(str, stop.args)]), INTERRUPTED)


def _wrong_output(chosen: argparse.Namespace) -> str:
    """Say which file cannot be written under its name, before anything is computed for it."""
    for key, endings in ENDINGS.items():
        command, _, name = key.rpartition(" ")
        file = getattr(chosen, name, None)
        if not file or file == "-" or command not in ("", chosen.command):
            continue
        if wrong := wrong_ending(file, endings):
            others = "; for other forms, Python has trajectory.to_pandas() and .to_xarray()"
            return f"{OPTIONS.get(name, '-o')} {wrong}{others if name == 'csv' else ''}"
    return ""


def _say(text: str, code: int) -> int:
    prefix = "" if ": error: " in text else "holonom: "
    sys.stderr.write(f"{prefix}{text}\n")
    return code


def setting(text: str) -> tuple[str, object]:
    """Name and value of `name=value`; a number, true/false, a list, else text as it stands."""
    name, equals, value = text.partition("=")
    if not equals or not name.strip():
        message = f"{text!r} is not of the form name=value"
        raise argparse.ArgumentTypeError(message)
    try:
        return name.strip(), read_value(value)
    except ValueError as error:
        message = f"{value.strip()}: {error}"
        raise argparse.ArgumentTypeError(message) from None


def _parser() -> argparse.ArgumentParser:
    codes = [f"  {code}  {meaning}\n" for code, meaning in EXIT_CODES.items()]
    parser = _Parser(
        prog="holonom",
        description="Turn mechanisms into FMI co-simulation units; run and check them.",
        epilog="".join(["exit codes:\n", *codes]),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {VERSION}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    build = commands.add_parser("build", help="write the FMU of a scene")
    build.add_argument("scene", metavar="SCENE", help="scene file, .toml or .json")
    text = "an .fmu file or a folder (default: <name of the scene's file>.fmu)"
    build.add_argument("-o", "--output", metavar="FILE", help=text)
    _add_package(build)
    text = "outputs that are ports of the FMU, names or patterns such as 'tip.*' separated by "
    text += "commas, in place of the scene's (default: all)"
    build.add_argument("--outputs", metavar="NAMES", help=text)
    _add_settings(build, "replace a parameter or any number of the scene, e.g. points.A.mass=2")
    _add_variants(commands)
    simulate = commands.add_parser("simulate", help="run an FMU, or that of a scene, in fmpy")
    _add_run(simulate, inputs=True)
    simulate.add_argument("--csv", metavar="FILE", help="write the trajectory ('-': to stdout)")
    text = "run it by another method of García Orden and Ortega, such as midpoint-al, without fmpy"
    simulate.add_argument("--formulation", metavar="NAME", help=text)
    _add_plot(simulate, "plot the run into a file")
    _add_sweep(commands)
    check = commands.add_parser(
        "check", help="test that energy and constraints hold, and show how exact it is"
    )
    _add_run(check, inputs=True)
    for name in ("energy", "constraint"):
        text = f"largest relative {name} error that passes (default: %(default)s)"
        check.add_argument(f"--{name}", type=float, default=1e-9, metavar="LIMIT", help=text)
    text = "largest error of the path that passes, of places over the size, of angles in rad, as a "
    text += "run with a tenth of the tolerance or less, or half the step, shows it (default: any)"
    check.add_argument("--accuracy", type=float, metavar="LIMIT", help=text)
    report = commands.add_parser("report", help="write a page of a run of any importer")
    report.add_argument("target", metavar="SCENE|FMU")
    text = "CSV file of the run: a column 'time', and the outputs by their names; several compare"
    report.add_argument("--results", metavar="FILE", action="append", required=True, help=text)
    text = "(default: <name of the first file>.html)"
    report.add_argument("-o", "--output", metavar="FILE", help=f"the page {text}")
    _add_settings(report, "the parameters that the run had")
    view = commands.add_parser("view", help="show it live in a browser, with sliders")
    view.add_argument("target", metavar="SCENE|FMU")
    _add_page(view)
    _add_settings(view, "set a parameter or input (of a scene: any number of it)")
    info = commands.add_parser("info", help="bodies, joints, mobility, redundant rows, variables")
    info.add_argument("target", metavar="SCENE|FMU")
    text = "find the static equilibrium next to the drawn configuration, and what holds it there"
    info.add_argument("--equilibrium", action="store_true", help=text)
    _add_settings(info, "replace a parameter or any number of the scene")
    closing = commands.add_parser("assemble", help="close a mechanism that is drawn inexactly")
    closing.add_argument("scene", metavar="SCENE", help="scene file, .toml or .json")
    text = "file for the scene with the closed places and velocities, comments kept (default: none)"
    closing.add_argument("-o", "--output", metavar="FILE", help=text)
    _add_settings(
        closing, "replace a parameter or any number of the scene, also in what is written"
    )
    init = commands.add_parser("init", help="write a scene to begin with")
    init.add_argument("name", metavar="NAME", help="of the scene and its file, NAME.toml")
    text = "scene of this package that it is like, such as slider_crank (default: %(default)s)"
    init.add_argument("--like", default="double_pendulum", metavar="SCENE", help=text)
    watch = commands.add_parser("watch", help="check a scene at each save, until Ctrl-C")
    watch.add_argument("scene", metavar="SCENE", help="scene file, .toml or .json")
    text = "also show it live, as `holonom view` does, and anew after each save"
    watch.add_argument("--view", action="store_true", help=text)
    _add_page(watch)
    schema = commands.add_parser("schema", help="JSON Schema of scenes, for editors")
    schema.add_argument("-o", "--output", metavar="FILE", help="(default: to stdout)")
    validate = commands.add_parser("validate", help="check an FMU against the standard with fmpy")
    validate.add_argument("target", metavar="FMU")
    for command in (build, simulate, check, info, closing, validate):
        command.add_argument("--json", action="store_true", help="print JSON instead of a table")
    return parser


def _add_page(command: argparse.ArgumentParser) -> None:
    text = "print the address, and open no browser"
    command.add_argument("--no-browser", action="store_true", help=text)
    text = "of the address (default: any that is free)"
    command.add_argument("--port", type=int, default=0, metavar="N", help=f"port {text}")


def _add_variants(commands: argparse._SubParsersAction) -> None:
    command = commands.add_parser("variants", help="write one FMU for each row of a grid or table")
    command.add_argument("scene", metavar="SCENE", help="scene file, .toml or .json")
    text = "folder for the FMUs and the manifest (default: <name of the scene's file>_variants)"
    command.add_argument("-o", "--output", metavar="FOLDER", help=text)
    text = "name of the file that says which FMU is which, .csv or .json (default: %(default)s)"
    command.add_argument("--manifest", default="manifest.csv", metavar="FILE", help=text)
    text = "remove the FMUs of an earlier study that are in that folder"
    command.add_argument("--fresh", action="store_true", help=text)
    _add_report(command)
    _add_package(command)
    _add_study(command)
    _add_settings(command, "replace a parameter or any number of the scene, in all of them")
    command.add_argument("--json", action="store_true", help="print JSON instead of the file")


def _add_sweep(commands: argparse._SubParsersAction) -> None:
    command = commands.add_parser("sweep", help="run one FMU with many values of its parameters")
    _add_run(command)
    _add_study(command)
    text = "outputs to keep, separated by commas (default: all)"
    command.add_argument("--output", **MANY, metavar="NAMES", help=text)
    text = "file of results, .csv or .h5 (default: <name of the file>_sweep.csv); one that is"
    text += " there, of the same sweep, is continued"
    command.add_argument("-o", "--results", metavar="FILE", help=text)
    command.add_argument("--fresh", action="store_true", help="replace what is in that file")
    _add_plot(command, "plot outputs over one parameter, or heat maps over two, into a file")
    command.add_argument("--json", action="store_true", help="print JSON instead of a table")


def _add_package(command: argparse.ArgumentParser) -> None:
    """Arguments that say how an FMU is packaged."""
    text = "with a library in C, so that it runs without Python"
    command.add_argument("--native", action="store_true", help=text)
    text = "version of the standard; 3 needs --native (default: 2)"
    command.add_argument("--fmi", type=int, choices=(2, 3), default=2, help=text)
    text = "of a native FMU, separated by commas: linux64, win64, darwin64, linux-arm64, or all "
    text += "(default: this machine's); with --sources also none"
    command.add_argument("--platforms", metavar="NAMES", help=text)
    text = "with sources in C, too, which an importer compiles; needs --native"
    command.add_argument("--sources", action="store_true", help=text)


def _add_study(command: argparse.ArgumentParser) -> None:
    """Arguments of what is done for many values."""
    text = "values of one parameter, a=2,3, or a range, a=1:5:9 (9 values) or a=1:100:9:log; grids"
    command.add_argument("--grid", **MANY, metavar="NAME=VALUES", help=f"{text} multiply")
    text = "CSV file with names in its first line and one row of values for each"
    command.add_argument("--table", metavar="FILE", help=text)
    text = "auto (default), serial, processes, processes:N or dask://HOST:PORT"
    command.add_argument("--engine", default="auto", metavar="ENGINE", help=text)
    text = "number of processes (default: one for each processor)"
    command.add_argument("--jobs", type=int, metavar="N", help=text)


def _add_settings(command: argparse.ArgumentParser, text: str) -> None:
    values = {"dest": "settings", "type": setting, "metavar": "NAME=VALUE"}
    command.add_argument("--set", "-s", **MANY, **values, help=text)
    text = "values from a file: .toml, .json, .csv, or .ssv (SSP); --set has precedence"
    command.add_argument("--parameters", "-p", **MANY, metavar="FILE", help=text)


def _add_report(command: argparse.ArgumentParser) -> None:
    text = "write a page that shows the mechanism in motion, with plots, for any browser"
    command.add_argument("--report", metavar="FILE", help=text)


def _add_plot(command: argparse.ArgumentParser, text: str) -> None:
    text += ", .png, .svg or .pdf; needs holonom[plot]"
    command.add_argument("--plot", metavar="FILE", help=text)
    text = "what it shows, names or patterns such as 'energy.*' separated by commas (default: the "
    text += "scene's own outputs, else energies and errors)"
    command.add_argument("--plot-of", metavar="NAMES", help=text)


def _add_run(command: argparse.ArgumentParser, *, inputs: bool = False) -> None:
    command.add_argument("target", metavar="SCENE|FMU")
    _add_report(command)
    text = "(default: that of the scene)"
    command.add_argument("--stop", type=float, metavar="TIME", help=f"stop time in s {text}")
    help = f"communication step in s {text}"
    command.add_argument("--step", type=float, metavar="SIZE", help=help)
    _add_settings(command, "set a parameter or input (of a scene: any number of it)")
    if inputs:
        text = "CSV file of inputs over time: a column 'time' and one for each input"
        command.add_argument("--inputs", metavar="FILE", help=text)
