"""Runs of random systems, each in its way, and their error."""

from __future__ import annotations

import warnings
from collections.abc import Mapping

import numpy as np

import solver
from tests.truth.random_systems import HALF, POINTS, STOP, WAYS, Array, Scene, System
from tests.truth.system import System as Measured
from tests.truth.system import kind_of

TIMES = np.linspace(0.0, STOP, POINTS + 1)


def error(system: System, scene: Scene, right: Mapping[str, Array], tolerance: float) -> float:
    """Largest error of a run, over the largest right value of its kind; angles in rad."""
    measure = Measured(
        name=system.name, kind="random", origin="", scene=scene, stop=STOP, right=lambda _: right,
    )  # fmt: skip
    scales = measure.scales(right)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = run(system, measure.read(), list(right), tolerance)
    sizes = np.array([scales[kind_of(name)] for name in right])
    return float(np.max(np.abs(found - np.array([*right.values()]).T) / sizes))


def run(system: System, scene: solver.Scene, names: list[str], tolerance: float) -> Array:
    """Values (n, len(names)) at the communication points, in the system's way.

    A run that is restarted, and one from a state saved in its middle, repeat its values to the bit.
    """
    integrator = solver.Integrator(solver.assemble(scene))
    table = _moved(system, integrator, names, tolerance)
    if system.way == WAYS[1]:
        integrator.reset()
        assert np.array_equal(_moved(system, integrator, names, tolerance), table)
    if system.way == WAYS[2]:
        middle = POINTS // 2
        integrator.reset()
        _moved(system, integrator, names, tolerance, 0, middle)
        saved = integrator.save()
        _moved(system, integrator, names, tolerance, middle)
        integrator.restore(saved)
        rest = _moved(system, integrator, names, tolerance, middle)
        assert np.array_equal(rest, table[middle:])
    return table


def _moved(
    system: System, integrator: solver.Integrator, names: list[str], tolerance: float,
    first: int = 0, last: int = POINTS,
) -> Array:  # fmt: skip
    """Values from one communication point to another."""
    indices = [integrator.model.index(name) for name in names]
    if first == 0:
        integrator["solver.tolerance"] = tolerance
        integrator.state.head["horizon"] = STOP
    rows = [integrator.get(indices)]
    for k in range(first, last):
        _give(system, integrator, k)
        integrator.advance(float(TIMES[k]), float(TIMES[k + 1] - TIMES[k]))
        rows.append(integrator.get(indices))
    return np.array(rows, dtype=float)


def _give(system: System, integrator: solver.Integrator, k: int) -> None:
    """Set what comes from outside before step k: smooth inputs at its end, parameters as they jump."""
    if system.changing is None:
        return
    words = system.links[system.changing].torque.split()
    if system.way == WAYS[3]:
        integrator["u"] = float(words[0].partition("*")[0]) * float(TIMES[k + 1]) ** 2
    elif TIMES[k] >= HALF:
        integrator["u"] = float(words[-1])
