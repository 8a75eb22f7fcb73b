"""Splines of the core: slopes over a step are exact, and no table leads a reader beyond it."""

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

from build_kernel.compiler import SOURCES, flags, includes, system_compiler
from solver.mechanics.tape import CODE
from solver.runtime import OptionError
from solver.runtime.kernel import shared_library
from tests.oracle import splines
from tests.scene.test_profiles import WORDS, size_of, tables
from tests.support.kernel.kernel_cases import PROFILES
from tests.support.kernel.twins import model_of

_FOLDER = TemporaryDirectory(prefix="splines-", ignore_cleanup_errors=True)
COMPILER = system_compiler()
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C compiler for a part of the core")


@cache
def library():
    """The file of the core that has splines, by itself."""
    target = Path(_FOLDER.name, "splines.so")
    kernel = Path(__file__).parents[2] / SOURCES
    options = [*flags(platform.system()), *includes(kernel), "-fvisibility=default", "-DDIM=2"]
    subprocess.run(
        [*COMPILER, *options, "-o", str(target), str(kernel / "tape" / "spline.c"), "-lm"],
        check=True,
    )
    loaded = ctypes.CDLL(str(target))
    for name, numbers in (("hm_spline", 1), ("hm_spline_slope", 2)):
        function = getattr(loaded, name)
        function.restype = ctypes.c_double
        function.argtypes = [ctypes.c_int, *[ctypes.c_double] * numbers, *[ctypes.c_void_p] * 2]
    return loaded


def called(name, table, order, *x):
    numbers = array("d", table.numbers)
    first, count = numbers.buffer_info()
    return getattr(library(), name)(order, *x, first, first + 8 * (count - 1))


def value(table, order, x):
    return called("hm_spline", table, order, x)


def slope(table, order, x0, x1):
    return called("hm_spline_slope", table, order, x0, x1)


CONTINUOUS = {"cubic": 2, "monotone": 1, "linear": 0}
"""Derivatives of a profile that do not jump; of these slopes are taken."""
ALL = st.sampled_from(WORDS).flatmap(
    lambda word: st.tuples(tables(words=(word,)), st.integers(0, CONTINUOUS[word]))
)
orders = st.integers(0, 2)
ends = st.floats(-40.0, 40.0)


@needs_compiler
@given(ALL, ends, ends)
def test_slope_times_difference_is_the_difference_over_any_step(given_, x0, x1):
    (*_, table), order = given_
    change = value(table, order, x1) - value(table, order, x0)
    # rounding of the values; and of x, of which whole periods are taken off
    near = size_of(table, order, x0, x1) + (table.numbers[0] > 0.0) * 40.0 * size_of(
        table, order + 1
    )
    assert slope(table, order, x0, x1) * (x1 - x0) == pytest.approx(change, abs=4e-15 * near)


@needs_compiler
@given(tables(words=WORDS), orders, ends, ends)
def test_slopes_are_symmetric_in_the_two_ends(content, order, x0, x1):
    assert slope(content[-1], order, x0, x1) == slope(content[-1], order, x1, x0)


@needs_compiler
@pytest.mark.parametrize("dx", [0.3, 1e-3, 1e-8, 1e-12, 1e-15, 0.0])
@given(
    content=tables(), order=st.integers(0, 1), share=st.floats(0.0, 1.0), knot=st.integers(0, 20)
)
def test_small_steps_lose_no_digits_within_a_piece_and_over_a_knot(content, order, share, knot, dx):
    """Against quadrature; at the ends and the seam of a period as well."""
    x, _, _, table = content
    x0 = x[knot % len(x)] - share * dx
    expected = splines.slope(order, x0, x0 + dx, np.array(table.numbers))
    near = size_of(table, order + 1, x0) + 10.0 * size_of(table, order + 2)
    assert slope(table, order, x0, x0 + dx) == pytest.approx(expected, abs=4e-15 * near)


@needs_compiler
@given(content=tables(), order=orders)
def test_what_is_no_number_is_handed_on(content, order):
    assert math.isnan(value(content[-1], order, math.nan))
    assert math.isnan(slope(content[-1], order, 0.0, math.nan))
    assert math.isnan(slope(content[-1], order, math.nan, math.nan))


def test_a_table_that_leads_beyond_the_numbers_is_refused():
    model = model_of(*PROFILES.values())
    library = shared_library(2)
    model._replace(tables=dict(model.tables)).checked_file(library)
    splines_of = {CODE[name] for name in splines.ORDERS}
    for table, width, first in (("operation", 4, 2), ("tape", 5, 3)):
        numbers = model.tables[table]
        found = [k for k in range(0, len(numbers), width) if numbers[k] in splines_of]
        assert found
        sign = -1 if table == "operation" else 1
        for at in found:
            wrong = [(first + 1, numbers[at + first + 1] + sign * by) for by in (1, 5, -1, 10**6)]
            wrong += [(first, numbers[at + first + 1]), (first, 0 if sign < 0 else -1)]
            wrong += [(first, numbers[at + first + 1] + sign * 6)]
            for place, number in wrong:
                changed = array("i", numbers)
                changed[at + place] = number
                broken = model._replace(tables={**model.tables, table: changed})
                with pytest.raises(OptionError, match="an index leads beyond"):
                    broken.checked_file(library)
