"""`documentation/` of an archive: a page about the model, licences, what the target needs."""

from __future__ import annotations

import re
import sysconfig
from collections import defaultdict
from collections.abc import Iterator, Sequence
from html import escape
from typing import TYPE_CHECKING

from build_fmu.payload import package_folder
from build_fmu.printing import as_text
from build_fmu.study.values import counted
from solver.options import TINY, tolerance_of
from solver.runtime import Integrator

if TYPE_CHECKING:
    from build_fmu.package import Package
    from build_fmu.self_check import SelfCheck
    from solver.runtime import Model, Variable

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{name}</title>
<style>
:root {{ color-scheme: light dark }}
body {{ font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 64rem; padding: 0 1em }}
table {{ border-collapse: collapse; width: 100% }}
th, td {{ border-bottom: 1px solid #8886; padding: .2rem .6rem .2rem 0; text-align: left }}
th, td {{ vertical-align: top }}
td code, .number {{ overflow-wrap: anywhere }}
img {{ float: right; margin: 0 0 1em 1em; border: 1px solid #8886; max-width: 100%; height: auto }}
.number {{ font-variant-numeric: tabular-nums }}
@media (max-width: 40rem) {{ table {{ font-size: 80% }} img {{ margin: 0 0 1em }} }}
</style>
</head>
<body>
<h1>{name}</h1>
<img src="../{picture}" alt="the mechanism as drawn" width="480" height="360">
<p>{description}</p>{drawn}
<p>An FMI {fmi}.0 co-simulation unit. Its steps conserve energy and constraints on positions up to
round-off; its outputs <code>energy.error</code> and <code>constraint.position</code> show it, and
<code>solver.status</code> is 0 as long as every communication
step succeeded. Where it is not 0 the last step was not taken and the log has the reason.</p>
<p>Default experiment: {experiment}.</p>
<p>{needs}</p>
<h2>How it is solved</h2>
<p>{solved}</p>
<h2>How exact it is</h2>
<p>{accuracy}</p>
{tables}
</body>
</html>
"""
_NEEDS = (
    "It needs Python 3.10 or newer on the machine that runs it, and no package. A host that is not "
    "a Python program must find libpython there; on Linux preload it: "
    "LD_PRELOAD=libpython3.x.so.1.0 host. There its library, which is pythonfmu's, needs glibc "
    "2.32 and the libstdc++ of GCC 12 (GLIBCXX_3.4.30), or newer ones; on Windows the Visual C++ "
    "runtime (MSVCP140.dll). The compiled kernel inside is for "
    f"{sysconfig.get_platform()}; on another platform no instance can be made: build it there."
)
_THINNED = "\n<p>The picture shows some of its many parts, evenly chosen.</p>"
_NEEDS_NOTHING = (
    "It needs nothing but the platform of one of its libraries, in the folder binaries."
)
_NEEDS_COMPILER = (
    "It has no library: the importer compiles its sources, in the folder sources, with a compiler "
    "of C99; they need no library, not even libm."
)
_RESERVED = re.compile("[&<>\"']")
_HEAD = ("Name", "Unit", "Value", "Range", "Meaning")
_CELLS = {0: "<td><code>{}</code></td>", **dict.fromkeys((2, 3), '<td class="number">{}</td>')}
_SETTINGS = "Settings of the solver"
_SECTIONS = {
    "input": "Inputs",
    "parameter": "Parameters",
    "calculatedParameter": "Calculated parameters",
    "output": "Outputs",
    "local": "Local variables",
    _SETTINGS: _SETTINGS,
}


PICTURES = {2: "model.png", 3: "terminalsAndIcons/icon.png"}
"""Path in the archive of the picture, by the version of FMI (2.0.5, 2.3; 3.0.1, 2.5.1)."""


def documentation(
    model: Model, seen: SelfCheck, package: Package | None = None, thinned: bool = False
) -> dict[str, bytes]:
    """Files below `documentation/` by path in the archive; `seen` is what a run of it showed.

    `thinned` tells that its picture shows some of its parts alone.
    """
    native = package is not None and package.native
    needs = _NEEDS
    if package and native:
        needs = _NEEDS_NOTHING if package.platforms else _NEEDS_COMPILER
    text = page(model, seen, needs, package.fmi if package else 2, thinned)
    licence, theirs = "documentation/licenses/license.txt", "documentation/licenses/pythonfmu.txt"
    files = {
        "documentation/index.html": text,
        "documentation/externalDependencies.txt": f"{needs}\n",
        licence: _licence("build_fmu", "holonom"),
    }
    if not native:
        files[theirs] = _licence("pythonfmu", "pythonfmu")
    return {path: content.encode() for path, content in files.items()}


def page(
    model: Model, seen: SelfCheck, needs: str = _NEEDS, fmi: int = 2, thinned: bool = False
) -> str:
    """HTML page with a table of variables per causality."""
    rows = defaultdict[str, list[list[str]]](list)
    for variable in model.variables:
        rows[_section(variable)].append(_row(variable))
    tables = [_table(title, rows[section]) for section, title in _SECTIONS.items()]
    start, stop, step, _ = model.experiment
    return _PAGE.format(
        name=escape(model.name),
        description=escape(model.description),
        drawn=_THINNED if thinned else "",
        experiment=f"{start!r} s to {stop!r} s with steps of {step!r} s",
        needs=needs,
        fmi=fmi,
        picture=PICTURES[fmi],
        solved=escape(solved(model, seen)),
        accuracy=escape(accuracy(model, seen)),
        tables="\n".join(filter(None, tables)),
    )


def _section(variable: Variable) -> str:
    return _SETTINGS if variable.kind == "option" else variable.causality


def solved(model: Model, seen: SelfCheck) -> str:
    """Sentences on size and method."""
    sizes, steps = model.sizes, Integrator(model).steps(seen.is_explicit)
    coordinates = counted(sizes["dim"] * sizes["n_free"], "coordinate")
    islands = sizes["n_islands"]
    apart = f", in {islands} parts that nothing joins" if islands > 1 else ""
    rows = counted(sizes["n_rows"], "constraint row")
    return f"{coordinates} and {rows}{apart}, solved in {steps}."


def accuracy(model: Model, seen: SelfCheck) -> str:
    """Sentences on a run from the start, with the numbers of the scene."""
    start, stop, *_ = model.experiment
    text = f"When this FMU was built, it ran for {seen.duration:g} s"
    if seen.duration < stop - start:
        text = f"{text} of the {stop - start:g} s of its default experiment"
    return " ".join([f"{text}.", *_seen(model, seen)])


def _seen(model: Model, seen: SelfCheck) -> Iterator[str]:
    if not seen.moved:
        yield "Nothing moved, so that the run does not show how exact the results are."
    else:
        yield (
            f"The energy balance was off by {seen.energy:.1e} of the reference energy at most, and "
            f"the constraints by {seen.constraint:.1e} of their size."
        )
    yield from (f"Its log said: {remark}." for remark in seen.remarks)
    if seen.reason:
        yield f"The run ended early: {seen.reason}"
    elif seen.moved and seen.is_large:
        yield "It is too large for a second, finer run while it is built: holonom check makes one."
    elif seen.moved and seen.position_error is not None:
        is_chosen = bool(tolerance_of(model.settings))
        finer = "a hundredth of the tolerance" if is_chosen else "half the internal step"
        turned = seen.rotation_error
        rotation = "" if turned is None else f", and its angles and orientations {turned:.1e} rad"
        if not seen.position_error and not turned:
            yield f"A run with {finer} gave the same, and does not show how exact that is."
            return
        yield (
            f"In these {seen.duration:g} s its positions were at most {seen.position_error:.1e} m"
            f"{rotation} off those of a run with {finer}."
        )


def _table(title: str, rows: Sequence[Sequence[str]]) -> str:
    """Table of the columns in which a row has something."""
    used = [k for k in range(len(_HEAD)) if any(row[k] for row in rows)]
    cells = "".join([_CELLS.get(k, "<td>{}</td>").replace("{}", f"{{{k}}}") for k in used])
    line = f"<tr>{cells}</tr>".format
    lines = [f"<tr>{''.join(f'<th>{_HEAD[k]}</th>' for k in used)}</tr>"]
    listed = "\n".join([*lines, *(line(*row) for row in rows)])
    return f"<h2>{title}</h2>\n<table>\n{listed}\n</table>" if rows else ""


def _row(variable: Variable) -> list[str]:
    span = _range(variable.minimum, variable.maximum)
    cells = (variable.name, variable.unit, as_text(variable.start), span, variable.description)
    return [escape(x) if x and _RESERVED.search(x) else x or "" for x in cells]


def _range(least: float | None, most: float | None) -> str:
    """Range in words; what must be greater than 0 has the least normal number as its minimum."""
    if least is None:
        return "" if most is None else f"at most {as_text(most)}"
    low = "above 0" if least == TINY else as_text(least)
    if most is None:
        return low if least == TINY else f"at least {low}"
    return f"{low} to {as_text(most)}"


def _licence(package: str, name: str) -> str:
    """Licence text of the distribution with a package, else of the source tree it runs from."""
    folder = package_folder(package).parent
    installed = sorted(folder.glob(f"{name}-*.dist-info/**/LICENSE"))
    for path in (*installed, folder / "LICENSE"):
        if path.is_file():
            return path.read_text(encoding="utf-8")
    return f"{name}: MIT\n"
