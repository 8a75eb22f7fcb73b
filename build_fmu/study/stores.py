"""Where a sweep keeps what it has: a CSV file of summaries, or HDF5 with trajectories as well.

Each knows the plan of its sweep, so that an interrupted one goes on where it stopped, and another
one is not mixed into it.
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.lock import LOCKS, lock
from build_fmu.study.plan import Plan, Result

if TYPE_CHECKING:
    from numpy import ndarray

LONGEST_REASON = 300
"""Bytes of a reason in HDF5."""
REMEDY = "name another file, or begin anew with --fresh"


def check_name(path: Path | None) -> None:
    """Refuse a file that cannot hold results, before anything is done to it."""
    if path is not None and path.suffix not in (".csv", ".h5", ".hdf5"):
        text = f"{path}: results go to a .csv, .h5 or .hdf5 file"
        raise UsageError(text)


def holds_trajectories(path: Path | None) -> bool:
    """Whether a file of this name has more than the summary."""
    return path is not None and path.suffix != ".csv"


def store_for(path: Path | None, plan: Plan, fresh: bool = False) -> Store:
    """Store for a file name: none, .csv, .h5 or .hdf5; a fresh one forgets what the file has.

    Raises
    ------
    UsageError
        If the file is another sweep's, of none at all, damaged, or in use.
    """
    check_name(path)
    if path is None:
        return Store(plan)
    path.parent.mkdir(parents=True, exist_ok=True)
    return (Hdf5Store if holds_trajectories(path) else CsvStore)(plan, path, fresh)


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


def _require_the_same(path: Path, theirs: Any, ours: Mapping[str, Any]) -> None:
    """Refuse results of another sweep; `theirs` is its plan as JSON."""
    try:
        plan = json.loads(theirs)
    except (ValueError, TypeError):
        plan = None
    if not isinstance(plan, dict):
        raise _damaged(path, "what it says of its sweep cannot be read")
    different = [name for name in ours if ours[name] != plan.get(name)]
    if different:
        *others, last = different
        listed = f"{', '.join(others)} and {last}" if others else last
        text = f"{path} holds another sweep, which differs in {listed}; {REMEDY}"
        raise UsageError(text)


def _damaged(path: Path, why: object) -> UsageError:
    return UsageError(f"{path} is damaged, or not the file of a sweep ({why}); {REMEDY}")


# ----------------------------------------------------------------------------------------- CSV


class CsvStore(Store):
    """One line for each run; what the sweep was stands beside it, in NAME.csv.plan.json."""

    def __init__(self, plan: Plan, path: Path, fresh: bool) -> None:
        super().__init__(plan)
        self._path, plan_path = path, path.with_name(f"{path.name}.plan.json")
        there = path.is_file() and not fresh
        if there and not plan_path.is_file():
            text = f"{path} is there and is not one of a sweep; name another file, or --fresh"
            raise UsageError(text)
        # The plan stays the file that it is, which the results do not: it is what is locked.
        self._lock = lock(plan_path, path)
        try:
            if there:
                _require_the_same(path, plan_path.read_bytes(), plan.document)
                self._read()
            plan_path.write_text(json.dumps(plan.document, indent=1) + "\n", encoding="utf-8")
            self._file = self._begin(path)
        except BaseException:
            self._lock.close()
            raise

    def _read(self) -> None:
        """Results of the lines that are whole."""
        whole = self._path.read_bytes().rpartition(b"\n")[0]
        try:
            rows = list(csv.reader(io.StringIO(whole.decode(), newline="")))
        except (UnicodeDecodeError, csv.Error) as error:
            raise _damaged(self._path, error) from None
        width = len(self.plan.columns)
        for row in rows[1:]:
            if len(row) == width:
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
        self._lock.close()


# ---------------------------------------------------------------------------------------- HDF5


class Hdf5Store(Store):
    """Data sets `runs` (a line for each run), `time`, and `trajectories/NAME` (runs, points).

    All have their size from the beginning: what is written later changes no structure of the file,
    and an interrupted sweep leaves one that can be read.
    """

    def __init__(self, plan: Plan, path: Path, fresh: bool) -> None:
        try:
            import h5py  # pyright: ignore[reportMissingImports]
        except ImportError:
            text = "the package h5py is missing; install it: pip install holonom[hdf5]"
            raise EnvironmentLackError(text) from None
        super().__init__(plan)
        if grouped := [name for name in plan.outputs if "/" in name]:
            text = (
                f"{path}: HDF5 takes the '/' of {grouped[0]!r} for a group; write a .csv, or leave "
            )
            raise UsageError(text + "it out")
        self._lock = lock(path, path)
        there = path.stat().st_size > 0 and not fresh
        try:
            # What h5py says that a name may stand for is more than a data set; here it is one.
            # Its own lock would find ours in its way.
            locking = False if LOCKS else None
            self._file: Any = h5py.File(path, "r+" if there else "w", locking=locking)
        except OSError as error:
            self._lock.close()
            text = f"{path}: cannot be opened ({error}); name another file, or --fresh"
            raise UsageError(text) from None
        try:
            if there:
                _require_the_same(path, self._file.attrs.get("plan"), plan.document)
                self._read(path)
            else:
                self._create(h5py)
        except BaseException:
            self.close()
            raise

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

    def _read(self, path: Path) -> None:
        import numpy as np

        try:
            for row in self._file["runs"][:]:
                if row["run"]:
                    cells = [x.decode() if isinstance(x, bytes) else str(x.item()) for x in row]
                    result = self.plan.result_of(cells)
                    values = np.empty((len(self.plan.times), len(self.plan.outputs)))
                    for i, name in enumerate(self.plan.outputs):
                        values[:, i] = self._at(name, result.run)
                    self.results[result.run] = replace(result, values=values)
        except (KeyError, IndexError, ValueError, TypeError, AttributeError, OSError) as error:
            raise _damaged(path, error) from None

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
        self._lock.close()


def by_run(results: Mapping[int, Result]) -> Sequence[Result]:
    """Results in the order of the runs."""
    return [results[run] for run in sorted(results)]
