"""Formulation against step: what the methods of García Orden & Ortega do to energy and constraints.

By `solver.paper`, nested, with the penalty that is the solver's default. A run has failed when a
step cannot be solved, or when the energy error exceeds ten times the mechanism's weight times its
length: from then on the motion is not that of the mechanism.
"""

from __future__ import annotations

from benchmarks.measuring.effort import Effort
from benchmarks.measuring.observe import Observer
from benchmarks.pages.report import Section, Table, Value
from benchmarks.problems.mechanisms import GRAVITY, hanging_chain, start
from solver.paper import FORMULATIONS
from solver.paper_scenes import run as moved
from solver.runtime import StepError

STOP = 20.0
STEPS = (0.05, 0.02, 0.01, 0.005)
RODS = {"double pendulum": 2, "chain of 5": 5}
BLOW_UP = 10.0

COLUMNS = {
    "formulation": "formulation",
    "h": ("h, s", "g"),
    "energy": ("largest |ΔE|, J", ".1e"),
    "balance": ("with penalties, J", ".1e"),
    "residual": ("largest |Φ|/L²", ".1e"),
    "end": "outcome",
}


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
        )
        for name, n in RODS.items()
    ]
    return Section(
        name="formulations",
        title="Formulation against step",
        method=(
            "Unit rods and masses from rest in the horizontal, by `solver.paper`: nested, updates "
            "with the end of the step, penalty 1e8. Energy and constraints are calculated from "
            "positions and velocities after every step; *with penalties* is the balance of all "
            "energies, which counts what violated constraints store in their penalties. A run has "
            "failed when a step cannot be solved, or when its energy error exceeds "
            f"{BLOW_UP:g} N m g L."
        ),
        tables=tables,
    )


def run(n: int, formulation: str, h: float, stop: float) -> dict[str, Value]:
    """Errors of a chain of n rods until `stop` or until it fails."""
    content = hanging_chain(n)
    integrator = start(content, step_size=h)
    observer = Observer(content, integrator)
    initial, limit = observer.energy(), BLOW_UP * n * GRAVITY
    place = integrator.model.index("energy.balance")
    energy = residual = balance = 0.0
    end, times = "finished", [h * k for k in range(max(1, round(stop / h)) + 1)]
    try:
        for (left,) in moved(integrator, times, [place], [], formulation=formulation):
            error = abs(observer.energy() - initial)
            residual = max(residual, observer.residual())
            balance = max(balance, abs(left))
            energy = max(energy, error)
            if not energy <= limit:
                end = f"energy lost at {integrator.time:.2f} s"
                break
    except StepError:
        end = f"step failed at {integrator.time:.2f} s"
    return {"energy": energy, "balance": balance, "residual": residual, "end": end}
