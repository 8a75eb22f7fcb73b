"""Formulation against step: what the methods of García Orden & Ortega do to energy and constraints.

Steps of `solver.paper`, with penalties of 1e8 over the square of the step. A run has failed when a
step cannot be solved, or when the energy error exceeds ten times the mechanism's weight times its
length: from then on the motion is not that of the mechanism.
"""

from __future__ import annotations

from itertools import islice

import numpy as np

from benchmarks.effort import Effort
from benchmarks.mechanisms import GRAVITY, hanging_chain, start
from benchmarks.report import Section, Table, Value
from solver.mechanics.matrices import Matrices
from solver.paper import FORMULATIONS, Method, motion, problem_of
from solver.runtime import StepError

PENALTY = 1e8
STOP = 20.0
STEPS = (0.05, 0.02, 0.01, 0.005)
RODS = {"double pendulum": 2, "chain of 5": 5}
BLOW_UP = 10.0

COLUMNS = {
    "formulation": "formulation",
    "h": "h, s",
    "energy": "largest |ΔE|, J",
    "balance": "with penalties, J",
    "residual": "largest |Φ|/L²",
    "end": "outcome",
}
FORMATS = {"h": "g", "energy": ".1e", "balance": ".1e", "residual": ".1e"}


def measure(effort: Effort) -> Section:
    stop = max(0.1, STOP * effort.scale)
    tables = [
        Table(
            title=f"{name.capitalize()}, {stop:g} s",
            columns=COLUMNS,
            rows=[
                {"formulation": formulation, "h": h} | run(n, formulation, h, stop)
                for formulation in FORMULATIONS
                for h in STEPS
            ],
            formats=FORMATS,
        )
        for name, n in RODS.items()
    ]
    return Section(
        name="formulations",
        title="Formulation against step",
        method=(
            "Unit rods and masses from rest in the horizontal, by `solver.paper` with the "
            "dimensionless penalty 1e8. Energy and constraints are calculated from positions and "
            "velocities after every step; *with penalties* counts the energy that violated "
            "constraints store in their penalties. A run has failed when a step cannot be solved, "
            f"or when its energy error exceeds {BLOW_UP:g} N m g L."
        ),
        tables=tables,
    )


def run(n: int, formulation: str, h: float, stop: float) -> dict[str, Value]:
    """Errors of a chain of n rods until `stop` or until it fails."""
    integrator = start(hanging_chain(n), step_size=h)
    integrator.begin()
    x = Matrices(integrator)
    problem = problem_of(x)
    per_step = 1.0 if formulation == "penalty-velocity" else 4.0 / h**2
    method = Method(alpha=PENALTY * per_step / x.sigma, formulation=formulation, update="end")
    stores = formulation.endswith("-penalty")
    energies, balances, residuals, end = [], [], [], "finished"
    try:
        for at in islice(motion(problem, method, h), 1 + max(1, round(stop / h))):
            phi = problem.phi.value(at.q)
            own = 0.5 * at.v @ problem.M @ at.v + problem.potentials.value(at.q).sum()
            energies.append(own)
            balances.append(own + stores * 0.5 * float(method.alpha @ phi**2))
            residuals.append(float(np.abs(phi).max()))
            if not abs(own - energies[0]) <= BLOW_UP * n * GRAVITY:
                end = f"energy lost at {at.t:.2f} s"
                break
    except StepError:
        end = f"step failed at {len(energies) * h:.2f} s"
    return {
        "energy": max(abs(e - energies[0]) for e in energies),
        "balance": max(abs(e - balances[0]) for e in balances),
        "residual": max(residuals),
        "end": end,
    }
