"""Largest steps that survive, as a picture: a row for each solver, a dot for each setting."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.pages.report import Section, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COLOURS = {"conserving": "tab:blue", "midpoint": "tab:red", "penalty": "tab:orange"}
PEERS = "tab:gray"
SIZES = (70.0, 45.0, 28.0, 16.0, 8.0)
"""Of the dots: the softest penalty or spring has the largest."""
LEAST, RANGE = 7e-4, (5e-4, 1.5)
"""Place of the crosses, and steps that are shown [s]."""


def draw(section: Section, path: Path) -> None:
    """Write a PNG: one panel per mechanism; a cross where no step of the grid survived."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    maps = [table for table in section.tables if "above" in table.columns]
    figure = Figure(figsize=(11.0, 3.1 * ((len(maps) + 1) // 2)), layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots((len(maps) + 1) // 2, 2, squeeze=False).ravel()
    for axes, table in zip(panels, maps, strict=False):
        _panel(axes, table)
    for axes in panels[len(maps) :]:
        axes.set_axis_off()
    figure.savefig(path, dpi=80)


def _panel(axes: Axes, table: Table) -> None:
    rows = [(f"{row['solver']} {row['setting']}", row) for row in table.rows]
    names = list(dict.fromkeys(name for name, _ in rows))
    for place, name in enumerate(names):
        same = [row for other, row in rows if other == name]
        kind = str(same[0]["setting"]).partition("-")[0]
        colour = COLOURS.get(kind, PEERS)
        for row, size in zip(same, SIZES, strict=False):
            if row["h"]:
                axes.scatter(float(row["h"]), place, s=size, facecolors="none", edgecolors=colour)
            else:
                axes.scatter(LEAST, place, s=size, marker="x", color=colour)
    axes.set_xscale("log")
    axes.set_xlim(*RANGE)
    axes.set_yticks(range(len(names)), [n.removeprefix("holonom ") for n in names], fontsize=7)
    axes.invert_yaxis()
    axes.set_xlabel("largest step that survives, s", fontsize=8)
    axes.set_title(table.title, fontsize=9)
    axes.grid(visible=True, axis="x", alpha=0.3)
