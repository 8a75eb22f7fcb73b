"""Splines of three coordinates in the core: smooth, with slopes over a step that are exact."""

from __future__ import annotations

import ctypes
import math
import platform
import subprocess
from array import array
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.interpolate import NdBSpline

from build_kernel.compiler import SOURCES, flags, includes, system_compiler
from solver.scene.expression import Grid, apply

Array = NDArray[np.float64]
OPERATIONS = ("grid", "grid_x", "grid_y", "grid_z")
ORIGIN, SPACING, SHAPE = np.array([0.3, -0.2, 0.1]), 0.25, (9, 7, 8)
COEFFICIENTS = np.random.default_rng(5).normal(size=SHAPE)
TABLE = Grid("g", array("d", [*ORIGIN, SPACING, *SHAPE, *COEFFICIENTS.ravel()]))
SIZE = SPACING * (np.array(SHAPE) - 3)
_FOLDER = TemporaryDirectory(prefix="grids-", ignore_cleanup_errors=True)
COMPILER = system_compiler()
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C compiler for a part of the core")


@cache
def library() -> ctypes.CDLL:
    """The file of the core that has grids, by itself."""
    target = Path(_FOLDER.name, "grids.so")
    kernel = Path(__file__).parents[2] / SOURCES
    options = [*flags(platform.system()), *includes(kernel), "-fvisibility=default", "-DDIM=3"]
    subprocess.run(
        [*COMPILER, *options, "-o", str(target), str(kernel / "tape" / "grid.c"), "-lm"], check=True
    )
    loaded = ctypes.CDLL(str(target))
    loaded.hm_grid.restype = ctypes.c_double
    loaded.hm_grid.argtypes = [ctypes.c_int, *[ctypes.c_void_p] * 3]
    loaded.hm_grid_jet.restype = Jet
    loaded.hm_grid_jet.argtypes = [ctypes.c_int, *[ctypes.c_void_p] * 3]
    loaded.hm_grid_slopes.restype = None
    loaded.hm_grid_slopes.argtypes = [ctypes.c_int, *[ctypes.c_void_p] * 5]
    return loaded


def value(order: int, x: Array, numbers: Array | None = None) -> float:
    table = np.array(TABLE.numbers) if numbers is None else numbers
    x = np.ascontiguousarray(x, float)
    ends = table.ctypes.data, table.ctypes.data + 8 * (len(table) - 1)
    return library().hm_grid(order, x.ctypes.data, *ends)


def slopes(order: int, x0: Array, x1: Array) -> Array:
    table, found = np.array(TABLE.numbers), np.empty(3)
    x0, x1 = (np.ascontiguousarray(x, float) for x in (x0, x1))
    ends = table.ctypes.data, table.ctypes.data + 8 * (len(table) - 1)
    library().hm_grid_slopes(order, x0.ctypes.data, x1.ctypes.data, *ends, found.ctypes.data)
    return found


def exact(x: Array, derivatives: tuple[int, ...]) -> float:
    knots = tuple(
        SPACING * (np.arange(n + 4) - 3.0) + x0 for n, x0 in zip(SHAPE, ORIGIN, strict=True)
    )
    return float(NdBSpline(knots, COEFFICIENTS, 3)(x, nu=derivatives))


share = st.floats(0.0, 1.0)
places = st.tuples(share, share, share).map(lambda s: ORIGIN + SIZE * np.array(s))
orders = st.integers(0, 3)


@given(places, orders)
def test_values_and_derivatives_are_those_of_the_tensor_product(x, order):
    derivatives = tuple(int(axis + 1 == order) for axis in range(3))
    found = apply(OPERATIONS[order], *x, TABLE)
    assert found == pytest.approx(exact(x, derivatives), abs=1e-13 / SPACING)


@needs_compiler
@given(places, places, orders)
def test_slopes_times_differences_are_the_difference_over_any_step(x0, x1, order):
    change = value(order, x1) - value(order, x0)
    assert slopes(order, x0, x1) @ (x1 - x0) == pytest.approx(change, abs=2e-14 / SPACING)


@needs_compiler
@pytest.mark.parametrize("size", [1e-3, 1e-8, 1e-12, 0.0])
@given(x=places, order=orders, way=st.tuples(share, share, share))
def test_small_steps_lose_no_digits(size, x, order, way):
    """Slopes over them are the gradient in the middle, to second order in the step."""
    x1 = np.clip(x + size * np.array(way), ORIGIN, ORIGIN + SIZE)
    middle = 0.5 * (x + x1)
    base = [int(axis + 1 == order) for axis in range(3)]
    gradient = [exact(middle, tuple(np.add(base, row))) for row in np.eye(3, dtype=int)]
    error = 1e-12 + 100.0 * (size / SPACING) ** 2
    assert slopes(order, x, x1) == pytest.approx(gradient, abs=error / SPACING**2)


@needs_compiler
@given(places, places, orders)
def test_slopes_are_symmetric_in_the_two_ends(x0, x1, order):
    assert slopes(order, x0, x1) == pytest.approx(slopes(order, x1, x0), abs=1e-12 / SPACING**2)


@needs_compiler
@pytest.mark.parametrize("axis", range(3))
@given(x=places, face=st.integers(1, 4))
def test_curvature_is_continuous_across_cells(axis, x, face):
    """Slopes of derivatives at a face, from both sides; the third derivative jumps there."""
    x = x.copy()
    x[axis] = ORIGIN[axis] + SPACING * face
    step = 1e-9 * SPACING * np.eye(3)[axis]
    for order in range(1, 4):
        before, behind = (slopes(order, x + s, x + s) for s in (-step, step))
        assert before == pytest.approx(behind, abs=1e-7 / SPACING**2)


@needs_compiler
def test_what_is_no_number_is_handed_on_and_no_place_leads_beyond_the_table():
    middle = ORIGIN + 0.5 * SIZE
    for axis in range(3):
        for far in (math.nan, math.inf, -math.inf, 1e300):
            x = middle.copy()
            x[axis] = far
            assert far == 1e300 or not math.isfinite(value(0, x))
            slopes(0, middle, x)
            slopes(0, x, middle)


@needs_compiler
@pytest.mark.parametrize(
    "counts", [(9, 7, 9), (3, 7, 8), (1e300, 7, 8), (math.nan, 7, 8), (-9, -7, 8)]
)
def test_a_table_of_another_size_has_no_value(counts):
    numbers = np.array(TABLE.numbers)
    numbers[4:7] = counts
    assert math.isnan(value(0, ORIGIN, numbers))


class Jet(ctypes.Structure):
    """A number that changes with time, `hm_jet` of the core."""

    _fields_ = [(name, ctypes.c_double) for name in ("value", "rate", "bend")]


def bend(place: Array, rates: Array) -> float:
    """Second derivative in time of the slope along x where a place moves at constant rates.

    The grid begins at 0, so that faces of its cubes are known to the last bit.
    """
    table = np.array([*np.zeros(3), *TABLE.numbers[3:]])
    coordinates = (Jet * 3)(*(Jet(x, v, 0.0) for x, v in zip(place, rates, strict=True)))
    ends = table.ctypes.data, table.ctypes.data + 8 * (len(table) - 1)
    return library().hm_grid_jet(1, ctypes.addressof(coordinates), *ends).bend


@needs_compiler
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_place_between_cubes_moves_in_the_cube_that_it_comes_to(way):
    """The third derivative along x is constant along x within a cube, and jumps between cubes."""
    face = SPACING * np.array([3.0, 1.5, 2.25])
    along = np.array([way, 0.0, 0.0])
    inside = bend(face + 0.5 * SPACING * along, along)
    assert bend(face, along) == pytest.approx(inside, rel=1e-12)
    assert bend(face, along) != pytest.approx(bend(face, -along), rel=0.1)
