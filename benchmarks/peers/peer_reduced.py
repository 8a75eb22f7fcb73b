"""Equations of the problems in fewest coordinates, compiled from `benchmarks/peers/peer_rates/*.c`.

Four-bar, Andrews and Bricard have one coordinate each, the governor and the car axis two; the
chains keep the places of their points, with multipliers from differentiated rows. Needs NumPy and
a C compiler; nothing of holonom's solver, so that the solutions are independent of it.
"""

from __future__ import annotations

import ctypes
import functools
import math
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.problems.parts import Array, Problem
from build_kernel.compiler import any_compiler

SOURCES = Path(__file__).with_name("peer_rates")
FLAGS = ("-std=c99", "-O3", "-fPIC", "-shared", "-fvisibility=hidden")

Rates = Callable[[float, Array], Array]


@dataclass(frozen=True, slots=True)
class Reduced:
    """y' = rates(t, y) with its start, and what is read of a state."""

    start: Array
    rates: Rates
    """Returns the same array at every call: copy what is to be kept."""
    address: int
    """Of the C function `void rates(double t, const double *y, double *dy, const double *p)`."""
    constants: Array
    look: Callable[[float, Array], tuple[Array, Array, float]]
    """Positions and velocities of the watched places, shape (places, 3), and the energy [J]."""


@functools.cache
def library() -> ctypes.CDLL:
    """The compiled equations."""
    with tempfile.TemporaryDirectory(prefix="peer-rates-", ignore_cleanup_errors=True) as folder:
        path = Path(folder, "rates.so")
        sources = [str(source) for source in sorted(SOURCES.glob("*.c"))]
        subprocess.run([*any_compiler(), *FLAGS, "-o", str(path), *sources, "-lm"], check=True)
        return ctypes.CDLL(str(path))


def family(problem: Problem) -> str:
    """First part of a problem's key, by which its equations are named."""
    return problem.key.rstrip("0123456789").rstrip("_")


def unwritten(problem: Problem) -> str:
    """Excuse of a code that needs the equations; empty where there are some."""
    return "" if family(problem) in FAMILIES else "not measured: no reduced equations of it"


def reduced(problem: Problem) -> Reduced:
    """Reduced equations of a problem."""
    name = family(problem)
    constants, start = (np.array(list_, dtype=float) for list_ in FAMILIES[name](problem))
    functions = (getattr(library(), f"{name}_{kind}") for kind in ("rates", "look"))
    rates, look = functions
    for function in (rates, look):
        function.restype = None
        function.argtypes = (ctypes.c_double, *(ctypes.c_void_p,) * 3)
    places = len(problem.watch)
    y_in, y_out, seen = np.empty_like(start), np.empty_like(start), np.empty(6 * places + 1)
    # Addresses are taken once: a call from Python then costs less than a microsecond.
    # data_as keeps the array that it points to alive; its bare address would not.
    arrays = (y_in, y_out, constants, seen)
    at = [array.ctypes.data_as(ctypes.c_void_p) for array in arrays]

    def slopes(t: float, y: Array) -> Array:
        y_in[:] = y
        rates(t, at[0], at[1], at[2])
        return y_out

    def looked(t: float, y: Array) -> tuple[Array, Array, float]:
        y_in[:] = y
        look(t, at[0], at[3], at[2])
        q, v = seen[:-1].reshape(2, places, 3).copy()
        return q, v, float(seen[-1])

    address = ctypes.cast(rates, ctypes.c_void_p).value or 0
    return Reduced(start, slopes, address, constants, looked)


# ------------------------------------------------- constants and start, in the order of the C files

Numbers = tuple[list[float], list[float]]


def _double_pendulum(problem: Problem) -> Numbers:
    k = problem.data
    return [k["length"], k["mass"], k["gravity"]], [k["angle"], k["angle"], 0.0, 0.0]


def _four_bar(problem: Problem) -> Numbers:
    n, g = problem.data["loops"], problem.data["gravity"]
    return [(n + 1) / 3 + n, (n + 1) / 2 + n, g, n], [0.0, 1.0]


def _andrews(problem: Problem) -> Numbers:
    k = problem.data
    bodies = {
        1: (k["rr"], k["ra"], 0.0),
        2: (k["d"], k["da"], 0.0),
        3: (k["ss"], k["sa"], k["sb"]),
        4: (k["e"], k["e"] - k["ea"], 0.0),
        5: (k["zt"], k["ta"], k["tb"]),
        6: (k["zf"], k["zf"] - k["fa"], 0.0),
        7: (k["u"], k["ua"], k["ub"]),
    }
    numbers = []
    for i, (length, along, across) in bodies.items():
        numbers += [length, k[f"m{i}"], k[f"i{i}"], along, across]
    names = ("xa", "ya", "xb", "yb", "xc", "yc", "sc", "sd", "c0", "l0", "torque")
    return numbers + [k[name] for name in names], [k["beta"], 0.0]


def _bricard(problem: Problem) -> Numbers:
    k = problem.data
    square = k["width"] ** 2
    along, across = k["mass"] * square / 6, k["mass"] * (k["length"] ** 2 + square) / 12
    numbers = [k["length"], k["mass"], along, across, k["gravity"]]
    return numbers, [math.asin(1 / math.sqrt(3)), 0.0]


def _heavy_top(problem: Problem) -> Numbers:
    k = problem.data
    turn = problem.bodies["top"].turn
    half = 0.5 * math.hypot(*turn)
    quaternion = [math.cos(half), *(math.sin(half) * x / (2 * half) for x in turn)]
    numbers = [k["transverse"], k["axial"], k["moment"], k["gravity"]]
    return numbers, [*quaternion, 0.0, 0.0, k["spin"]]


def _car_axis(problem: Problem) -> Numbers:
    k = problem.data
    names = ("mass", "length", "free_length", "wave", "omega", "stiffness", "gravity")
    return [k[name] for name in names], [0.5, 0.0, 0.0, 0.0]


def _chain(problem: Problem) -> Numbers:
    bodies = problem.bodies.values()
    places = [x for body in bodies for x in body.position]
    speeds = [x for body in bodies for x in body.velocity]
    return [problem.data["count"], problem.data["mass"]], places + speeds


def _hanging_chain(problem: Problem) -> Numbers:
    k = problem.data
    n, inner = int(k["count"]), int(k["count"]) - 1
    M = k["mass"] / 6 * (4 * np.eye(inner) + np.eye(inner, k=1) + np.eye(inner, k=-1))
    inverse, D = np.linalg.inv(M), np.eye(n, inner) - np.eye(n, inner, k=-1)
    middle = n // 2 - 1
    numbers = [n, k["mass"], k["gravity"], k["damping"], middle]
    nodes = []
    for i in range(1, n):
        nodes += [-math.cos(math.pi * i / n), -math.sin(math.pi * i / n)]
    return [*numbers, *inverse.ravel(), *(D @ inverse @ D.T).ravel()], [*nodes, *[0.0] * len(nodes)]


def _governor(problem: Problem) -> Numbers:
    k, bodies = problem.data, problem.bodies
    middle = bodies["shaft"].inertia[2] + bodies["slider"].inertia[2]
    along, across = (k["rod"] / 12 * x for x in (2 * 0.01**2, 1.0 + 0.01**2))
    momentum = middle * k["speed"]
    for side in ("right", "left"):
        body = bodies[side]
        J = body.attitude @ np.diag(body.inertia) @ body.attitude.T
        momentum += (J[2, 2] + body.mass * body.position[0] ** 2) * k["speed"]
    names = ("rod", "ball", "slider", "stiffness", "damping", "gravity")
    numbers = [*(k[name] for name in names), momentum, middle, across, along]
    return numbers, [0.5, k["alpha"], 0.0, 0.0, 0.0]


FAMILIES: dict[str, Callable[[Problem], Numbers]] = {
    "double_pendulum": _double_pendulum,
    "four_bar": _four_bar,
    "andrews": _andrews,
    "bricard": _bricard,
    "heavy_top": _heavy_top,
    "car_axis": _car_axis,
    "chain": _chain,
    "hanging_chain": _hanging_chain,
    "governor": _governor,
}
"""By the first part of the problem's key and of the names of the C functions."""
