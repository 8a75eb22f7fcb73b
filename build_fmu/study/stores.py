"""Where a sweep keeps what it has: a CSV file of summaries, or HDF5 with trajectories as well.

Each knows the plan of its sweep, so that an interrupted one goes on where it stopped, and another
one is not mixed into it.
"""

from __future__ import annotations

import contextlib
import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.plan import Plan, Result

if TYPE_CHECKING:
    from numpy import ndarray

LONGEST_REASON = 300
"""Bytes of a reason in HDF5."""


def check_name(path: Path | None) -> None:
    """Refuse a file that cannot hold results, before anything is done to it."""
    if path is not None and path.suffix not in (".csv", ".h5", ".hdf5"):
        text = f"{path}: results go to a .csv, .h5 or .hdf5 file"
        raise UsageError(text)


def store_for(path: Path | None, plan: Plan) -> Store:
    """Store for a file name: none, .csv, .h5 or .hdf5."""
    check_name(path)
    if path is None:
        return Store(plan)
    return CsvStore(plan, path) if path.suffix == ".csv" else Hdf5Store(plan, path)


class Store:
    """Base: results in memory alone."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.results: dict[int, Result] = {}

    def keep(self, result: Result) -> None:
        """Take a result."""
        self.results[result.run] = result

    def close(self) -> None:
        """Finish the file."""


def _plan_of(path: Path) -> dict[str, Any]:
    """Plan that was written; nothing where the file is damaged."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _require_the_same(path: Path, theirs: Mapping[str, Any], ours: Mapping[str, Any]) -> None:
    different = [name for name in ours if ours[name] != theirs.get(name)]
    if different:
        text = (
            f"{path} holds another sweep, with another {', '.join(different)}; name another file, "
            "or begin anew with --fresh"
        )
        raise UsageError(text)


# ----------------------------------------------------------------------------------------- CSV


class CsvStore(Store):
    """One line for each run; what the sweep was stands beside it, in NAME.csv.plan.json."""

    def __init__(self, plan: Plan, path: Path) -> None:
        super().__init__(plan)
        self._path, self._plan_path = path, path.with_name(f"{path.name}.plan.json")
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.is_file() and self._plan_path.is_file():
            _require_the_same(path, _plan_of(self._plan_path), plan.document)
            self._read()
        elif path.is_file():
            text = f"{path} is there and is not one of a sweep; name another file, or --fresh"
            raise UsageError(text)
        self._plan_path.write_text(json.dumps(plan.document, indent=1) + "\n", encoding="utf-8")
        self._file = self._begin(path)

    def _read(self) -> None:
        """Results of the lines that are whole."""
        whole = self._path.read_text(encoding="utf-8").rpartition("\n")[0]
        rows = csv.reader(whole.splitlines())
        next(rows, None)
        for row in rows:
            if len(row) != len(self.plan.columns):
                continue
            with contextlib.suppress(ValueError):  # what cannot be read is run again
                result = self.plan.result_of(row)
                self.results[result.run] = result

    def _begin(self, path: Path) -> TextIO:
        """File with what is known, in the order of the runs."""
        other = path.with_name(f".{path.name}.new")
        with other.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.plan.columns)
            writer.writerows(self.plan.row(self.results[run]) for run in sorted(self.results))
        other.replace(path)
        return path.open("a", newline="", encoding="utf-8")

    def keep(self, result: Result) -> None:
        """Write the line of a result at once."""
        super().keep(result)
        csv.writer(self._file, lineterminator="\n").writerow(self.plan.row(result))
        self._file.flush()

    def close(self) -> None:
        """Put the lines into the order of the runs."""
        self._file.close()
        self._begin(self._path).close()


# ---------------------------------------------------------------------------------------- HDF5


class Hdf5Store(Store):
    """Data sets `runs` (a line for each run), `time`, and `trajectories/NAME` (runs, points).

    All have their size from the beginning: what is written later changes no structure of the file,
    and an interrupted sweep leaves one that can be read.
    """

    def __init__(self, plan: Plan, path: Path) -> None:
        try:
            import h5py  # pyright: ignore[reportMissingImports]
        except ImportError:
            text = "the package h5py is missing; install it: pip install holonom[hdf5]"
            raise EnvironmentLackError(text) from None
        super().__init__(plan)
        path.parent.mkdir(parents=True, exist_ok=True)
        there = path.is_file()
        try:
            # What h5py says that a name may stand for is more than a data set; here it is one.
            self._file: Any = h5py.File(path, "r+" if there else "w")
        except OSError as error:
            text = f"{path}: cannot be opened ({error}); name another file, or --fresh"
            raise UsageError(text) from None
        if there:
            theirs = json.loads(self._file.attrs.get("plan", "{}"))
            try:
                _require_the_same(path, theirs, plan.document)
            except UsageError:
                self._file.close()
                raise
            self._read()
        else:
            self._create(h5py)

    def _create(self, h5py: Any) -> None:
        import numpy as np

        plan = self.plan
        runs = np.zeros(plan.count, plan.dtype(LONGEST_REASON))
        self._file.attrs["plan"] = json.dumps(plan.document)
        self._file.create_dataset("runs", data=runs)
        self._file.create_dataset("time", data=np.array(plan.times)).attrs["unit"] = "s"
        early = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        early.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
        early.set_fill_value(np.array(np.nan))
        group = self._file.create_group("trajectories")
        space = h5py.h5s.create_simple((plan.count, len(plan.times)))
        for name in plan.outputs:
            h5py.h5d.create(group.id, name.encode(), h5py.h5t.IEEE_F64LE, space, early)
            group[name].attrs["unit"] = plan.units.get(name, "")
        self._file.flush()

    def _at(self, name: str, run: int) -> ndarray:
        return self._file["trajectories"][name][run - 1]

    def _read(self) -> None:
        import numpy as np

        for row in self._file["runs"][:]:
            if row["run"]:
                cells = [x.decode() if isinstance(x, bytes) else str(x.item()) for x in row]
                result = self.plan.result_of(cells)
                values = np.stack([self._at(name, result.run) for name in self.plan.outputs], 1)
                self.results[result.run] = replace(result, values=values)

    def keep(self, result: Result) -> None:
        """Write trajectory and line of a result."""
        at = result.run - 1
        if result.values is not None:
            for name, column in zip(self.plan.outputs, result.values.T, strict=True):
                self._file["trajectories"][name][at, : len(column)] = column
        self._file["runs"][at] = self.plan.record(result, LONGEST_REASON)
        self._file.flush()
        super().keep(result)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def remove(path: Path | None) -> None:
    """Remove a sweep's files, to begin anew."""
    for each in _files(path):
        each.unlink(missing_ok=True)


def _files(path: Path | None) -> Iterable[Path]:
    return () if path is None else (path, path.with_name(f"{path.name}.plan.json"))


def by_run(results: Mapping[int, Result]) -> Sequence[Result]:
    """Results in the order of the runs."""
    return [results[run] for run in sorted(results)]
