"""`python -m benchmarks [NAME ...] [--quick] [--merge] [--output FOLDER]`: measure and print."""

from __future__ import annotations

import argparse
import os
import sys
import time
import warnings
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

import solver
from benchmarks.measuring.effort import FULL, QUICK, Effort
from benchmarks.measuring.machine import describe
from benchmarks.pages.report import Section, as_json, as_markdown, merged

SECTIONS = {
    "steps": "benchmarks.sections.steps",
    "chains": "benchmarks.sections.chains",
    "fmu": "benchmarks.sections.fmu",
    "native": "benchmarks.sections.native",
    "sweeps": "benchmarks.sections.sweeps",
    "work-precision": "benchmarks.sections.work_precision",
    "formulations": "benchmarks.sections.formulations",
    "long-run": "benchmarks.sections.long_run",
    "mechanisms": "benchmarks.sections.scene_steps",
    "rigid-chains": "benchmarks.sections.rigid_chains",
    "instructions": "benchmarks.sections.instructions",
    "tolerances": "benchmarks.sections.tolerances",
    "stability": "benchmarks.sections.stability",
    "stress": "benchmarks.sections.stress",
    "skips": "benchmarks.sections.skips",
    "contact": "benchmarks.contact.section",
    "contact-scenes": "benchmarks.contact.scenes",
    "contact-laws": "benchmarks.contact_laws.section",
}
"""Module of each benchmark; its function `measure` takes an effort and returns a section."""

DOCS = Path(__file__).resolve().parents[1] / "docs"


def main(arguments: Sequence[str] | None = None) -> int:
    options = _options(arguments)
    warnings.simplefilter("ignore", solver.SceneWarning)  # bodies of a kilometre are meant
    effort = QUICK if options.quick else FULL
    machine = describe()
    sections = [_measure(name, effort) for name in options.names or SECTIONS]
    page = as_markdown(machine, effort.name, sections)
    results = as_json(machine, effort.name, sections)
    print(page)
    complete = not options.names and not options.quick
    folder = options.output or (DOCS if complete or options.merge else None)
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
        data, text = folder / "benchmarks.json", folder / "benchmarks.md"
        if options.merge:
            known = text.read_text(encoding="utf-8"), data.read_text(encoding="utf-8")
            page, results = merged(*known, machine, effort.name, sections)
        data.write_text(results, encoding="utf-8")
        text.write_text(page, encoding="utf-8")
        _draw(sections, folder)
        print(f"written: benchmarks.md and benchmarks.json in {folder}", file=sys.stderr)
    return 0


def _options(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks",
        description="Measure time and accuracy. A complete run writes docs/benchmarks.md and "
        ".json; a part of it or a quick one only prints, unless --output or --merge is given.",
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"some of: {', '.join(SECTIONS)}")
    parser.add_argument("--quick", action="store_true", help="small sizes, to try the programs")
    parser.add_argument(
        "--merge", action="store_true", help="put these sections in the place of written ones"
    )
    parser.add_argument("--output", type=Path, metavar="FOLDER", help="where to write")
    options = parser.parse_args(arguments)
    unknown = [name for name in options.names if name not in SECTIONS]
    if unknown:
        parser.error(f"no benchmark {unknown[0]!r}; there are {', '.join(SECTIONS)}")
    return options


def _measure(name: str, effort: Effort) -> Section:
    begin = time.perf_counter()
    print(f"{name} ...", end=" ", file=sys.stderr, flush=True)
    section = import_module(SECTIONS[name]).measure(effort)
    print(f"{time.perf_counter() - begin:.1f} s", file=sys.stderr)
    return section


def _draw(sections: Sequence[Section], folder: Path) -> None:
    for section in sections:
        if section.picture:
            import_module(SECTIONS[section.name]).draw(section, folder / section.picture)


if __name__ == "__main__":
    code = main()
    sys.stdout.flush()
    # Without exit handlers: that of pythonfmu's library, once an FMU was loaded, reads freed memory
    # and now and then aborts a process that has done all its work.
    os._exit(code)
