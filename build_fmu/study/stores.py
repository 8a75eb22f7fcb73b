"""Where a sweep keeps what it has: a CSV file of summaries, or HDF5 with trajectories as well.

Each knows the plan of its sweep, so that an interrupted one goes on where it stopped, and another
one is not mixed into it. One sweep at a time writes into a file: the lock is the operating system's
(flock), so it ends with the process however that ends; Windows and some network drives have none.
"""

from __future__ import annotations

import contextlib
import csv
import errno
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO, TextIO

import numpy as np

from build_fmu.errors import EnvironmentLackError, UsageError, writing
from build_fmu.study.csv_file import cell
from build_fmu.study.plan import OWN_COLUMNS, Plan, Result

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LONGEST_TEXT = 300
"""Bytes of a text in HDF5."""
REMEDY = "name another file, or begin anew with --fresh"


def require_kind(path: Path | None) -> None:
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

    With `trajectories` its results have them.

    Raises
    ------
    UsageError
        If the file is another sweep's, of none at all, damaged, or in use.
    """
    if path is None:
        return Store(plan, trajectories)
    path.parent.mkdir(parents=True, exist_ok=True)
    kind = Hdf5Store if holds_trajectories(path) else CsvStore
    return kind(plan, trajectories, path, fresh)


class Store:
    """Base: results in memory alone."""

    def __init__(self, plan: Plan, trajectories: bool) -> None:
        self.plan = plan
        self.table = plan.table()
        self.is_done = np.zeros(plan.count, bool)
        """Of which runs the table has the results."""
        shape = (plan.count, len(plan.times), len(plan.outputs))
        self.trajectories = np.full(shape, np.nan) if trajectories else None

    def keep(self, result: Result) -> None:
        """Take a result."""
        at, leading = result.run - 1, self.plan.leading
        values = (not result.reason, result.end_time, result.reason, *result.summary)
        self.table[at] = (*self.table[at].tolist()[:leading], *values)
        if self.trajectories is not None and result.values is not None:
            self.trajectories[at, : len(result.values)] = result.values
        self.is_done[at] = True

    def close(self) -> None:
        """Finish the file."""


def _lock(path: Path, results: Path) -> BinaryIO:
    """File, made if it is not there, that is ours until it is closed; its results are named."""
    file = path.open("ab")
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in (errno.EAGAIN, errno.EACCES):
                file.close()
                text = (
                    f"{results} is in use: another sweep writes into it, or a program has it open; "
                    "wait for its end, or name another file"
                )
                raise UsageError(text) from None
    return file


class FileStore(Store):
    """Base: results in a file that is ours until it is closed."""

    def __init__(self, plan: Plan, trajectories: bool, path: Path, locked: Path) -> None:
        super().__init__(plan, trajectories)
        self._path, self._lock = path, _lock(locked, path)

    def _require_the_same(self, theirs: Any) -> None:
        """Refuse results of another sweep; `theirs` is its plan as JSON."""
        try:
            plan = json.loads(theirs)
        except (ValueError, TypeError):
            plan = None
        if not isinstance(plan, dict):
            raise UsageError(self._damaged("its record of the sweep cannot be read"))
        ours = self.plan.document
        different = [name for name in ours if ours[name] != plan.get(name)]
        if different:
            listed = " and ".join(filter(None, (", ".join(different[:-1]), different[-1])))
            text = f"{self._path} holds another sweep, which differs in {listed}; {REMEDY}"
            raise UsageError(text)

    def _damaged(self, why: object) -> str:
        return f"{self._path} is damaged, or not the file of a sweep ({why}); {REMEDY}"


# ----------------------------------------------------------------------------------------- CSV


class CsvStore(FileStore):
    """One line for each run; what the sweep was stands beside it, in NAME.csv.plan.json."""

    def __init__(self, plan: Plan, trajectories: bool, path: Path, fresh: bool) -> None:
        plan_path = path.with_name(f"{path.name}.plan.json")
        if path.is_file() and not fresh and not plan_path.is_file():
            text = f"{path} is there and is not one of a sweep; {REMEDY}"
            raise UsageError(text)
        # The plan stays the file that it is, which the results do not: it is what is locked.
        super().__init__(plan, trajectories, path, plan_path)
        try:
            if fresh:
                path.unlink(missing_ok=True)
            if path.is_file():
                self._require_the_same(plan_path.read_bytes())
                self._read()
            else:  # in this order: results are never there without a plan that is theirs and whole
                plan_path.write_text(json.dumps(plan.document, indent=1) + "\n", encoding="utf-8")
            self._file = self._begin()
        except BaseException:
            self._lock.close()
            raise

    def _write(self, file: TextIO, at: int) -> None:
        """Write the line of a run; numbers read back as the same."""
        first = self.plan.leading + len(OWN_COLUMNS) - 1
        row = self.table[at].tolist()
        words = *self.plan.lead(at), *row[self.plan.leading : first]
        quoted = io.StringIO()
        csv.writer(quoted, lineterminator="\n").writerow(map(cell, words))
        # Numbers need no quotes: csv would look for these as long as Python writes the numbers.
        file.write(",".join([quoted.getvalue()[:-1], *map(cell, row[first:])]) + "\n")

    def _read(self) -> None:
        """Results of the lines that are whole and have the values of their run."""
        whole = self._path.read_bytes().rpartition(b"\n")[0]
        try:
            rows = list(csv.reader(io.StringIO(whole.decode(), newline="")))
        except (UnicodeDecodeError, csv.Error) as error:
            raise UsageError(self._damaged(error)) from None
        if rows[:1] != [self.plan.columns]:
            raise UsageError(self._damaged("its first line does not name the columns of this one"))
        leading = self.plan.leading
        runs = {tuple(map(cell, self.plan.lead(at))): at + 1 for at in range(self.plan.count)}
        for row in rows[1:]:
            run = runs.get(tuple(row[:leading]))
            if run and len(row) == len(self.plan.columns):
                with contextlib.suppress(ValueError):  # what cannot be read is run again
                    end, reason, *numbers = row[leading + 1 :]
                    super().keep(Result(run, float(end), reason, [*map(float, numbers)]))

    def _begin(self) -> TextIO:
        """File with what is known, in the order of the runs."""
        other = self._path.with_name(f".{self._path.name}.new")
        with writing(self._path), other.open("w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerow(self.plan.columns)
            for at in self.is_done.nonzero()[0].tolist():
                self._write(file, at)
        other.replace(self._path)
        self._latest, self._is_in_order = int(self.is_done.nonzero()[0].max(initial=-1)) + 1, True
        return self._path.open("a", newline="", encoding="utf-8")

    def keep(self, result: Result) -> None:
        """Write the line of a result at once."""
        super().keep(result)
        self._is_in_order &= result.run > self._latest
        self._latest = result.run
        with writing(self._path):
            self._write(self._file, result.run - 1)
            self._file.flush()

    def close(self) -> None:
        """Put the lines into the order of the runs."""
        with contextlib.closing(self._lock), writing(self._path):
            self._file.close()
            if not self._is_in_order:
                self._begin().close()


# ---------------------------------------------------------------------------------------- HDF5


class Hdf5Store(FileStore):
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
        if grouped := [name for name in plan.outputs if "/" in name]:
            text = (
                f"{path}: HDF5 takes the '/' of {grouped[0]!r} for a group; write a .csv, or leave "
            )
            raise UsageError(text + "it out")
        super().__init__(plan, trajectories, path, path)
        there = path.stat().st_size > 0 and not fresh
        try:
            # What h5py says that a name may stand for is more than a data set; here it is one.
            # Its own lock would find ours in its way.
            locking = None if fcntl is None else False
            self._file: Any = h5py.File(path, "r+" if there else "w", locking=locking)
        except OSError as error:
            self._lock.close()
            text = f"{path}: cannot be opened ({error}); {REMEDY}"
            raise UsageError(text) from None
        try:
            if there:
                self._require_the_same(self._file.attrs.get("plan"))
                self._read()
            else:
                with _writing_hdf5(path):
                    self._create(h5py)
        except BaseException:
            self.close()
            raise

    def _create(self, h5py: Any) -> None:
        plan = self.plan
        runs = np.zeros(plan.count, plan.dtype(f"S{LONGEST_TEXT}"))
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

    def _read(self) -> None:
        """Take the runs of the file that have the values of the plan; others are run again."""
        plan, shape = self.plan, (self.plan.count, len(self.plan.times))
        try:
            runs = self._file["runs"][:]
            if runs.shape != shape[:1] or runs.dtype.names != tuple(plan.columns):
                raise UsageError(
                    self._damaged("'runs' does not have the runs and columns of this one")
                )
            lead = list(plan.columns[: plan.leading])
            ours = [self._record(at)[: plan.leading] for at in range(plan.count)]
            self.is_done[:] = [x == y for x, y in zip(runs[lead].tolist(), ours, strict=True)]
            for name in plan.columns[plan.leading :]:
                text = runs.dtype[name].kind == "S"
                column = np.char.decode(runs[name], errors="ignore") if text else runs[name]
                self.table[name][self.is_done] = column[self.is_done]
            for i, name in enumerate(plan.outputs):
                values = self._file["trajectories"][name]
                if values.shape != shape:
                    text = f"the trajectory {name!r} does not have its runs and times"
                    raise UsageError(self._damaged(text))
                if self.trajectories is not None:
                    self.trajectories[self.is_done, :, i] = values[:][self.is_done]
        except (KeyError, IndexError, ValueError, TypeError, AttributeError, OSError) as error:
            raise UsageError(self._damaged(error)) from None

    def _record(self, at: int) -> tuple[Any, ...]:
        """Row of a run, with texts as bytes that are whole characters."""
        return tuple(
            x.encode()[:LONGEST_TEXT].decode(errors="ignore").encode() if isinstance(x, str) else x
            for x in self.table[at].tolist()
        )

    def keep(self, result: Result) -> None:
        """Write trajectory and line of a result."""
        super().keep(result)
        at = result.run - 1
        with _writing_hdf5(self._path):
            if result.values is not None:
                for name, column in zip(self.plan.outputs, result.values.T, strict=True):
                    self._file["trajectories"][name][at, : len(column)] = column
            self._file["runs"][at] = self._record(at)
            self._file.flush()

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
