"""Writes runs of a mechanism as one HTML file that needs no network.

The page is `page.html` with the bundle of `src/`; what it shows travels inside it as blocks of text
(`packing`): facts, names and the drawing as JSON, numbers as bytes.
"""

from __future__ import annotations

import base64
import functools
import hashlib
import html
import json
import math
import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from solver.files import PAGE, write_whole, wrong_ending
from viewer.packing import BUDGET, channels, packed, text_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from solver.runtime import Variable
    from solver.trajectory import Trajectory

FORMAT = 1
HOME = Path(__file__).parent
GOOD = 1e-9
"""Largest error of energy or constraint that a page calls good."""
LOSSES = ("energy.damping", "energy.friction", "energy.impact")
ROOM_FOR_NAMES = 8
"""Characters of a page for each name of a column of a run: deflated, and its level."""
MOST_LINES = 6
"""Of one plot."""
MOST_TOLD = 8
"""Names of missing columns."""


@dataclass(frozen=True)
class ReportRun:
    """One run of a page.

    Attributes
    ----------
    drawing : mapping
        Of `viewer.drawing.drawing`, with the parameters of this run.
    times : ndarray, shape (n,)
        In s.
    columns : mapping of str to ndarray, shape (n,)
        Values by name of the variable.
    label : str
        What tells it from other runs.
    parameters : mapping
        What tells it from other runs, by name.
    settings : mapping
        Values of parameters, inputs and settings that are not those of the scene.
    stop_time, wall_time : float or None
        In s.
    reason : str
        Why it ended early or what went wrong; empty if it is a clean run.
    """

    drawing: Mapping[str, Any]
    times: NDArray[np.float64]
    columns: Mapping[str, NDArray[np.float64]]
    label: str = ""
    parameters: Mapping[str, Any] = field(default_factory=dict)
    settings: Mapping[str, Any] = field(default_factory=dict)
    stop_time: float | None = None
    wall_time: float | None = None
    reason: str = ""


def write_report(
    path: str | PathLike[str],
    runs: Sequence[ReportRun],
    *,
    name: str,
    description: str = "",
    variables: Iterable[Variable],
    outputs: Sequence[str] = (),
    warnings: Sequence[str] = (),
    compare: bool = False,
) -> Path:
    """Write one page of one run or several.

    Parameters
    ----------
    path
        File to write.
    runs
        At least one, of one mechanism.
    name, description
        Of the mechanism.
    variables
        All variables of the model.
    outputs
        Names of the outputs of the scene, which are plotted first.
    warnings
        Sentences to show.
    compare
        Whether the page begins with two runs side by side.
    """
    target = Path(path)
    page = page_text(runs, name, description, [*variables], outputs, [*warnings], compare=compare)
    write_whole(target, page)
    return target


def report_of_trajectory(path: str | PathLike[str], trajectory: Trajectory) -> Path:
    """Write the page of a run in Python; see ``Trajectory.report``."""
    from solver.runtime import OptionError
    from viewer.drawing import drawing

    if wrong := wrong_ending(path, PAGE):
        text = f"report: {wrong}"
        raise OptionError(text)
    model = trajectory.model
    scene: Any = model and model.scene
    if model is None or scene is None:
        text = "report: the trajectory knows no scene; run one with holonom.simulate(scene)"
        raise OptionError(text)
    free = {v.name for v in model.variables if v.kind == "parameter"}
    values = {n: float(x) for n, x in trajectory.given.items() if n in free}
    drawn = drawing(scene, values)
    columns = dict(trajectory.items())
    if missing := missing_columns(drawn, columns):
        text = f"report: {missing} not collected, by which {model.name} is drawn; "
        text += "leave out 'outputs', or name them there"
        raise OptionError(text)
    run = ReportRun(
        drawn, trajectory.t, columns, settings=trajectory.given, wall_time=trajectory.wall_time
    )
    return write_report(
        path, [run], name=model.name, description=model.description,
        variables=model.variables, outputs=scene.results(), warnings=scene.sentences(),
    )  # fmt: skip


def missing_columns(drawing: Mapping[str, Any], columns: Container[str]) -> str:
    """Names of the columns that a drawing needs and that are not there; empty if none are."""
    missing = [name for name in channels(drawing)[0] if name not in columns]
    rest = f" and {len(missing) - MOST_TOLD} more" if len(missing) > MOST_TOLD else ""
    return ", ".join(missing[:MOST_TOLD]) + rest


def page_text(
    runs: Sequence[ReportRun],
    name: str,
    description: str,
    variables: Sequence[Variable],
    outputs: Sequence[str],
    warnings: Sequence[str],
    *,
    compare: bool = False,
) -> str:
    """Text of the page."""
    have = {v.name: v for v in variables}
    order = ordered([n for n in have if n in runs[0].columns], outputs, have)
    drawings: list[Mapping[str, Any]] = []
    metas, blocks, notes = [], [], []
    for run in runs:
        if not drawings or run.drawing != drawings[-1]:
            drawings.append(run.drawing)
        meta = {
            "label": run.label,
            "drawing": len(drawings) - 1,
            "parameters": run.parameters,
            "settings": run.settings,
            "facts": facts(run),
        }
        metas.append(meta)
    data: dict[str, Any] = {
        "format": FORMAT,
        "name": name,
        "description": description,
        "drawings": drawings,
        "kinds": channels(runs[0].drawing)[1],
        "variables": [described(v) for v in variables],
        "plots": default_plots(order, outputs, have, runs[0]),
        "runs": metas,
        "notes": notes,
        "warnings": warnings,
        "compare": compare,
    }
    around = len(filled(data).encode()) + ROOM_FOR_NAMES * len(order) * len(runs)
    budget = max(BUDGET - around, 0) // len(runs)
    for run, meta in zip(runs, metas, strict=True):
        columns = [n for n in order if n in run.columns]
        result = packed(run.drawing, run.times, run.columns, columns, budget)
        meta |= result.meta
        blocks += result.blocks
        notes += [f"{run.label}: {note}" if run.label else note for note in result.notes]
    return filled(data, blocks)


def filled(data: Mapping[str, Any], blocks: Sequence[str] = (), connect: str = "'none'") -> str:
    """The page with these data; `connect` is where it may connect to: nowhere, if it is a file."""
    script, style, page = _assets()
    inside = "\n".join(
        f'<script type="text/plain" id="block{k}">{block}</script>'
        for k, block in enumerate(blocks)
    )
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    parts = {
        "TITLE": html.escape(data["name"]),
        "CONNECT": connect,
        "DIGEST": digest,
        "STYLE": style,
        "DATA": text_of(_json(data).encode()),
        "BLOCKS": inside,
        "SCRIPT": script,
    }
    return re.sub("@@([A-Z]+)@@", lambda mark: parts[mark[1]], page)


@functools.cache
def _assets() -> tuple[str, str, str]:
    script = (HOME / "bundle" / "viewer.js").read_text(encoding="utf-8")
    style = (HOME / "bundle" / "viewer.css").read_text(encoding="utf-8")
    page = (HOME / "page.html").read_text(encoding="utf-8")
    return script, style, page


def _json(data: object) -> str:
    """JSON in which numbers that are not finite are null."""
    return json.dumps(_finite(data), separators=(",", ":"), ensure_ascii=False)


def _finite(data: Any) -> Any:
    if isinstance(data, Mapping):
        return {str(key): _finite(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [_finite(value) for value in data]
    data = data.item() if isinstance(data, np.generic) else data
    return None if isinstance(data, float) and not math.isfinite(data) else data


def described(variable: Variable) -> dict[str, Any]:
    """What a page says of a variable."""
    role = "setting" if variable.kind == "option" else variable.causality
    known = {"name": variable.name, "unit": variable.unit, "description": variable.description}
    given = {} if variable.start is None else {"start": variable.start}
    return known | {"role": role} | given


def ordered(
    names: Sequence[str], outputs: Sequence[str], have: Mapping[str, Variable]
) -> list[str]:
    """Names of columns, the most important first: what stays when the page would be too large."""
    inputs = [n for n in names if have[n].causality == "input"]
    first = [n for n in names if n in outputs]
    errors = [n for n in names if n.startswith(("energy.", "constraint."))]
    return [*dict.fromkeys([*inputs, *first, *errors, *names])]


def facts(run: ReportRun) -> list[dict[str, str]]:
    """Cards of a run: whether it finished, its largest errors, its wall time."""
    end = float(run.times[-1])
    stopped = run.stop_time is not None and end < run.stop_time - 1e-9 * abs(run.stop_time)
    said = "stopped" if stopped else "with an error" if run.reason else "finished"
    of = f"of {run.stop_time:g} s" if stopped else f"s, {len(run.times) - 1} steps"
    level = "bad" if run.reason or stopped else "good"
    found = [{"value": said, "label": f"t = {end:g} {of}", "level": level, "title": run.reason}]
    for name, words in (
        ("energy.error", "largest energy error"),
        ("constraint.position", "largest constraint residual"),
    ):
        if name in run.columns:
            largest = float(np.abs(run.columns[name]).max())
            level = "good" if largest <= GOOD else "bad"
            shown = f"{largest:.1e}" if largest else "0"
            found.append({"value": shown, "label": words, "level": level})
    if run.wall_time is not None:
        spent = f"{run.wall_time:.2f} s" if run.wall_time >= 1 else f"{1e3 * run.wall_time:.0f} ms"
        found.append({"value": spent, "label": "wall time", "level": ""})
    return found


def default_plots(
    names: Sequence[str], outputs: Sequence[str], have: Mapping[str, Variable], run: ReportRun
) -> list[dict[str, Any]]:
    """Plots that a page begins with: what the scene asks for, energies, errors."""
    view = run.drawing.get("view") or {}
    plots: list[dict[str, Any]] = [
        {"title": ", ".join(wanted), "names": [*wanted]}
        for plot in view.get("plots", ())
        for wanted in [[plot] if isinstance(plot, str) else plot]
        if all(n in names for n in wanted)
    ]
    inputs = [n for n in names if have[n].causality == "input" and np.ptp(run.columns[n]) > 0.0]
    by_unit: dict[str, list[str]] = {}
    for name in [*inputs, *(n for n in outputs if n in names)] if not plots else ():
        by_unit.setdefault(have[name].unit, []).append(name)
    plots += [{"title": "", "names": some[:MOST_LINES]} for some in by_unit.values()][:4]
    if not plots:
        plots += _of_motion(names, run)
    energies = [n for n in ("energy.kinetic", "energy.potential", "energy.total") if n in names]
    if len(energies) == 3:
        plots.append({"title": "Energy", "names": energies})
        taken = [n for n in LOSSES if n in names and np.ptp(run.columns[n]) > 0.0]
        if not taken and "energy.dissipated" in names:
            taken = ["energy.dissipated"]
        stack = [*energies[:2], *taken]
        against = [n for n in ("energy.work",) if n in names]
        title = "Where the energy went"
        plots.append({"title": title, "names": stack, "stack": True, "against": against})
    errors = [n for n in ("energy.error", "constraint.position") if n in names]
    if errors:
        plots.append({"title": "Errors of energy and constraints", "names": errors, "log": True})
    return plots


def _of_motion(names: Sequence[str], run: ReportRun) -> list[dict[str, Any]]:
    """A plot of angles, or else of positions, that move."""
    for ends in ((".angle",), (".x", ".y", ".z")):
        moving = [
            n
            for n in names
            if n.endswith(ends)
            and not n.startswith(("momentum", "angular_momentum"))
            and n.count(".") == 1
            and np.ptp(run.columns[n]) > 1e-9
        ]
        if moving:
            title = "Motion" if len(moving) > 1 else ""  # that of one variable is its name
            return [{"title": title, "names": moving[:MOST_LINES]}]
    return []
