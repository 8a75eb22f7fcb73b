"""A live page: a mechanism is stepped in real time, and pages on this machine show and steer it.

The session runs in one thread, which alone touches the mechanism and the list of pages; the threads
of `live_server` put commands into its queue and hand on what it sends (server-sent events).
"""

from __future__ import annotations

import base64
import json
import math
import queue
import time
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from solver.runtime.errors import is_double, shown
from viewer.packing import channels
from viewer.report import FORMAT, ReportRun, default_plots, described, filled, ordered

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from solver.runtime import Variable

RATE = 60.0
"""Turns of a session in a second, and least steps while it plays: longer ones would jerk."""
LAG = 0.25
"""Longest time in s by which a session is behind the clock: so much of a pause of a busy machine it
makes up for."""
BUSY = 0.05
"""Longest time in s that one turn may step: then it looks for commands."""
GRACE = 2.0
"""Time in s without a page after which a session ends: a page that is loaded again is back."""
MOST_WAITING = 120
"""Rows that wait for one page; a page that is slower misses some."""
PREVIEW_ROWS, PREVIEW_TIME = 60, 0.5
"""Rows of the rehearsal that a page gets, and how long in s of the clock it may take."""


SPEEDS = 1e-6, 1e6
"""Slowest and fastest, times the clock: beyond them a turn would count steps without end."""


class StoppedError(Exception):
    """The mechanism cannot go on; the text says why."""


class Source(Protocol):
    """What is stepped. Its methods raise `StoppedError`."""

    start_time: float
    stop_time: float
    """Of the experiment, as far as the rehearsal goes; a session goes on behind it."""
    step_size: float

    @property
    def columns(self) -> Sequence[str]:
        """Names of the values of a row."""
        ...

    def begin(self, values: Mapping[str, float]) -> NDArray[np.float64]:
        """Begin anew with these parameters and inputs; the first row."""
        ...

    def set(self, name: str, value: float) -> None:
        """Change an input or a tunable parameter."""
        ...

    def step(self, time: float, step: float) -> NDArray[np.float64]:
        """Make a step from a time on, in s; the row at its end."""
        ...

    def drawing(self, values: Mapping[str, float]) -> Mapping[str, Any]:
        """Return the drawing with these values."""
        ...


class Session:
    """A mechanism in motion, its commands and its pages.

    Commands are ``{"play": true}``, ``{"speed": 0.5}``, ``{"set": {name: value}}``,
    ``{"step": true}``, ``{"reset": true}`` and ``{"original": true}``.
    """

    def __init__(
        self, source: Source, controls: Sequence[Mapping[str, Any]],
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:  # fmt: skip
        self._source, self._clock = source, clock
        self._at_once = {c["name"]: bool(c["live"]) for c in controls}
        self._original = {c["name"]: float(c["start"]) for c in controls}
        self.values: dict[str, float] = {}
        self.playing, self.speed, self.time, self.reason = False, 1.0, source.start_time, ""
        self._base = self._from = 0.0
        self._row: NDArray[np.float64] | None = None
        self._commands: queue.Queue[tuple[str, Any]] = queue.Queue()
        self._pages: list[queue.Queue[bytes | None]] = []
        self._alone_since = math.inf

    # ------------------------------------------------------------------ for the threads of pages

    def mistake(self, command: Any) -> str:
        """Sentence about a command that cannot be obeyed; empty if it can be."""
        values = command.get("set", {}) if isinstance(command, dict) else None
        if not isinstance(values, dict):
            return 'a command is an object, such as {"set": {"torque": 1}}'
        for name in values:
            if name not in self._at_once:
                return f"{name}: no input or parameter of this mechanism"
        for name, value in [*values.items(), ("speed", command.get("speed", 1.0))]:
            if type(value) is bool or not is_double(value) or not math.isfinite(value):
                return f"{name}: must be a number, got {shown(value)}"
        slowest, fastest = SPEEDS
        fits = slowest <= command.get("speed", 1.0) <= fastest
        return "" if fits else f"speed: must be from {slowest:g} to {fastest:g}"

    def do(self, command: Mapping[str, Any]) -> None:
        """Obey a command at the next turn."""
        self._commands.put(("do", command))

    def join(self) -> queue.Queue[bytes | None]:
        """Queue of what a new page is sent; None is its end."""
        page: queue.Queue[bytes | None] = queue.Queue()
        self._commands.put(("join", page))
        return page

    def leave(self, page: queue.Queue[bytes | None]) -> None:
        """Forget a page that was closed."""
        self._commands.put(("leave", page))

    # ------------------------------------------------------------------ for the one thread

    @property
    def ended(self) -> bool:
        """Whether the last page was closed."""
        return self._clock() - self._alone_since > GRACE

    def rehearse(self) -> tuple[list[float], list[NDArray[np.float64]]]:
        """Times and rows ahead, as far as a short time suffices: what to plot, how far it goes."""
        begun, times, rows = self._clock(), [self.time], [self._source.begin(self.values)]
        step = self._source.step_size
        try:
            while times[-1] < self._source.stop_time and self._clock() - begun < PREVIEW_TIME:
                rows.append(self._source.step(times[-1], step))
                times.append(times[-1] + step)
        except StoppedError:
            pass  # it is said when the run comes there
        return times, rows

    def turn(self) -> None:
        """Obey commands, go on as far as the clock says, and send the row that was reached."""
        begun, restart, single = self._clock(), self._row is None, False
        while not self._commands.empty():
            kind, what = self._commands.get_nowait()
            if kind == "do":
                restart, single = self._obey(what, restart), single or bool(what.get("step"))
            elif kind == "join":
                self._pages.append(what)
                self._alone_since = math.inf
                self._greet([what])
            elif what in self._pages:
                self._pages.remove(what)
                self._alone_since = math.inf if self._pages else self._clock()
        if restart:
            self._restart()
        before, late = self.time, False
        try:
            if single and not self.reason:
                self._step(self._source.step_size)
            elif self.playing:
                late = self._catch_up(begun)
        except StoppedError as stopped:
            self._stop(str(stopped))
        if self.time != before:
            self._send("row", self._state() | {"late": late})

    def say(self, text: str) -> None:
        """Show a sentence on all pages."""
        self._send("said", {"text": text})

    def close(self, *, anew: bool = False) -> None:
        """Tell all pages that it is over, or that they have to be loaded anew."""
        if anew:
            self._send("anew", {})
        for page in self._pages:
            page.put(None)

    def _obey(self, command: Mapping[str, Any], restart: bool) -> bool:
        """Obey; whether it has to begin anew."""
        if command.get("original"):
            self.values = {}
        for name, value in command.get("set", {}).items():
            self.values[name] = float(value)
            if not self._at_once[name] or self.reason:
                restart = True
            elif not restart:
                try:
                    self._source.set(name, float(value))
                except StoppedError as stopped:
                    self._stop(str(stopped))
        self.speed = float(command.get("speed", self.speed))
        if {"play", "step"} & command.keys():
            self.playing = bool(command.get("play")) and not self.reason
        if {"play", "step", "speed"} & command.keys():
            self._rebase()
            self._send("state", {"playing": self.playing, "speed": self.speed})
        return restart or bool(command.get("reset") or command.get("original"))

    def _restart(self) -> None:
        self.time, self.reason = self._source.start_time, ""
        try:
            self._row = self._source.begin(self.values)
        except StoppedError as stopped:
            self._stop(str(stopped))
        else:
            self._rebase()
            self._greet(self._pages)

    def _rebase(self) -> None:
        self._base, self._from = self._clock(), self.time

    def _step(self, step: float) -> None:
        self._row = self._source.step(self.time, step)
        self.time += step

    def _catch_up(self, begun: float) -> bool:
        """Step up to the time of the clock; whether that is out of reach."""
        target = self._from + (begun - self._base) * self.speed
        size = self._source.step_size
        step = size / math.ceil(size * RATE / self.speed)
        while self.time + step <= target:
            if self._clock() - begun >= BUSY:
                late = target - self.time > LAG * self.speed
                if late:
                    self._base, self._from = begun, self.time + LAG * self.speed
                return late
            self._step(step)
        return False

    def _stop(self, reason: str) -> None:
        self.reason, self.playing = reason, False
        self._send("failed", {"time": self.time, "reason": reason})

    def _state(self) -> dict[str, Any]:
        assert self._row is not None
        return {"time": self.time, "values": _text(self._row)}

    def _greet(self, pages: Sequence[queue.Queue[bytes | None]]) -> None:
        if self._row is None or not pages:
            return
        now = {
            "drawing": self._source.drawing(self.values),
            "set": self._original | self.values,
            "playing": self.playing,
            "speed": self.speed,
        }
        self._send("start", now | self._state(), pages)
        if self.reason:
            self._send("failed", {"time": self.time, "reason": self.reason}, pages)

    def _send(
        self, kind: str, data: Mapping[str, Any],
        pages: Sequence[queue.Queue[bytes | None]] | None = None,
    ) -> None:  # fmt: skip
        text = f"event: {kind}\ndata: {json.dumps(data)}\n\n".encode()
        for page in self._pages if pages is None else pages:
            if kind != "row" or page.qsize() < MOST_WAITING:
                page.put(text)


def _text(row: NDArray[np.float64]) -> str:
    return base64.b64encode(np.asarray(row, "<f4").tobytes()).decode()


def live_page(
    session: Session, source: Source, controls: Sequence[Mapping[str, Any]], *, name: str,
    description: str, variables: Sequence[Variable], outputs: Sequence[str],
    warnings: Sequence[str] = (),
) -> str:  # fmt: skip
    """Text of the page, with a rehearsal of the run: its plots, and how far the mechanism goes."""
    times, rows = session.rehearse()
    drawing = source.drawing(session.values)
    columns = dict(zip(source.columns, np.array(rows).T, strict=True))
    run = ReportRun(drawing, np.array(times), columns)
    have = {v.name: v for v in variables if v.name in columns}
    frames, kinds = channels(drawing)
    shown = range(0, len(rows), math.ceil(len(rows) / PREVIEW_ROWS))
    data = {
        "format": FORMAT,
        "name": name,
        "description": description,
        "drawings": [drawing],
        "kinds": kinds,
        "variables": [described(v) for v in variables],
        "plots": default_plots(ordered([*have], outputs, have), outputs, have, run),
        "runs": [{}],
        "notes": [],
        "warnings": [*warnings],
        "live": {
            "controls": [*controls],
            "span": source.stop_time - source.start_time,
            "columns": [*source.columns],
            "frames": frames,
            "preview": [{"time": times[k], "values": _text(rows[k])} for k in shown],
        },
    }
    return filled(data, connect="'self'")
