"""Work-precision curves as a picture: error and energy error against CPU time."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from benchmarks.report import Section, Table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

STYLES: dict[str, dict[str, Any]] = {
    "holonom nested": {"color": "tab:blue", "marker": "o"},
    "holonom simultaneous": {"color": "tab:cyan", "marker": "s"},
    "SciPy solve_ivp DOP853": {"color": "tab:red", "marker": "^"},
    "SciPy ode dop853 (compiled)": {"color": "tab:orange", "marker": "v"},
}
ROWS = {"position": "position error at 10 s, m", "energy": "largest |ΔE|, J"}
LEAST = 1e-16
"""An error of exactly zero has no place on a logarithmic axis."""


def draw_work_precision(section: Section, path: Path) -> None:
    """Write a PNG: one column per problem, position error above, energy error below."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    curves = [table for table in section.tables if "position" in table.columns]
    figure = Figure(figsize=(4.2 * len(curves), 6.4), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(len(ROWS), len(curves), sharex="col", squeeze=False)
    for column, table in enumerate(curves):
        axes[0][column].set_title(table.title, fontsize=9)
        axes[-1][column].set_xlabel("CPU time, ms")
        for row, (key, label) in enumerate(ROWS.items()):
            _curves(axes[row][column], table, key)
            if column == 0:
                axes[row][column].set_ylabel(label)
    axes[0][0].legend(fontsize=7)
    figure.savefig(path, dpi=80)


def _curves(axes: Axes, table: Table, key: str) -> None:
    for solver, style in STYLES.items():
        rows = [row for row in table.rows if row["solver"] == solver and row.get("ms")]
        times = [row["ms"] for row in rows]
        errors = [max(float(row[key] or 0.0), LEAST) for row in rows]
        axes.loglog(times, errors, label=solver, markersize=4, linewidth=1, **style)
    axes.grid(visible=True, which="major", alpha=0.3)
