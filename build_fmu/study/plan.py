"""What a sweep is to do, and the table of what it finds: one row for each run."""

from __future__ import annotations

import hashlib
import json
import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from build_fmu.errors import UsageError
from build_fmu.study.csv_tables import column_name

if TYPE_CHECKING:
    from numpy import dtype, ndarray

OWN_COLUMNS = ("run", "finished", "end_time", "reason")
OF_OUTPUTS = ("final", "min", "max")
_KINDS = {bool: "?", str: "text"}
"""Of values in a table, by their type; other values are numbers."""


@dataclass(frozen=True)
class Result:
    """One run: what is kept of each output, and the trajectory where that is wanted."""

    run: int
    """From 1, in the order of the rows."""
    end_time: float
    reason: str
    """Why it ended early; empty if it did not."""
    summary: Sequence[float]
    """Last, smallest and largest value of each output; NaN where there is none."""
    values: ndarray | None = None
    """Shape (points, outputs)."""
    warnings: tuple[str, ...] = ()
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
    def leading(self) -> int:
        """Number of columns that the plan knows: those of the run and of what is varied."""
        return 1 + len(self.rows[0])

    @property
    def no_summary(self) -> list[float]:
        """Summary of a run without outputs."""
        return [math.nan] * (len(OF_OUTPUTS) * len(self.outputs))

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

    @cached_property
    def columns(self) -> list[str]:
        """Head of the table."""
        varied = [column_name(name, OWN_COLUMNS) for name in self.rows[0]]
        of_outputs = [f"{name}.{what}" for name in self.outputs for what in OF_OUTPUTS]
        return ["run", *varied, *OWN_COLUMNS[1:], *of_outputs]

    def check_columns(self, trajectories: bool) -> None:
        """Refuse names that results would have twice; trajectories are columns as well."""
        names = [*self.columns, *(["time", *self.outputs] if trajectories else [])]
        twice = [name for name, count in Counter(names).items() if count > 1]
        if twice:
            text = f"the results would have two columns {', '.join(map(repr, twice))}: leave the "
            raise UsageError(text + "output of this name out, or do not vary its parameter")

    def lead(self, at: int) -> tuple[Any, ...]:
        """Row of the table as far as the plan knows it: number and values, in one order for all."""
        row = self.rows[at]
        return at + 1, *(row[name] for name in self.rows[0])

    def dtype(self, text: str = "O") -> dtype:
        """Type of a row of the table, with texts of this type."""
        import numpy as np

        varied = [_KINDS.get(type(value), "f8") for value in self.rows[0].values()]
        kinds = ["i8", *varied, "?", "f8", "text", *("f8" for _ in self.no_summary)]
        columns = zip(self.columns, kinds, strict=True)
        return np.dtype([(name, text if kind == "text" else kind) for name, kind in columns])

    def table(self) -> ndarray:
        """Table of all runs, with what the plan knows of them and no results."""
        import numpy as np

        none = (False, math.nan, "", *self.no_summary)
        rows = [(*self.lead(at), *none) for at in range(self.count)]
        return np.array(rows, self.dtype())
