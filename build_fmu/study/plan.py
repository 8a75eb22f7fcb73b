"""What a sweep is to do, and what it found: the columns of its summary, one row for each run."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError

if TYPE_CHECKING:
    from numpy import dtype, ndarray

OWN_COLUMNS = ("run", "finished", "end_time", "reason")
OF_OUTPUTS = ("final", "min", "max")


@dataclass(frozen=True)
class Result:
    """One run: what is kept of each output, and the trajectory where that is wanted."""

    run: int
    """From 1, in the order of the rows."""
    end_time: float
    reason: str
    """Why it ended early; empty if it did not."""
    summary: Sequence[Sequence[float]]
    """Last, smallest and largest value of each output; NaN where there is none."""
    values: ndarray | None = field(default=None, repr=False, compare=False)
    """Shape (points, outputs)."""
    warnings: tuple[str, ...] = field(default=(), repr=False, compare=False)
    """What the FMU said besides; files do not have it."""


@dataclass(frozen=True)
class Plan:
    """One FMU, and the values of each run."""

    fmu: str
    digest: str
    """SHA-256 of the archive."""
    rows: Sequence[dict[str, Any]]
    fixed: dict[str, Any]
    """Values of all runs."""
    outputs: Sequence[str]
    times: Sequence[float]
    """Communication points, s."""
    units: dict[str, str]

    @property
    def count(self) -> int:
        """Number of runs."""
        return len(self.rows)

    @property
    def names(self) -> list[str]:
        """What is varied."""
        return list(self.rows[0])

    @property
    def leading(self) -> int:
        """Number of columns that the plan knows: those of the run and of what is varied."""
        return 1 + len(self.names)

    @cached_property
    def document(self) -> dict[str, Any]:
        """What two sweeps must have in common for one to go on where the other stopped."""
        rows, times = (json.dumps(list(x)).encode() for x in (self.rows, self.times))
        return {
            "FMU": {"name": self.fmu, "sha256": self.digest},
            "values": {"runs": self.count, "sha256": hashlib.sha256(rows).hexdigest()},
            "settings": self.fixed,
            "outputs": list(self.outputs),
            "times": {
                "start": self.times[0],
                "stop": self.times[-1],
                "points": len(self.times),
                "sha256": hashlib.sha256(times).hexdigest(),
            },
        }

    @property
    def columns(self) -> list[str]:
        """Head of the summary."""
        # A parameter may have the name of a column.
        varied = [f"{name} (parameter)" if name in OWN_COLUMNS else name for name in self.names]
        of_outputs = [f"{name}.{what}" for name in self.outputs for what in OF_OUTPUTS]
        return ["run", *varied, *OWN_COLUMNS[1:], *of_outputs]

    def check_columns(self, trajectories: bool) -> None:
        """Refuse names that results would have twice; trajectories are columns as well."""
        names = [*self.columns, *(["time", *self.outputs] if trajectories else [])]
        twice = [name for name, count in Counter(names).items() if count > 1]
        if twice:
            text = f"the results would have two columns {', '.join(map(repr, twice))}: leave the "
            raise UsageError(text + "output of this name out, or do not vary its parameter")

    def record(self, result: Result, longest: int | None = None) -> tuple[Any, ...]:
        """Row of the summary; texts as bytes of at most this length, for HDF5."""
        numbers = [number for each in result.summary for number in each]
        row = self.rows[result.run - 1]
        cells = [result.run, *(row[name] for name in self.names), not result.reason]
        cells += [result.end_time, result.reason]
        texts = [_text(cell) if isinstance(cell, str | list) else cell for cell in cells]
        if longest is not None:
            texts = [_cut(x, longest) if isinstance(x, str) else x for x in texts]
        return (*texts, *numbers)

    def row(self, result: Result) -> list[str]:
        """Line of a CSV file; numbers read back as the same."""
        return [x if isinstance(x, str) else json.dumps(x) for x in self.record(result)]

    def result_of(self, row: Sequence[str]) -> Result:
        """Result of a line, without its trajectory; ValueError where it is none."""
        own = self.leading
        numbers = [float(text) for text in row[own + 3 :]]
        summary = [numbers[i : i + 3] for i in range(0, len(numbers), 3)]
        run, end = int(row[0]), float(row[own + 1])
        if not 1 <= run <= self.count:
            text = f"there is no run {run}"
            raise ValueError(text)
        return Result(run, end, row[own + 2], summary)

    def dtype(self, longest: int | None = None) -> dtype:
        """Type of a row of the summary; of texts, bytes for HDF5, else objects."""
        import numpy as np

        kinds = ["i8", *map(self._kind, self.names), "?", "f8", "text"]
        kinds += ["f8"] * (len(OF_OUTPUTS) * len(self.outputs))
        text = "O" if longest is None else f"S{longest}"
        columns = zip(self.columns, kinds, strict=True)
        return np.dtype([(name, text if kind == "text" else kind) for name, kind in columns])

    def _kind(self, name: str) -> str:
        values = [row[name] for row in self.rows]
        if all(isinstance(value, bool) for value in values):
            return "?"
        number = all(isinstance(x, int | float) and not isinstance(x, bool) for x in values)
        return "f8" if number else "text"

    def arrays(self, results: Sequence[Result]) -> dict[str, ndarray]:
        """Trajectories by output, shape (runs, points), NaN where a run did not come."""
        import numpy as np

        whole = np.full((len(results), len(self.times), len(self.outputs)), np.nan)
        for at, result in enumerate(results):
            if result.values is not None:
                whole[at, : len(result.values)] = result.values
        return {name: whole[:, :, i] for i, name in enumerate(self.outputs)}

    def table(self, results: Sequence[Result]) -> ndarray:
        """Structured array of the summary."""
        import numpy as np

        return np.array([self.record(result) for result in results], self.dtype())


def _text(cell: object) -> str:
    return cell if isinstance(cell, str) else json.dumps(cell)


def _cut(text: str, longest: int) -> bytes:
    return text.encode()[:longest].decode(errors="ignore").encode()
