"""Energies and the ledger of a step.

    Delta E = work - dissipated - dPhi' mu + v_mid' R

term by term and exactly, for any mu and R (paper, eqs 10 and 17): `defect` and `residual` are what
an unfinished iteration leaves. Work is that of loads, moments, drives, signals and driven nodes.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from .course import ANGLE, Course, Present
from .equations import penalties
from .forces import carried, couple, directors_moved
from .laws import elements, over_step
from .mechanism import Mechanism
from .state import Motion
from .step import Step

Array = NDArray[np.float64]


def stored_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy k (sigma - rest)^2/2 of all springs, and that of the potentials [J]."""
    present = Present(mechanism, motion)
    springs = math.fsum(
        0.5 * law.stiffness * (present.sigma[law.quantity] - law.rest) ** 2
        for law in elements(mechanism)
        if law.stiffness != 0.0
    )
    values = present.values()
    return springs + math.fsum(
        over_step(mechanism, potential, values).value.n for potential in mechanism.potentials
    )


def penalty_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy alpha Phi^2/2 that eqs 7, 9 and 11 store in their rows [J]; eq 3 has no potential."""
    if not motion.formulation.endswith("-penalty"):
        return 0.0
    phi = mechanism.quadratic_phi(motion.q, motion.q_low)
    alpha = penalties(mechanism, motion, motion.head["step_size"])[: len(phi)]
    return float(np.sum(0.5 * alpha * phi**2))


def potential_change(mechanism: Mechanism, motion: Motion) -> float:
    """Change of the energy of gravity, springs, potentials and penalties since the start [J].

    Weights act on displacements: on positions they would lose the digits by which the mechanism is
    far from the origin.
    """
    moved = (motion.q - motion.vectors["start"]) + motion.q_low
    stored = stored_energy(mechanism, motion) + penalty_energy(mechanism, motion)
    return math.fsum(-mechanism.weight * moved) + (stored - motion.head["stored_start"])


def momentum(mechanism: Mechanism, motion: Motion) -> Array:
    """Momenta M v of the nodes, shape (n_moving, dim)."""
    return (mechanism.M @ (motion.v + motion.v_low)).reshape(-1, mechanism.dim)


def kinetic_energy(mechanism: Mechanism, motion: Motion) -> float:
    """Energy v' M v/2 [J]."""
    return float(0.5 * np.sum(momentum(mechanism, motion).ravel() * motion.v))


def start_ledger(mechanism: Mechanism, motion: Motion) -> None:
    """Begin the ledger at the present state."""
    head, section = motion.head, mechanism.section
    motion.vectors["start"][:] = motion.q
    kinetic = kinetic_energy(mechanism, motion)
    head["kinetic_start"] = kinetic
    head["stored_start"] = stored_energy(mechanism, motion) + penalty_energy(mechanism, motion)
    head["potential_start"] = head["stored_start"] - float(mechanism.weight @ motion.q)
    # A floor, so that a mechanism at rest has a finite relative error.
    mass, gravity = float(np.sum(section["node_weight"])), math.hypot(*section["gravity"])
    weight_times_size = mass * gravity * section["extent"][0]
    floor = 1e-3 * (weight_times_size + abs(head["stored_start"]))
    head["energy_reference"] = max(kinetic, floor)


def follow_energy_reference(mechanism: Mechanism, motion: Motion) -> None:
    """Let the reference energy be the largest kinetic energy or change of potential seen so far."""
    change = abs(potential_change(mechanism, motion))
    # A thousandth of what loads, moments and drives could do over the size of the mechanism.
    extent = mechanism.section["extent"][0]
    load = np.sum(np.linalg.norm(mechanism.load, axis=1)) * extent
    turning = np.sum(np.abs(mechanism.moment)) + np.sum(np.abs(mechanism.couples))
    for law in elements(mechanism):
        is_angle = mechanism.quantities[law.quantity][0] == ANGLE
        load += abs(law.drive) * (1.0 if is_angle else extent)
    motion.head["energy_reference"] = max(
        motion.head["energy_reference"],
        kinetic_energy(mechanism, motion),
        change,
        1e-3 * float(load + turning),
    )


def book_step(step: Step) -> Array:
    """Book a solved step in the ledger, before the state takes it over; return R [N s]."""
    mechanism, motion, h = step.mechanism, step.motion, step.h
    trial, free = step.equations.trial(step.w), mechanism.n_free
    for mu, change, by_signals in zip(
        step.mu, trial.rows.change, trial.rows.by_signals, strict=True
    ):
        motion.book("defect", mu * change)
        motion.book("work", mu * by_signals)
    balance = step.equations.balance(step.w, step.mu)
    powers = trial.d * balance / h
    for power in powers[:free]:
        motion.book("residual", power)
    for power in powers[free:]:
        motion.book("work", power)
    book_loads(mechanism, motion, trial.course)
    book_laws(mechanism, motion, trial.course)
    return balance


def book_loads(mechanism: Mechanism, motion: Motion, course: Course) -> None:
    """Book the work of loads and moments."""
    x_mid = course.over_step().coordinates()
    axes = zip(mechanism.load_form, mechanism.load_axes, mechanism.load, strict=True)
    for form, first, load in axes:
        width = 1 if mechanism.dim == 2 else 3
        nodes = slice(mechanism.dim * first, mechanism.dim * (first + width))
        F = load if first < 0 else carried(x_mid[nodes], load)
        motion.book("work", float(F @ course.du[form]))
    for form, moment in zip(mechanism.moment_form, mechanism.moment, strict=True):
        f, _ = couple(moment, course.present.u[form], course.du[form])
        motion.book("work", float(f @ course.du[form]))
    for (first, frame), moment in zip(mechanism.body_moments, mechanism.couples, strict=True):
        nodes = slice(3 * first, 3 * first + 9)
        motion.book("work", float(directors_moved(x_mid[nodes], moment, frame) @ course.d[nodes]))


def book_laws(mechanism: Mechanism, motion: Motion, course: Course) -> None:
    """Book what dampers take out, and the work of drives."""
    values = course.values
    for law in elements(mechanism):
        if law.damping != 0.0 or law.drive != 0.0:
            change = values.quantity(law.quantity)[0].d
            motion.book("dissipated", law.damping * change**2 / values.h)
            motion.book("work", law.drive * change)
