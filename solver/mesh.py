"""The mesh of a run: how its internal steps were taken, to be repeated with other numbers.

A run under a tolerance chooses lengths and methods anew whenever a number changes, so its results
jump by about the tolerance. With a mesh that is kept they are smooth functions of the numbers.
"""

from __future__ import annotations

import json
import os
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from solver.runtime import Integrator, Model, OptionError
from solver.runtime.integrator import MeshMemory
from solver.runtime.layout import MESH, MESH_ENDS, MESH_TAKEN

if TYPE_CHECKING:
    from numpy.typing import NDArray

ROOM = 2**16
"""Internal steps that a communication step may have."""
PARTS = (
    "dim", "n_free", "n_driven", "n_rows", "n_contacts", "n_frictions", "n_islands", "n_switches",
)  # fmt: skip
"""Sizes of a model that must be those of the recorded one."""
LIMITS = {"explicit": 1, "careful": 1, "anew": 1, "put_back": 1}
LIMITS |= dict.fromkeys(("lowered", "projected", "started"), 100)
LIMITS |= {"taken": len(MESH_TAKEN) - 1, "end": len(MESH_ENDS) - 1, "order": 8}
"""Largest values of columns that are whole numbers."""


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Internal steps of a run, from `simulate` with `record_mesh`."""

    times: NDArray[np.float64]
    """ndarray, shape (n,): communication points [s], with those of jumps of inputs."""
    steps: NDArray[np.float64]
    """ndarray, shape (m, len(columns)): one row for each internal step, by `columns`."""
    sides: NDArray[np.float64]
    """ndarray, shape (m, s): in each internal step the side on which each of the s conditions and
    kinks of formulas is, a sign or a whole number; in the order of ``holonom info``."""
    ends: NDArray[np.int64]
    """ndarray, shape (n,): number of rows up to each communication point."""
    settings: Mapping[str, float | str | bool]
    """Settings of the solver that the run had, by name."""
    parts: Mapping[str, int]
    """Sizes of its model: what it moves must be made of as many parts."""

    columns = MESH
    """What a row has."""

    def __getitem__(self, column: str) -> NDArray[np.float64]:
        """Return a column of the steps, shape (m,)."""
        return self.steps[:, MESH.index(column)]

    def __repr__(self) -> str:
        """Return how many steps, events of contacts and changes of sides it has, in a line."""
        events, motion, time = (
            int(np.count_nonzero(self["end"] == MESH_ENDS.index(name)))
            for name in ("event", "switch", "time")
        )
        return (
            f"<Mesh: {len(self.steps)} steps, {events} events, {motion + time} switches, "
            f"to {self.times[-1]:g} s>"
        )

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write it as an .npz file of NumPy, and return the path."""
        texts = json.dumps({"settings": dict(self.settings), "parts": dict(self.parts)})
        with open(path, "wb") as file:
            np.savez_compressed(
                file, times=self.times, steps=self.steps, sides=self.sides, ends=self.ends,
                columns=np.array(MESH), about=np.array(texts),
            )  # fmt: skip
        return Path(path)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Mesh:
        """Read a file that `save` has written.

        Raises
        ------
        OptionError
            If it is another file, is damaged, or was written by another version.
        OSError
            If it cannot be read.
        """
        try:
            with np.load(path, allow_pickle=False) as file:
                about = json.loads(str(file["about"]))
                names = tuple(file["columns"].tolist())
                times, steps, sides, ends = (
                    file[name] for name in ("times", "steps", "sides", "ends")
                )
                mesh = cls(times, steps, sides, ends, about["settings"], about["parts"])
        except (ValueError, KeyError, TypeError, zipfile.BadZipFile, EOFError):
            text = f"{os.fspath(path)}: is no mesh of a run; record it again"
            raise OptionError(text) from None
        flaw = mesh.flaw() if names == MESH else "was written by another version"
        if flaw:
            text = f"{os.fspath(path)}: {flaw}; record it again"
            raise OptionError(text)
        return mesh

    def settings_for(self, model: Model) -> dict[str, float | str | bool]:
        """Return the settings that the solver of a model needs to repeat it.

        Raises
        ------
        OptionError
            If it is the mesh of a mechanism of other parts, or damaged.
        """
        if flaw := self.flaw():
            text = f"mesh: {flaw}; record it again"
            raise OptionError(text)
        if dict(self.parts) != _parts(model):
            text = "mesh: is that of a mechanism with other parts; record it with this one"
            raise OptionError(text)
        return dict(self.settings)

    def flaw(self) -> str:
        """Return what no recorded mesh has; empty of a sound one."""
        if self.steps.ndim != 2 or self.steps.shape[1] != len(MESH):
            return f"has no {len(MESH)} numbers for each internal step"
        if self.ends.shape != self.times.shape or self.ends.dtype.kind != "i":
            return "does not have one number of steps for each communication point"
        if not (np.isfinite(self.steps).all() and np.isfinite(self.times).all()):
            return "has a number that is not finite"
        if not (self.ends[:1] == 0).all() or not (np.diff(self.ends) > 0).all():
            return "has a communication step without internal steps"
        if self.ends[-1:].sum() != len(self.steps) or not (self.steps[:, 1:3] > 0.0).all():
            return "has internal steps of no length, or beyond its end"
        functions = self.parts["n_contacts"] + self.parts["n_frictions"]
        switches = self.parts["n_switches"]
        if self.sides.shape != (len(self.steps), switches):
            return "does not have the side of each condition in each step"
        limits = {**LIMITS, "function": max(functions + switches - 1, 0)}
        for name, most in limits.items():
            column = self[name]
            if (column != np.floor(column)).any() or not (column <= most).all():
                return f"has a value of {name!r} that no run comes to"
        ends, function = self["end"], self["function"]
        by_contacts = (ends == MESH_ENDS.index("event")) | (ends == MESH_ENDS.index("stop"))
        by_switches = ends >= MESH_ENDS.index("switch")
        least = np.where(by_switches, functions, np.where(by_contacts, 0, -1))
        if (function < least).any() or (function[by_contacts] >= functions).any():
            return "has an event without a contact, or a change of sides without a condition"
        if (self["order"] < 2).any():
            return "has a step without an order"
        return ""


def _parts(model: Model) -> dict[str, int]:
    return {name: model.sizes[name] for name in PARTS}


class Recording:
    """Moves an integrator, and keeps the mesh."""

    def __init__(self, integrator: Integrator) -> None:
        switches = integrator.model.sizes["n_switches"]
        self._integrator, self._memory = integrator, MeshMemory(ROOM, switches)
        self._rows: list[np.ndarray] = []
        names = [v.name for v in integrator.model.variables if v.kind == "option"]
        self._settings = {name: integrator[name] for name in names}
        integrator.use_mesh(self._memory)

    def advance(self, t: float, step: float) -> None:
        """As `Integrator.advance`.

        Raises
        ------
        OptionError
            If there are more internal steps than a communication step may have.
        """
        self._memory.clear()
        self._integrator.advance(t, step)
        if self._memory.is_full:
            text = (
                f"record_mesh: the communication step from t = {t:g} s has more than {ROOM} "
                "internal steps; give a shorter step_size"
            )
            raise OptionError(text)
        self._rows.append(np.array(self._memory.numbers()).reshape(-1, self._memory.width))

    def mesh(self, times: Sequence[float]) -> Mesh:
        """Mesh of the steps so far, of a run with these communication points [s]."""
        ends = np.cumsum([0, *(len(rows) for rows in self._rows)])
        rows = np.concatenate([np.empty((0, self._memory.width)), *self._rows])
        reached = np.array(times[: len(ends)], dtype=float)
        steps, sides = np.split(rows, [len(MESH)], axis=1)
        return Mesh(reached, steps, sides, ends, self._settings, _parts(self._integrator.model))


class Repeating:
    """Moves an integrator by the steps of a mesh."""

    def __init__(self, integrator: Integrator, mesh: Mesh, times: Sequence[float]) -> None:
        """Take what is to be moved over these communication points [s], with its settings.

        Raises
        ------
        OptionError
            If the mesh has other communication points.
        """
        if not np.array_equal(mesh.times, times):
            text = (
                f"mesh: has {len(mesh.times)} communication points up to {mesh.times[-1]:g} s, "
                f"this run has {len(times)} up to {times[-1]:g} s, or others between; give the "
                "stop_time, step_size and jumps of inputs of the recorded run"
            )
            raise OptionError(text)
        self._integrator, self._mesh, self._done = integrator, mesh, 0
        most = int(np.diff(mesh.ends).max(initial=1))
        self._memory = MeshMemory(most, mesh.sides.shape[1], len(integrator.state.block))
        integrator.use_mesh(self._memory)

    def advance(self, t: float, step: float) -> None:
        """As `Integrator.advance`, where steps can be taken as in the recorded run."""
        begin, end = self._mesh.ends[self._done : self._done + 2]
        rows = np.hstack([self._mesh.steps[begin:end], self._mesh.sides[begin:end]])
        self._memory.fill(rows.ravel().tolist())
        self._done += 1
        self._integrator.advance(t, step)
