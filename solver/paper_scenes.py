"""Scenes by the method of `solver.paper`: all but contacts, friction, rolling and force laws."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from solver.mechanics.matrices import Matrices
from solver.options import USUAL_STEP
from solver.paper.problem import Functions, Method, Problem, check
from solver.paper.step import Moment, step
from solver.runtime import Integrator, Model, OptionError
from solver.runtime.layout import STORES
from solver.scene import Actuator, Damper, Scene, TorsionDamper

OF_DAMPED = "damping must be >= 0 s/m", "impact_speed must"
"""How rules begin that compliant contacts with a damping have."""


def refusal(model: Model, depth_damping: Sequence[float]) -> str:
    """Return what the method does not take of a model, with the parts; nothing if it takes all.

    `depth_damping` are the factors [s/m, s/rad] of contacts that yield.
    """
    size = model.sizes
    first = size["n_form_rows"] + size["dim"] * size["n_coincidences"]
    contacts = [first + j - size["n_elements"] for j in model.tables["contact_row"]]
    velocities = model.rows[first + size["n_function_rows"] :]
    damped = [rule.name for rule in model.rules if rule.message.startswith(OF_DAMPED)]
    found = {
        "contacts, which open and close": [model.rows[j].name for j in contacts],
        "rolling and friction, which are rows of velocities": [row.name for row in velocities],
        "damped contacts, whose damping never pulls": damped if any(depth_damping) else [],
        "laws of dampers and actuators, which are no energies": _forces_by_law(model),
    }
    message = "; ".join(
        f"{_listed([*dict.fromkeys(names)])}: the paper's method takes no {what}"
        for what, names in found.items()
        if names
    )
    return message and message + "; the core does: leave out 'formulation'"


def _forces_by_law(model: Model) -> list[str]:
    """Return the dampers with a law and the actuators, where one of them reads the motion."""
    scene = model.scene
    if not isinstance(scene, Scene) or not any(
        role != STORES for role in model.tables["force_role"]
    ):
        return []
    laws = {Actuator: "value", Damper: "force", TorsionDamper: "torque"}
    return [
        f"force '{name}'"
        for name, force in scene.forces.items()
        if getattr(force, laws.get(type(force), ""), None) is not None
    ]


def _listed(names: Sequence[str]) -> str:
    most = 4
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def problem_of(x: Matrices) -> Problem:
    """Return a model as a problem, from where its integrator stood."""
    f, e, s = x.rows, x.energies, x.squares
    phi = Functions(lambda q: f(q)[0], lambda q: f(q)[1], x.row_hessians)
    square = Functions(lambda q: s(q)[0], lambda q: s(q)[1], x.square_hessians)
    springs = square if x.has_springs else None
    V = Functions(lambda q: e(q)[0], lambda q: e(q)[1], x.energy_hessians, springs)
    moved = {"Q": x.forces if x.has_forces else None, "u": x.signals, "begin_step": x.follow}
    return Problem(M=x.M, q=x.q, v=x.v, phi=phi, potentials=V, **moved)


def run(
    integrator: Integrator,
    times: Sequence[float],
    places: Sequence[int],
    moments: list[Moment],
    *,
    penalty: float | None = None,
    multiplier_update: str = "end",
    **method: Any,
) -> Iterator[list]:
    """Yield the values of the variables at `places` for each time [s].

    The mechanism is started and moves from time to time in steps of its setting `step_size`,
    or `USUAL_STEP`.

    Parameters
    ----------
    moments : list of Moment
        Gets the start and the end of each step.
    penalty : float, optional
        Dimensionless, alpha h^2 sigma/4 of each row; of penalty-velocity alpha sigma. The
        mechanism's setting where left out.
    multiplier_update, **method
        Of `Method`. Updates with the end of each step leave constraints at their round-off; those
        of the paper turn what is missed round from step to step (theory 3.2).

    Raises
    ------
    AssemblyError, OptionError, StepError
        What does not fit together, what this method does not take, or which step fails.
    """
    penalty = float(integrator["solver.penalty"]) if penalty is None else penalty
    check("penalty", penalty, "> 0")
    integrator.initialise()
    integrator.begin()
    first, count = integrator.model.offsets["depth_damping"], integrator.model.sizes["n_potentials"]
    if message := refusal(integrator.model, integrator.numbers[first : first + count]):
        raise OptionError(message)
    x, h = Matrices(integrator), float(integrator["solver.step_size"]) or USUAL_STEP
    per_step = 1.0 if method.get("formulation") == "penalty-velocity" else 4.0 / h**2
    given = {"alpha": per_step * penalty / x.sigma, "multiplier_update": multiplier_update}
    problem, how = problem_of(x), Method(**given, **method)
    moments.append(Moment(times[0], x.q, x.v, 0.0 * x.sigma))
    yield integrator.get(places)
    for before, after in pairwise(times):
        count = math.ceil((after - before) / h - 1e-9)
        for _ in range(count):
            moments.append(at := step(problem, how, moments[-1], (after - before) / count))
            stored = 0.5 * float(how.alpha @ (x.rows(at.q)[0] - x.signals(at.t)) ** 2)
            stored *= how.formulation.endswith("-penalty")
            x.put(integrator, at.t, at.q, at.v, at.iterations[-1].mu, stored)
        yield integrator.get(places)
