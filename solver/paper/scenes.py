"""Scenes with the paper's method: points, bars, bodies, joints, springs, dampers and weights."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from solver.mechanics import assemble
from solver.mechanics.matrices import Matrices
from solver.runtime import Integrator, Model, OptionError
from solver.scene import Scene, load
from solver.signals import communication_points

from .gradients import FORMULATIONS
from .problem import Array, Functions, Method, Problem
from .step import Moment, step

ALGORITHMS, UPDATES = ("nested", "simultaneous"), ("end", "paper")


class Run(NamedTuple):
    """Times t (n,), `values` (n,) of outputs by name, and moments with each step's iterations."""

    t: Array
    values: dict[str, Array]
    moments: list[Moment]


def problem_of(x: Matrices) -> Problem:
    """Return a model as a problem, from where its integrator stood."""
    f, e, s = x.rows, x.energies, x.squares
    phi = Functions(lambda q: f(q)[0], lambda q: f(q)[1])
    V = Functions(lambda q: e(q)[0], lambda q: e(q)[1], lambda q: s(q)[0], lambda q: s(q)[1])
    parts = {"M": x.M, "q": x.q, "v": x.v, "Q": lambda q, v, _: x.forces(q, v)}
    return Problem(phi=phi, potentials=V, begin_step=x.follow, **parts)


def simulate(
    mechanism: Scene | Model | str | os.PathLike[str],
    *,
    stop_time: float | None = None,
    parameters: Mapping[str, float] | None = None,
    outputs: Sequence[str] | None = None,
    step_size: float | None = None,
    penalty: float | None = None,
    formulation: str = "conserving-al",
    algorithm: str = "nested",
    update: str = "end",
    **more: float,
) -> Run:
    """Run a scene by the paper's method.

    Parameters
    ----------
    mechanism, stop_time, parameters, outputs
        Those of ``holonom.simulate``; inputs are parameters. Outputs are told after each step.
    step_size, penalty : float, optional
        Of each step [s], and alpha h^2 sigma/4 of each row, the scene's own where left out.
    formulation, algorithm, update, **more
        Other fields of `Method`.

    Raises
    ------
    SceneError, AssemblyError, OptionError, StepError
        What is wrong, what a scene has that this method does not take, or which step fails.
    """
    scene = mechanism if isinstance(mechanism, Scene | Model) else load(mechanism)
    model = scene if isinstance(scene, Model) else assemble(scene)
    integrator = Integrator(model)
    for name, value in (parameters or {}).items():
        integrator[name] = value
    h = float(integrator["solver.step_size"] if step_size is None else step_size)
    chi = float(integrator["solver.penalty"] if penalty is None else penalty)
    integrator.initialise()
    integrator.begin()
    x = Matrices(integrator)
    problem, start = problem_of(x), model.experiment.start_time
    stop = model.experiment.stop_time if stop_time is None else stop_time
    times = communication_points(start, stop, h, step_is_chosen=True)
    per_step = 1.0 if formulation == "penalty-velocity" else 4.0 / h**2
    alpha, own = per_step * chi / x.sigma, (formulation, algorithm, update)
    for word, words in zip(own, (FORMULATIONS, ALGORITHMS, UPDATES), strict=True):
        if word not in words or not chi > 0.0:
            message = f"penalty {chi!r} must be > 0, and {word!r} one of {', '.join(words)}"
            raise OptionError(message)
    how = Method(alpha=alpha, formulation=formulation, algorithm=algorithm, update=update, **more)
    names = outputs or [v.name for v in model.variables if v.causality in ("input", "output")]
    places = [model.index(name) for name in names]
    moments, table = [Moment(start, x.q, x.v, 0.0 * x.sigma)], [integrator.get(places)]
    for before, after in pairwise(times):
        moments.append(n1 := step(problem, how, moments[-1], after - before))
        stored = 0.5 * float(how.alpha @ x.rows(n1.q)[0] ** 2)
        stored *= how.formulation.endswith("-penalty")
        x.put(integrator, n1.t, n1.q, n1.v, n1.iterations[-1].mu, stored)
        table.append(integrator.get(places))
    columns = zip(names, np.array(table, dtype=float).T, strict=True)
    return Run(np.array(times), dict(columns), moments)
