"""Plots of runs over time and of sweeps over what was varied, drawn by matplotlib.

A notebook's summary of a run has a small curve, which is SVG and needs no package.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from html import escape
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from solver.extras import imported
from solver.files import written_whole
from solver.runtime import OptionError
from solver.scene.words import did_you_mean

if TYPE_CHECKING:
    from matplotlib.figure import Figure  # pyright: ignore[reportMissingImports]

FORMATS = (".png", ".svg", ".pdf")
ERRORS = ("energy.error", "constraint.position")
"""What says how exact a run is."""
MOST = 24
"""Curves, or plots of a sweep, that one figure shows; more are not told apart."""
MOST_TICKS = 9
"""Values along an axis of a heat map that are all written there."""
POINTS = 120
"""Of a small curve."""


class Variable(Protocol):
    """What a model or an FMU says of a variable."""

    @property
    def name(self) -> str:
        """Its name."""
        ...

    @property
    def unit(self) -> str | None:
        """Its unit, as the scene has it."""
        ...

    @property
    def causality(self) -> str:
        """Its causality, a word of FMI."""
        ...


def chosen(
    names: Iterable[str],
    patterns: Sequence[str] | str | None = None,
    variables: Iterable[Variable] = (),
) -> list[str]:
    """Names that patterns choose, in their order; the scene's own outputs where there are none.

    Only names of a scene's own outputs have no dot. A scene without them shows energies and errors;
    what has neither shows its first variables.

    Raises
    ------
    OptionError
        If a pattern matches no name, or there are no names.
    """
    names = list(names)
    if patterns is None:
        inputs = {v.name for v in variables if v.causality == "input"}
        own = [name for name in names if "." not in name and name not in inputs]
        usual = [name for name in names if name.startswith("energy.") or name in ERRORS]
        return (own or usual or names)[:MOST]
    patterns = [patterns] if isinstance(patterns, str) else patterns
    found: dict[str, None] = {}
    for pattern in patterns:
        matches = [name for name in names if name == pattern or fnmatchcase(name, pattern)]
        if not matches:
            help = did_you_mean(pattern, names, "variables are")
            text = f"plot: {pattern!r} matches none of the {len(names)} variables"
            raise OptionError(f"{text}; {help}" if help else text)
        found |= dict.fromkeys(matches)
    return list(found)


def over_time(
    t: np.ndarray,
    columns: Mapping[str, np.ndarray],
    variables: Sequence[Variable],
    names: Sequence[str] | str | None = None,
    title: str = "",
) -> Figure:
    """Figure of variables over the time t [s]: one plot for each unit, all with the same times."""
    units = {v.name: v.unit or "" for v in variables}
    by_unit: dict[str, list[str]] = {}
    for name in chosen(columns, names, variables):
        by_unit.setdefault(units.get(name, ""), []).append(name)
    _few(sum(map(len, by_unit.values())))
    figure, axes = _figure(len(by_unit), 1, title, sharex=True)
    for (unit, group), plot in zip(by_unit.items(), axes, strict=True):
        for name in group:
            plot.plot(t, columns[name], label=name)
        plot.set_ylabel(f"[{unit}]" if unit else "")
        plot.legend(fontsize="small", loc="center left", bbox_to_anchor=(1.0, 0.5))
        plot.grid(alpha=0.3)
    axes[-1].set_xlabel("t [s]")
    return figure


def require_few_parameters(names: Sequence[str]) -> None:
    """Refuse to plot over more than two parameters."""
    if len(names) > 2:
        text = f"plot: {len(names)} parameters are varied, {', '.join(names)}; a plot shows one "
        raise OptionError(text + "(curves) or two (heat maps): set the others to one value")


def over_values(
    varied: Mapping[str, Sequence[Any]],
    results: Mapping[str, np.ndarray],
    units: Mapping[str, str],
    names: Sequence[str] | str | None = None,
    title: str = "",
) -> Figure:
    """Figure of a sweep, a plot for each output.

    Parameters
    ----------
    varied
        Values of the parameters by name, one for each run. Over one parameter each output is a
        curve of its last value, in a band from its smallest to its largest; over two it is a heat
        map of its last value.
    results
        By output its last, smallest and largest values, shape (3, runs); NaN where a run failed.
    units
        Of parameters and outputs.

    Raises
    ------
    OptionError
        If more than two parameters are varied, two of them do not form a full grid, or a name or
        pattern matches no output.
    """
    require_few_parameters(list(varied))
    shown = chosen(results, names)
    _few(len(shown))
    scales = [_Scale(name, units.get(name, ""), values) for name, values in varied.items()]
    if len(scales) == 1:
        figure, axes = _figure(len(shown), 1, title, sharex=True)
        for name, plot in zip(shown, axes, strict=True):
            _curve(plot, scales[0], results[name])
            plot.set_ylabel(_label(name, units))
        axes[0].legend(fontsize="small", loc="center left", bbox_to_anchor=(1.0, 0.5))
        scales[0].label(axes[-1], "x")
        return figure
    across, up = scales
    if len(across.values) * len(up.values) != len(set(zip(across.at, up.at, strict=True))):
        text = f"plot: the runs are no full grid of {across.name} and {up.name}, which a heat map "
        raise OptionError(text + "needs; give both with --grid")
    figure, axes = _figure(-(-len(shown) // 2), min(len(shown), 2), title)
    for name, plot in zip(shown, axes, strict=False):
        cells = np.full((len(up.values), len(across.values)), np.nan)
        cells[up.at, across.at] = results[name][0]
        mesh = plot.pcolormesh(across.edges, up.edges, cells)
        figure.colorbar(mesh, ax=plot, label=f"{_label(name, units)} at the end")
        for axis, scale in (("x", across), ("y", up)):
            scale.label(plot, axis)
            if scale.words is None and not scale.is_geometric and len(scale.values) <= MOST_TICKS:
                plot.set(**{f"{axis}ticks": scale.places})  # where the cells are
        if np.isnan(cells).any():
            plot.patch.set(hatch="///", facecolor="0.95", edgecolor="0.7")
            plot.text(1.0, 1.01, "hatched: failed", ha="right", va="bottom", fontsize="small",
                      transform=plot.transAxes)  # fmt: skip
    for plot in axes[len(shown) :]:
        plot.remove()
    return figure


def save(figure: Figure, path: str | PathLike[str]) -> None:
    """Write a figure as its suffix says, else as PNG; the same figure gives the same bytes."""
    form = Path(path).suffix.lower().removeprefix(".") or "png"
    dated = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}
    how = {"format": form, "metadata": dated.get(form), "bbox_inches": "tight", "dpi": 150}
    salted = imported("matplotlib", "plot").rc_context({"svg.hashsalt": "holonom"})
    with salted, written_whole(path) as file:
        figure.savefig(file, **how)


def summary_html(
    t: np.ndarray,
    columns: Mapping[str, np.ndarray],
    variables: Sequence[Variable],
    title: str = "",
) -> str:
    """Facts of a run and a small curve of its first variable of interest, as HTML."""
    facts = {
        "rows": str(len(t)),
        "variables": str(len(columns)),
        "duration": f"{t[-1] - t[0]:g} s" if len(t) else "0 s",
    }
    names = {"energy.error": "largest energy error", "constraint.position": "largest residual"}
    for name, words in names.items():
        if name in columns and len(t):
            facts[words] = f"{np.abs(columns[name]).max():.2e}"
    rows = [f"<tr><th>{words}</th><td>{value}</td></tr>" for words, value in facts.items()]
    shown = chosen(columns, None, variables)[0]
    caption = f"<caption>{escape(title)}</caption>" if title else ""
    curve = f"<tr><th>{escape(shown)}</th><td>{_sparkline(t, columns[shown])}</td></tr>"
    return f"<table>{caption}{''.join(rows)}{curve}</table>"


def _sparkline(t: np.ndarray, values: np.ndarray, width: int = 160, height: int = 32) -> str:
    """Small curve as SVG, in the colour of the text; values that are not finite leave it out."""
    known = np.isfinite(values)
    t, values = t[known], values[known]
    kept = np.unique(np.linspace(0, len(t) - 1, POINTS).astype(int)) if len(t) else []
    points = ""
    if len(t):
        x = (t[kept] - t[0]) / (np.ptp(t) or 1.0) * (width - 2) + 1
        y = height - 1 - (values[kept] - values.min()) / (np.ptp(values) or 1.0) * (height - 2)
        points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
    line = f'<polyline points="{points}" fill="none" stroke="currentColor"/>'
    return f'<svg width="{width}" height="{height}" role="img">{line}</svg>'


class _Scale:
    """Values of one parameter along an axis: numbers as they are, words side by side."""

    def __init__(self, name: str, unit: str, given: Sequence[Any]) -> None:
        """Sort the values; `at` is the place of each run among them."""
        self.name, self.unit = name, unit
        numbers = all(isinstance(x, int | float) and not isinstance(x, bool) for x in given)
        self.values = sorted(set(given)) if numbers else list(dict.fromkeys(given))
        self.at = [self.values.index(x) for x in given]
        self.words = None if numbers else [str(x) for x in self.values]
        self.places = np.array(self.values if numbers else range(len(self.values)), float)

    @property
    def is_geometric(self) -> bool:
        """Whether each value is a fixed multiple of the one before, as of a range with `log`."""
        if len(self.places) < 3 or not (self.places > 0).all():
            return False
        return bool(np.ptp(np.diff(np.log(self.places))) < 1e-6) and self.words is None

    @property
    def edges(self) -> np.ndarray:
        """Edges of a cell about each value, in the middle between two, shape (len(values) + 1,).

        Of a geometric scale they are geometric means: edges at 0 and below have no logarithm.
        """
        x = np.log(self.places) if self.is_geometric else self.places
        between = (x[1:] + x[:-1]) / 2.0
        half = np.diff(x)[[0, -1]] / 2.0 if len(x) > 1 else np.array([0.5, 0.5])
        edges = np.array([x[0] - half[0], *between, x[-1] + half[1]])
        return np.exp(edges) if self.is_geometric else edges

    def label(self, plot: Any, axis: str) -> None:
        """Write name, unit and words at the "x" or "y" axis, whose scale is that of the values."""
        plot.set(**{f"{axis}label": _label(self.name, {self.name: self.unit})})
        if self.words:
            plot.set(**{f"{axis}ticks": self.places, f"{axis}ticklabels": self.words})
        elif self.is_geometric:
            plot.set(**{f"{axis}scale": "log"})


def _curve(plot: Any, scale: _Scale, values: np.ndarray) -> None:
    """Last values over the parameter, in the band of all values."""
    order = np.argsort(scale.at, kind="stable")
    places = scale.places[np.array(scale.at)[order]]
    last, least, most = values[:, order]
    plot.fill_between(places, least, most, alpha=0.2, label="smallest to largest")
    plot.plot(places, last, marker=".", label="at the end")
    plot.grid(alpha=0.3)


def _figure(rows: int, columns: int, title: str, **shared: Any) -> tuple[Figure, list[Any]]:
    """Figure with plots in rows, none of which any window manager knows."""
    imported("matplotlib", "plot")
    from matplotlib.figure import Figure  # pyright: ignore[reportMissingImports]

    size = (6.4 * columns, max(3.2, 2.2 * rows + 0.6) if columns == 1 else 4.2 * rows)
    figure = Figure(figsize=size, layout="constrained")
    figure.suptitle(title)
    return figure, list(figure.subplots(rows, columns, squeeze=False, **shared).flat)


def _label(name: str, units: Mapping[str, str]) -> str:
    return f"{name} [{units[name]}]" if units.get(name) else name


def _few(count: int) -> None:
    if count > MOST:
        text = f"plot: {count} variables are more than the {MOST} that one figure shows; name fewer"
        raise OptionError(text)
