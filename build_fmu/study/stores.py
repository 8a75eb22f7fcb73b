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
import os
import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study.csv_tables import cell
from build_fmu.study.plan import OWN_COLUMNS, Plan, Result
from solver.extras import missing
from solver.files import (
    RESULTS,
    TABLE,
    read_whole,
    why_unwritable,
    writing,
    written_whole,
    wrong_ending,
)

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LONGEST_TEXT = 300
"""Bytes of a text in HDF5."""
REMEDY = "name another file, or begin anew with --fresh"


def require_kind(path: Path | None) -> None:
    """Refuse a file that cannot hold results, before anything is done to it."""
    if path is None:
        return
    if wrong := wrong_ending(path, RESULTS):
        raise UsageError(wrong)
    if path.exists() and not path.is_file():
        text = f"{path}: results go to a file that can be read again, not to a device"
        raise UsageError(text)


def holds_trajectories(path: Path | None) -> bool:
    """Whether a file of this name has more than the summary."""
    return path is not None and path.suffix.lower() not in TABLE


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


class FileStore(Store):
    """Base: results in a file that is ours until it is closed."""

    def __init__(self, plan: Plan, trajectories: bool, path: Path, locked: Path) -> None:
        super().__init__(plan, trajectories)
        self._path, self._locks = path, contextlib.ExitStack()
        self._lock(locked)

    def _lock(self, path: Path) -> None:
        """Make a file ours, and make it if it is not there."""
        if fcntl is None:
            return
        if reason := why_unwritable(path):
            text = f"{path}: {reason}"
            raise UsageError(text)
        file = self._locks.enter_context(path.open("ab"))
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno in (errno.EAGAIN, errno.EACCES):
                self._locks.close()
                text = (
                    f"{self._path} is in use: another sweep writes into it, or a program has it "
                    "open; wait for its end, or name another file"
                )
                raise UsageError(text) from None

    def _give_up(self, locked: Path) -> None:
        """Leave no file that was made for the lock alone."""
        if locked.exists() and not locked.stat().st_size:
            locked.unlink()
        self._locks.close()

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
        super().__init__(plan, trajectories, path, plan_path)
        try:
            there = path.is_file() and not fresh
            if there:
                self._require_the_same(read_whole(plan_path))
                self._read()
            self._write_known(None if there else plan_path)
            self._file = self._path.open("ab", buffering=0)
        except BaseException:
            self._give_up(plan_path)
            raise

    def _line(self, at: int) -> str:
        """Line of a run; numbers read back as the same."""
        first = self.plan.leading + len(OWN_COLUMNS) - 1
        row = self.table[at].tolist()
        words = *self.plan.lead(at), *row[self.plan.leading : first]
        quoted = io.StringIO()
        csv.writer(quoted, lineterminator="\n").writerow(map(cell, words))
        # Numbers need no quotes: csv would look for these as long as Python writes the numbers.
        return ",".join([quoted.getvalue()[:-1], *map(cell, row[first:])]) + "\n"

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

    def _write_known(self, plan_path: Path | None = None) -> None:
        """Write what is known, in the order of the runs; with a path, the plan as well.

        All of it is on the disk before what was there goes, and results are never there without a
        plan that is theirs and whole.
        """
        done = self.is_done.nonzero()[0].tolist()
        with written_whole(self._path, "w") as file:
            csv.writer(file, lineterminator="\n").writerow(self.plan.columns)
            file.writelines(map(self._line, done))
            if plan_path is not None:
                file.flush()
                with written_whole(plan_path, "w") as plan:
                    plan.write(json.dumps(self.plan.document, indent=1) + "\n")
                    plan.flush()
                    self._lock(Path(plan.name))
                    self._path.unlink(missing_ok=True)
        self._latest, self._is_in_order = max(done, default=-1) + 1, True

    def keep(self, result: Result) -> None:
        """Write the line of a result at once, and whole."""
        super().keep(result)
        self._is_in_order &= result.run > self._latest
        self._latest = result.run
        with writing(self._path):
            end, rest = os.fstat(self._file.fileno()).st_size, self._line(result.run - 1).encode()
            try:
                while rest:
                    rest = rest[self._file.write(rest) :]
            except OSError:
                self._file.truncate(end)
                raise

    def close(self) -> None:
        """Put the lines into the order of the runs."""
        with self._locks, writing(self._path):
            self._file.close()
            if not self._is_in_order:
                self._write_known()


# ---------------------------------------------------------------------------------------- HDF5


class Hdf5Store(FileStore):
    """Data sets `runs` (a line for each run), `time`, and `trajectories/NAME` (runs, points).

    All have their size from the beginning: what is written later changes no structure of the file,
    and an interrupted sweep leaves one that can be read.
    """

    def __init__(self, plan: Plan, trajectories: bool, path: Path, fresh: bool) -> None:
        if text := missing("h5py", "hdf5"):
            raise EnvironmentLackError(text)
        import h5py  # pyright: ignore[reportMissingImports]

        if grouped := [name for name in plan.outputs if "/" in name]:
            text = (
                f"{path}: HDF5 takes the '/' of {grouped[0]!r} for a group; write a .csv, or leave "
            )
            raise UsageError(text + "it out")
        super().__init__(plan, trajectories, path, path)
        there = path.exists() and path.stat().st_size > 0 and not fresh
        # What h5py says that a name may stand for is more than a data set; here it is one.
        # Its own lock would find ours in its way.
        opened: Any = partial(h5py.File, locking=None if fcntl is None else False)
        try:
            if not there:
                with written_whole(path) as file:
                    with _writing_hdf5(path), opened(file.name, "w") as made:
                        self._create(h5py, made)
                    self._lock(Path(file.name))
            self._file = opened(path, "r+")
        except OSError as error:
            self._give_up(path)
            text = f"{path}: cannot be opened ({error}); {REMEDY}"
            raise UsageError(text) from None
        except BaseException:
            self._give_up(path)
            raise
        try:
            if there:
                self._require_the_same(self._file.attrs.get("plan"))
                self._read()
        except BaseException:
            self.close()
            raise

    def _create(self, h5py: Any, file: Any) -> None:
        plan = self.plan
        runs = np.zeros(plan.count, plan.dtype(f"S{LONGEST_TEXT}"))
        file.create_dataset("runs", data=runs)
        file.create_dataset("time", data=np.array(plan.times)).attrs["unit"] = "s"
        early = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        early.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
        early.set_fill_value(np.array(np.nan))
        group = file.create_group("trajectories")
        space = h5py.h5s.create_simple((plan.count, len(plan.times)))
        for name in plan.outputs:
            h5py.h5d.create(group.id, name.encode(), h5py.h5t.IEEE_F64LE, space, early)
            group[name].attrs["unit"] = plan.units.get(name, "")
        file.attrs["plan"] = json.dumps(plan.document)  # last: without it nothing is taken
        file.flush()

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
        with self._locks, _writing_hdf5(self._path):
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
