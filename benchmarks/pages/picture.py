"""Work-precision curves as pictures: errors against CPU time, one picture per mechanism."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from benchmarks.pages.report import Section, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

OURS = "holonom"
BLUES = ("#9ecae1", "#6baed6", "#2171b5", "#08306b", "cyan", "darkviolet")
"""Of our curves, in their order."""
OTHERS = (
    "tab:orange", "tab:red", "tab:brown", "tab:green", "tab:olive", "tab:pink",
    "tab:gray", "goldenrod", "black", "teal", "salmon",
)  # fmt: skip
MARKERS = "sD^v<>pPX*h"
ERRORS = {
    "position": "position error, m",
    "velocity": "velocity error, m/s",
    "energy": "energy error, J",
}
LEAST = 1e-17
"""An error of exactly zero has no place on a logarithmic axis."""


def draw(section: Section, path: Path) -> None:
    """Write a PNG of position errors of all mechanisms, and beside it one PNG for each."""
    curves = [table for table in section.tables if "position" in table.columns]
    looks = styles(curves)
    figure, axes = _figure(3, -(-len(curves) // 3))
    for table, panel in zip(curves, axes, strict=False):
        panel.set_title(table.title, fontsize=9)
        draw_curves(panel, table, "position", looks)
        panel.set_xlabel("CPU time, ms", fontsize=8)
    for panel in axes[len(curves) :]:
        panel.axis("off")
    axes[0].set_ylabel(ERRORS["position"])
    figure.legend(*_legend(axes[: len(curves)]), fontsize=7, loc="outside lower center", ncols=5)
    figure.savefig(path, dpi=80)
    for table in curves:
        if table.picture:
            _draw_one(table, path.with_name(table.picture), looks)


def _draw_one(table: Table, path: Path, looks: Mapping[str, Any]) -> None:
    figure, axes = _figure(len(ERRORS), 1)
    figure.suptitle(table.title, fontsize=10)
    for (key, label), panel in zip(ERRORS.items(), axes, strict=True):
        draw_curves(panel, table, key, looks)
        panel.set_ylabel(label)
        panel.set_xlabel("CPU time, ms")
    figure.legend(*_legend(axes[:1]), fontsize=7, loc="outside lower center", ncols=5)
    figure.savefig(path, dpi=80)


def _figure(columns: int, rows: int) -> tuple[Any, list[Any]]:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(4.2 * columns, 3.2 * rows + 0.8), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, list(figure.subplots(rows, columns, squeeze=False).flat)


def _legend(axes: list[Any]) -> tuple[list[Any], list[str]]:
    """Each solver once, whichever panels it is in."""
    known: dict[str, Any] = {}
    for panel in axes:
        for handle, label in zip(*panel.get_legend_handles_labels(), strict=True):
            known.setdefault(label, handle)
    return list(known.values()), list(known)


def styles(tables: Sequence[Table]) -> dict[str, dict[str, Any]]:
    """By solver, the same in all pictures: blue for us, another colour for everybody else."""
    names = dict.fromkeys(str(row["solver"]) for table in tables for row in table.rows)
    ours = [name for name in names if name.startswith(OURS)]
    others = [name for name in names if not name.startswith(OURS)]
    looks: dict[str, dict[str, Any]] = {}
    for i, name in enumerate(ours):
        looks[name] = {"color": BLUES[i % len(BLUES)], "marker": "o", "linewidth": 1.4}
    for i, name in enumerate(others):
        marker = MARKERS[i % len(MARKERS)]
        looks[name] = {"color": OTHERS[i % len(OTHERS)], "marker": marker, "linewidth": 0.8}
    return looks


def draw_curves(axes: Axes, table: Table, key: str, looks: Mapping[str, Any]) -> None:
    """Curve of each solver: an error by its key against CPU time."""
    for solver in dict.fromkeys(str(row["solver"]) for row in table.rows):
        rows = [row for row in table.rows if row["solver"] == solver and row.get("ms")]
        if rows:
            times = [row["ms"] for row in rows]
            errors = [max(float(row[key] or 0.0), LEAST) for row in rows]  # type: ignore[arg-type]
            axes.loglog(times, errors, label=solver, markersize=3, **looks[solver])
    axes.grid(visible=True, which="major", alpha=0.3)
