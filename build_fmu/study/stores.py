"""Where a sweep keeps what it has: a CSV file of summaries, or HDF5 with trajectories as well.

Each knows the plan of its sweep, so that an interrupted one goes on where it stopped, and another
one is not mixed into it.
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TextIO

from build_fmu.errors import EnvironmentLackError, UsageError, writing
from build_fmu.study.lock import LOCKS, lock
from build_fmu.study.plan import Plan, Result

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


def store_for(
    path: Path | None, plan: Plan, fresh: bool = False, trajectories: bool = False
) -> Store:
    """Store for a file name: none, .csv, .h5 or .hdf5; a fresh one forgets what the file has.

    With `trajectories` its results have them, where the file does.

    Raises
    ------
    UsageError
        If the file is another sweep's, of none at all, damaged, or in use.
    """
    check_name(path)
    if path is None:
        return Store(plan, trajectories)
    path.parent.mkdir(parents=True, exist_ok=True)
    kind = Hdf5Store if holds_trajectories(path) else CsvStore
    return kind(plan, trajectories, path, fresh)


class Store:
    """Base: results in memory alone."""

    def __init__(self, plan: Plan, trajectories: bool) -> None:
        self.plan = plan
        self.results: dict[int, Result] = {}
        self._trajectories = trajectories

    def keep(self, result: Result) -> None:
        """Take a result."""
        # Trajectories may be gigabytes, and the file has them.
        values = result.values if self._trajectories else None
        self.results[result.run] = replace(result, values=values, warnings=())

    def close(self) -> None:
        """Finish the file."""


def _require_the_same(path: Path, theirs: Any, ours: Mapping[str, Any]) -> None:
    """Refuse results of another sweep; `theirs` is its plan as JSON."""
    try:
        plan = json.loads(theirs)
    except (ValueError, TypeError):
        plan = None
    if not isinstance(plan, dict):
        raise _damaged(path, "its record of the sweep cannot be read")
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

    def __init__(self, plan: Plan, trajectories: bool, path: Path, fresh: bool) -> None:
        super().__init__(plan, trajectories)
        self._path, plan_path = path, path.with_name(f"{path.name}.plan.json")
        if path.is_file() and not fresh and not plan_path.is_file():
            text = f"{path} is there and is not one of a sweep; name another file, or --fresh"
            raise UsageError(text)
        # The plan stays the file that it is, which the results do not: it is what is locked.
        self._lock = lock(plan_path, path)
        try:
            if fresh:
                path.unlink(missing_ok=True)
            if path.is_file():
                _require_the_same(path, plan_path.read_bytes(), plan.document)
                self._read()
            else:  # in this order: results are never there without a plan that is theirs and whole
                plan_path.write_text(json.dumps(plan.document, indent=1) + "\n", encoding="utf-8")
            self._file = self._begin(path)
        except BaseException:
            self._lock.close()
            raise

    def _read(self) -> None:
        """Results of the lines that are whole and have the values of their run."""
        whole = self._path.read_bytes().rpartition(b"\n")[0]
        try:
            rows = list(csv.reader(io.StringIO(whole.decode(), newline="")))
        except (UnicodeDecodeError, csv.Error) as error:
            raise _damaged(self._path, error) from None
        columns, leading = self.plan.columns, self.plan.leading
        if rows[:1] != [columns]:
            raise _damaged(self._path, "its first line does not name the columns of this one")
        for row in rows[1:]:
            if len(row) == len(columns):
                with contextlib.suppress(ValueError):  # what cannot be read is run again
                    result = self.plan.result_of(row)
                    if row[:leading] == self.plan.row(result)[:leading]:
                        self.results[result.run] = result

    def _begin(self, path: Path) -> TextIO:
        """File with what is known, in the order of the runs."""
        other = path.with_name(f".{path.name}.new")
        with writing(path), other.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.plan.columns)
            writer.writerows(self.plan.row(self.results[run]) for run in sorted(self.results))
        other.replace(path)
        return path.open("a", newline="", encoding="utf-8")

    def keep(self, result: Result) -> None:
        """Write the line of a result at once."""
        super().keep(result)
        with writing(self._path):
            csv.writer(self._file, lineterminator="\n").writerow(self.plan.row(result))
            self._file.flush()

    def close(self) -> None:
        """Put the lines into the order of the runs."""
        with contextlib.closing(self._lock), writing(self._path):
            self._file.close()
            self._begin(self._path).close()


# ---------------------------------------------------------------------------------------- HDF5


class Hdf5Store(Store):
    """Data sets `runs` (a line for each run), `time`, and `trajectories/NAME` (runs, points).

    All have their size from the beginning: what is written later changes no structure of the file,
    and an interrupted sweep leaves one that can be read.
    """

    def __init__(self, plan: Plan, trajectories: bool, path: Path, fresh: bool) -> None:
        try:
            import h5py  # pyright: ignore[reportMissingImports]
        except ImportError:
            text = "the package h5py is missing; install it: pip install 'holonom[hdf5]'"
            raise EnvironmentLackError(text) from None
        super().__init__(plan, trajectories)
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
        self._path = path
        try:
            if there:
                _require_the_same(path, self._file.attrs.get("plan"), plan.document)
                self._read(path)
            else:
                with _writing_hdf5(path):
                    self._create(h5py)
        except BaseException:
            self.close()
            raise

    def _create(self, h5py: Any) -> None:
        import numpy as np

        plan = self.plan
        runs = np.zeros(plan.count, plan.dtype(LONGEST_REASON))
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
        self._file.attrs["plan"] = json.dumps(plan.document)  # last: without it nothing is taken
        self._file.flush()

    def _read(self, path: Path) -> None:
        try:
            self._require_structure()
            for row in self._file["runs"][:]:
                if row["run"]:
                    cells = [x.decode() if isinstance(x, bytes) else str(x.item()) for x in row]
                    self._take(self.plan.result_of(cells), row)
        except (KeyError, IndexError, ValueError, TypeError, AttributeError, OSError) as error:
            raise _damaged(path, error) from None

    def _require_structure(self) -> None:
        runs, shape = self._file["runs"], (self.plan.count, len(self.plan.times))
        if runs.shape != shape[:1] or runs.dtype.names != tuple(self.plan.columns):
            text = "'runs' does not have the runs and columns of this one"
            raise ValueError(text)
        for name in self.plan.outputs:
            if self._file["trajectories"][name].shape != shape:
                text = f"the trajectory {name!r} does not have its runs and times"
                raise ValueError(text)

    def _take(self, result: Result, row: Any) -> None:
        """Take a result from the file, unless its row has other values: then it is run again."""
        import numpy as np

        ours = np.array(self.plan.record(result, LONGEST_REASON), self.plan.dtype(LONGEST_REASON))
        leading = self.plan.leading
        if row.tolist()[:leading] != ours.tolist()[:leading]:
            return
        if self._trajectories:
            group, at = self._file["trajectories"], result.run - 1
            columns = [group[name][at] for name in self.plan.outputs]
            empty = np.empty((len(self.plan.times), 0))
            result = replace(result, values=np.column_stack(columns) if columns else empty)
        self.results[result.run] = result

    def keep(self, result: Result) -> None:
        """Write trajectory and line of a result."""
        at = result.run - 1
        with _writing_hdf5(self._path):
            if result.values is not None:
                for name, column in zip(self.plan.outputs, result.values.T, strict=True):
                    self._file["trajectories"][name][at, : len(column)] = column
            self._file["runs"][at] = self.plan.record(result, LONGEST_REASON)
            self._file.flush()
        super().keep(result)

    def close(self) -> None:
        """Close the file."""
        with contextlib.closing(self._lock), _writing_hdf5(self._path):
            self._file.close()


@contextlib.contextmanager
def _writing_hdf5(path: Path) -> Iterator[None]:
    """Name the file where h5py cannot write it, and say why in the words of the system."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = re.search(r"error message = '(.*?)'", str(error))
        text = f"{path}: {reason[1] if reason else error}"
        raise UsageError(text) from None


def by_run(results: Mapping[int, Result]) -> Sequence[Result]:
    """Results in the order of the runs."""
    return [results[run] for run in sorted(results)]
