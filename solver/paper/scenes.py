"""Scenes with the paper's method: points, bars, bodies, joints, springs, dampers and weights."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from solver.mechanics import assemble
from solver.mechanics.matrices import Matrices
from solver.runtime import Integrator, Model
from solver.scene import Scene, load
from solver.signals import communication_points

from .problem import Array, Functions, Method, Problem
from .step import Moment, step


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
    update: str | None = None,
    **options: float | str,
) -> Run:
    """Run a scene by the paper's method; settings are the scene's own where left out.

    Parameters
    ----------
    mechanism, stop_time, parameters, outputs
        Those of ``holonom.simulate``; inputs are parameters. Outputs are told after each step.
    update : {"paper", "end"}, optional
        The setting `multiplier_update`.
    **options
        Settings `formulation`, `algorithm`, `penalty`, `step_size` [s], `xi`, `omega` [rad/s].

    Raises
    ------
    SceneError, AssemblyError, OptionError, StepError
        What is wrong, what a scene has that this method does not take, or which step fails.
    """
    scene = mechanism if isinstance(mechanism, Scene | Model) else load(mechanism)
    model = scene if isinstance(scene, Model) else assemble(scene)
    integrator = Integrator(model)
    options |= {} if update is None else {"multiplier_update": update}
    given = {f"solver.{name}": value for name, value in options.items()}
    for name, value in {**(parameters or {}), **given}.items():
        integrator[name] = value
    taken = "formulation", "algorithm", "xi", "omega", "penalty", "multiplier_update", "step_size"
    setting: dict[str, Any] = {name: integrator[f"solver.{name}"] for name in taken}
    integrator["solver.formulation"] = "conserving-al"  # which takes every scene
    integrator.initialise()
    integrator.begin()
    x = Matrices(integrator)
    problem, h, start = problem_of(x), setting.pop("step_size"), model.experiment.start_time
    stop = model.experiment.stop_time if stop_time is None else stop_time
    times = communication_points(start, stop, h, step_is_chosen=True)
    per_step = 1.0 if setting["formulation"] == "penalty-velocity" else 4.0 / h**2
    setting["update"] = setting.pop("multiplier_update")
    method = Method(alpha=per_step * setting.pop("penalty") / x.sigma, **setting)
    names = outputs or [v.name for v in model.variables if v.causality in ("input", "output")]
    places = [model.index(name) for name in names]
    moments, table = [Moment(start, x.q, x.v, 0.0 * x.sigma)], [integrator.get(places)]
    for before, after in pairwise(times):
        moments.append(n1 := step(problem, method, moments[-1], after - before))
        stored = 0.5 * float(method.alpha @ x.rows(n1.q)[0] ** 2)
        stored *= method.formulation.endswith("-penalty")
        x.put(integrator, n1.t, n1.q, n1.v, n1.iterations[-1].mu, stored)
        table.append(integrator.get(places))
    columns = zip(names, np.array(table, dtype=float).T, strict=True)
    return Run(np.array(times), dict(columns), moments)
