"""Runs a mechanism from Python and collects what it did as NumPy arrays."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

import numpy as np

from solver.extras import imported
from solver.mechanics import assemble
from solver.mesh import Mesh, Recording, Repeating
from solver.options import OPTIONS
from solver.runtime import Integrator, Model, OptionError, StepError
from solver.runtime.errors import UnknownNameError, tell
from solver.scene import Scene, load
from solver.signals import (
    Courses,
    Problem,
    changes,
    communication_points,
    courses,
    moving_inputs,
)

if TYPE_CHECKING:
    import pandas  # pyright: ignore[reportMissingImports]
    import xarray  # pyright: ignore[reportMissingImports]
    from matplotlib.figure import Figure  # pyright: ignore[reportMissingImports]
    from numpy.typing import NDArray

    from solver.paper import Moment

PAPER = ("formulation", "algorithm", "multiplier_update", "xi", "omega")
"""Arguments of `simulate` that ask for the method of `solver.paper`."""
SHOWN = 4
"""Variables that a line about a trajectory names."""


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory(Mapping[str, "NDArray[np.float64]"]):
    """Values at the communication points: `t` (n,) in s; ``trajectory["A.x"]`` (n,) by name.

    A mapping of names to arrays: ``"A.x" in trajectory``, ``trajectory.items()``.
    """

    t: NDArray[np.float64]
    names: tuple[str, ...]
    table: NDArray[np.float64]
    """ndarray, shape (n, len(names))."""
    model: Model | None = None
    """What was moved."""
    given: Mapping[str, Any] = field(default_factory=dict)
    """Parameters, inputs and settings that were given for the whole run."""
    wall_time: float | None = None
    """Of the run [s]."""
    moments: Sequence[Moment] = ()
    """Start and end of each step by the method of `solver.paper`, with what every iteration did."""
    mesh: Mesh | None = None
    """Internal steps, if they were recorded."""

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """Return the values of one variable."""
        if name not in self.names:
            raise UnknownNameError(name, self.names)
        return self.table[:, self.names.index(name)]

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names."""
        return iter(self.names)

    def __len__(self) -> int:
        """Return the number of names."""
        return len(self.names)

    def __eq__(self, other: object) -> bool:
        """Return whether times, names and values are the same."""
        if not isinstance(other, Trajectory):
            return NotImplemented
        pairs = (self.t, other.t), (self.table, other.table)
        return self.names == other.names and all(np.array_equal(a, b) for a, b in pairs)

    __hash__ = None  # type: ignore[assignment] - arrays may be changed

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a page that shows the mechanism in motion, with plots and tables; return its path.

        It is one HTML file that any browser opens, without a network.

        Raises
        ------
        OptionError
            If it was not run from a scene, or not all of the positions were collected.
        """
        from viewer.report import report_of_trajectory

        return report_of_trajectory(path, self)

    def to_pandas(self) -> pandas.DataFrame:
        """Return a data frame: a row for each time, a column for each name; needs pandas."""
        pd = imported("pandas", "pandas")
        index = pd.Index(self.t, name="time")
        return pd.DataFrame(self.table, index=index, columns=list(self.names))

    def to_xarray(self) -> xarray.Dataset:
        """Return a data set along "time", whose variables have `units` and `long_name`.

        These stand in the attributes of each variable as far as the model knows them; the data set
        has the model's name and description as `title` and `comment`. Needs xarray.
        """
        known = {v.name: v for v in self.model.variables} if self.model else {}
        values = {}
        for name, column in zip(self.names, self.table.T, strict=True):
            about = known.get(name)
            told = {"units": about.unit, "long_name": about.description} if about else {}
            values[name] = ("time", column, {key: text for key, text in told.items() if text})
        model = self.model
        of_all = {"title": model.name, "comment": model.description} if model else {}
        times = {"time": ("time", self.t, {"units": "s"})}
        return imported("xarray", "xarray").Dataset(values, times, of_all)

    def plot(self, names: Sequence[str] | str | None = None) -> Figure:
        """Return a figure of matplotlib with variables over time, a plot for each unit.

        Parameters
        ----------
        names : sequence of str, optional
            Names, or patterns such as ``"energy.*"``; where left out, the scene's own outputs, else
            energies and errors.

        Raises
        ------
        ModuleNotFoundError
            If matplotlib is not installed; the sentence says how to get it.
        OptionError
            If a name or pattern matches no variable.
        """
        from viewer.plots import over_time

        variables, title = (self.model.variables, self.model.name) if self.model else ((), "")
        return over_time(self.t, self, variables, names, title)

    def __repr__(self) -> str:
        """Return how long it is and what it has, in a line."""
        span = f" from {self.t[0]:g} to {self.t[-1]:g} s" if len(self.t) else ""
        names = ", ".join(self.names[:SHOWN]) + (", ..." if len(self.names) > SHOWN else "")
        return f"<Trajectory: {len(self.t)} times{span}, {len(self.names)} variables: {names}>"

    def _repr_html_(self) -> str:
        """Rows, duration, largest errors and a small curve, for notebooks."""
        from viewer.plots import summary_html

        variables, title = (self.model.variables, self.model.name) if self.model else ((), "")
        return summary_html(self.t, self, variables, title)


def simulate(
    mechanism: Scene | Model | str | os.PathLike[str],
    *,
    stop_time: float | None = None,
    step_size: float | None = None,
    parameters: Mapping[str, float] | None = None,
    inputs: Mapping[str, Any] | None = None,
    outputs: Sequence[str] | None = None,
    record_mesh: bool = False,
    mesh: Mesh | None = None,
    **options: float | str | bool,
) -> Trajectory:
    """Run a mechanism and return its trajectory.

    Parameters
    ----------
    mechanism : Scene, Model or path of a scene
        What to move.
    stop_time, step_size : float, optional
        End of the run and communication step [s]; the scene's own where left out. Internal steps
        are those that the settings of the solver choose: without any, for a tolerance of 1e-4.
    parameters : mapping of str to float, optional
        Values by name, kept for the whole run.
    inputs : mapping, optional
        By name numbers, functions of the time in s, and arrays, with their times as "time" [s].
        Between the times inputs go in straight lines, before and after them they stay; a time that
        stands twice is a jump. A held input gets its value at the beginning of each communication
        step, one with ``interpolation = "ramp"`` or ``"smooth"`` that at its end: hence a short
        `step_size`. At a jump between communication points a step ends, too. The trajectory has
        arrays and functions as given, also where ``limit = "clip"`` changes what acts.
    outputs : sequence of str, optional
        Variables to collect; all inputs and outputs where left out. Accelerations, and powers of
        forces, are measured only where they are named here or in the scene.
    record_mesh : bool, optional
        Whether the trajectory has its internal steps as `mesh`.
    mesh : Mesh, optional
        Internal steps of a run of this mechanism, or one that differs in its numbers alone, to be
        repeated: results are smooth functions of parameters and start values, and the same to the
        last bit where these are the same (but for ``solver.*``, which tell of this run). Steps end
        where contacts change, and conditions of formulas, now; if these change in another order,
        or in another communication step, the step fails. The settings of the solver are those of
        the recorded run.
    **options
        Settings of the solver, such as ``tolerance=1e-6``; the internal step is ``internal_step``.
        One of `formulation`, `algorithm`, `multiplier_update`, `xi` and `omega` [rad/s] asks for
        the method of `solver.paper` (the fields of its `Method`), in equal steps of
        ``internal_step`` whatever tolerance and order the scene has, with any ``penalty``; inputs
        are numbers then, and the trajectory has `moments`.

    Raises
    ------
    SceneError, AssemblyError, OptionError, StepError
        What is wrong with the scene, the parameters, a value or name, or a step. A StepError has
        what the run came to before that step as its `trajectory`.

    Warns
    -----
    RuntimeWarning
        Where dampers keep all steps at order 2, or a smooth input gets straight lines.
    """
    if isinstance(mechanism, Model):
        model = mechanism
    else:
        model = assemble(_scene(mechanism), outputs or ())
    integrator = Integrator(model)
    by_paper = bool({*PAPER} & options.keys())
    _check_mesh(options, record_mesh, mesh)
    method = _method(options, inputs or {}) if by_paper else {}
    if "internal_step" in options:
        options["step_size"] = options.pop("internal_step")
    settings = {f"solver.{name}": value for name, value in options.items()}
    for name in settings:
        if name.removeprefix("solver.") not in OPTIONS:
            raise UnknownNameError(name, [f"solver.{x}" for x in (*OPTIONS, *PAPER)])
    held = {name: value for name, value in (inputs or {}).items() if not changes(value)}
    if mesh:
        settings = mesh.settings_for(model)
    for name, value in {**(parameters or {}), **held, **settings}.items():
        integrator[name] = value
    names = _collected(model, outputs)
    start, stop, step, _ = model.experiment
    stop, step = (x if y is None else y for x, y in ((stop, stop_time), (step, step_size)))
    times = communication_points(start, stop, step, step_is_chosen=step_size is not None)
    begin, places = perf_counter(), [model.index(name) for name in names]
    integrator.state.head["horizon"] = stop - start
    given: dict[str, Any] = {**(parameters or {}), **held, **settings, **method}
    signals = _courses(model, inputs or {}, held, times)
    for remark in signals.remarks:
        tell(None, remark)
    rows: list[list[float | str | bool]] = []
    moments: list[Moment] = []

    def reached() -> Trajectory:
        table = np.array(rows, dtype=float).reshape(len(rows), len(names))
        for name in signals.values.keys() & set(names):
            table[:, names.index(name)] = signals.values[name][: len(rows)]
        spent = perf_counter() - begin
        recorded = follower.mesh(signals.times) if isinstance(follower, Recording) else None
        reached = np.array(times)[: len(rows)]
        return Trajectory(reached, names, table, model, given, spent, moments, recorded)

    follower = integrator
    if record_mesh:
        follower = Recording(integrator)
    elif mesh:
        follower = Repeating(integrator, mesh, signals.times)
    motion = _rows(integrator, signals, places, follower.advance)
    if by_paper:
        from solver.paper_scenes import run

        motion = run(integrator, times, places, moments, **method)
    try:
        for row in motion:
            rows.append(row)  # one by one: those before a step that fails stay
    except StepError as error:
        error.trajectory = reached()
        raise
    return reached()


def _check_mesh(options: Mapping[str, Any], record_mesh: bool, mesh: Mesh | None) -> None:
    """Refuse settings beside a mesh, and a mesh of what takes none."""
    if record_mesh and mesh:
        message = "record_mesh: a run that repeats a mesh has that one; leave record_mesh out"
        raise OptionError(message)
    if mesh and options:
        message = f"mesh: has the settings of its run; leave {' and '.join(options)} out"
        raise OptionError(message)
    if record_mesh and {*PAPER} & options.keys():
        message = "record_mesh: the paper's method takes equal steps; leave record_mesh out"
        raise OptionError(message)


def _method(options: dict[str, Any], inputs: Mapping[str, Any]) -> dict[str, Any]:
    """Take the arguments of the paper's method out of the options."""
    method = {name: options.pop(name) for name in (*PAPER, "penalty") if name in options}
    problems = [
        f"{name}: the paper's method takes no inputs that change; give a number"
        for name, value in inputs.items()
        if changes(value)
    ]
    problems += [
        f"{name}: the paper's method has no such setting; leave it out, or, for the core, leave "
        f"{' and '.join(method)} out"
        for name in options
        if name in OPTIONS and name not in ("assemble", "start")
    ]
    if problems:
        raise OptionError("; ".join(problems))
    return method


def _rows(
    integrator: Integrator,
    signals: Courses,
    indices: Sequence[int],
    advance: Callable[[float, float], None],
) -> Iterator[list[float | str | bool]]:
    """Values at each communication point; before each step inputs are set to what it needs."""
    driven = [integrator.model.index(name) for name in signals.sent]
    sent = np.array([*signals.sent.values()]).T.tolist()
    times, shown = signals.times, {*signals.rows}
    for k, time in enumerate(times):
        if driven:
            integrator.set(driven, sent[k])
        if k:
            advance(times[k - 1], time - times[k - 1])
        if k in shown:
            yield integrator.get(indices)
    if driven:  # checks the last values too, which move nothing
        integrator.set(driven, [float(values[-1]) for values in signals.values.values()])


def _courses(
    model: Model, inputs: Mapping[str, Any], held: Mapping[str, Any], times: Sequence[float]
) -> Courses:
    """Inputs that change, over the communication points."""
    problems: list[Problem] = []
    changing = {name: signal for name, signal in inputs.items() if name not in held}
    moving = moving_inputs(model.moving_inputs, model.variables)
    found = courses(changing, times, moving, problems)
    if problems:
        raise OptionError("\n".join(f"inputs: {message}; {help}" for message, help in problems))
    return found


def _collected(model: Model, outputs: Sequence[str] | None) -> tuple[str, ...]:
    """Names of the variables to collect."""
    if outputs is None:
        return tuple(v.name for v in model.variables if v.causality in ("input", "output"))
    if not outputs:
        message = "outputs: must name at least one variable; leave it out to collect all outputs"
        raise OptionError(message)
    if isinstance(outputs, str):
        message = f"outputs: must be a sequence of names, got the text {outputs!r}"
        raise OptionError(message)
    return tuple(outputs)


def _scene(mechanism: Scene | str | os.PathLike[str]) -> Scene:
    return mechanism if isinstance(mechanism, Scene) else load(mechanism)
