"""The core's elementary functions: below 1 ulp, C99's special values, the same bits everywhere."""

from __future__ import annotations

import itertools
import math
import platform
import random
import re
import shutil
import struct
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from mpmath import asin, atan, chebyfit, log, mp, mpf, pi, sqrt

from build_kernel.compiler import includes, system_compiler, zig_compiler
from tests.support.kernel.elementary_errors import (
    KERNEL,
    ONE,
    SOURCES,
    TWO,
    argument,
    core,
    largest_error,
)

CASES = 1500
BITS_CASES = 100_000
TINY = 2.0**-1074

pytestmark = pytest.mark.skipif(not (system_compiler() or zig_compiler()), reason="no C compiler")


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_an_elementary_function_is_off_by_less_than_an_ulp(name):
    error, values = largest_error(name, CASES)
    assert error < 1.0, values


SPECIAL = [
    0.0, TINY, 2.0**-1022, 1e-300, 1e-20, 1e-8, 0.5, 1.0, 1.0 - 2.0**-53, 1.0 + 2.0**-52, 1.5, 2.0,
    3.0, 21.9, 22.1, 709.7, 709.8, 710.4, 710.5, 745.1, 745.2, 1e6, 2.0**53 - 1, 2.0**53, 1e22,
    1e300, 1.7976931348623157e308, math.inf, math.nan,
]  # fmt: skip


def by_python(name: str, values: tuple[float, ...]) -> float | None:
    """C99's value of a special argument; None where Python raises instead of naming it."""
    try:
        return getattr(math, name)(*values)
    except (ValueError, OverflowError):
        return None


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_special_arguments_have_the_values_of_c(name):
    signed = [*SPECIAL, *(-x for x in SPECIAL)]
    for values in itertools.product(signed, repeat=1 if name in ONE else 2):
        expected, found = by_python(name, values), core(name)(*values)
        if expected is None:
            assert not math.isfinite(found), values
        elif math.isnan(expected):
            assert math.isnan(found), values
        elif expected == 0.0 or math.isinf(expected):
            assert struct.pack("d", found) == struct.pack("d", expected), values
        else:  # glibc's is off by up to an ulp as well
            assert abs(found - expected) <= 2.0 * math.ulp(expected), values


@pytest.mark.parametrize("name", ["sin", "tan", "asin", "atan", "sinh", "tanh", "atanh"])
def test_an_odd_function_is_odd_to_the_bit(name):
    chance, function = random.Random(f"odd {name}"), core(name)
    for _ in range(CASES):
        x = argument(chance, name)
        assert function(-x) == -function(x)


HASHES = """
sin 1278494189aaed69
cos 56df7ff98ee4ee77
tan 9168483d42af4e7a
asin f61be1c5ba6a81ae
acos cd2527437d90f72b
atan a220cd23b5bee7d0
exp 41d7e9d9e718618f
log 48561cd5ca006c80
sinh b88fdb6edf15859b
cosh 33b448c0f4c9f2eb
tanh b2c50df8ece3edfe
atanh 865a4bb78955f3e2
atan2 6f32250800a90700
pow 18f64626a6b723c9
hypot 8480aa6d226fc559
"""
"""Of what `elementary_bits.c` computes, on every machine."""

NATIVE = "" if platform.machine() not in ("x86_64", "AMD64") else " -march=native"


@pytest.mark.parametrize("compiler", ["gcc", "clang", "aarch64-linux-gnu-gcc", "the chosen one"])
@pytest.mark.parametrize("flags", ["-O0", "-std=gnu99 -O3" + NATIVE])
def test_the_bits_are_the_same_from_each_compiler_and_on_each_machine(compiler, flags, tmp_path):
    chosen = system_compiler() or zig_compiler() or []
    command = chosen if compiler.startswith("the") else [compiler]
    if not shutil.which(command[0]):
        pytest.skip(f"{command[0]} is not installed")
    run = []
    if compiler.startswith("aarch64"):
        if not shutil.which("qemu-aarch64"):
            pytest.skip("qemu-aarch64 is not installed")
        run, flags = ["qemu-aarch64"], flags.removesuffix(NATIVE) + " -static"
    files = [*SOURCES, str(Path(__file__).parents[1].joinpath("support/kernel/elementary_bits.c"))]
    target = str(tmp_path / "bits")
    subprocess.run(
        [*command, *flags.split(), *includes(KERNEL), *files, "-o", target, "-lm"], check=True
    )
    found = subprocess.run(
        [*run, target, str(BITS_CASES)], check=True, stdout=subprocess.PIPE, text=True
    )
    assert found.stdout == HASHES.lstrip()


def table_of(name: str) -> list[float]:
    """Numbers of a table, as the core has them."""
    files = (*KERNEL.glob("math/exponential*"), *KERNEL.glob("math/trigonometric*"))
    text = "".join(path.read_text("utf-8") for path in files)
    (body,) = re.findall(rf" {name}\[\d+\] = (.*?);", text, re.DOTALL)
    return [float.fromhex(x) for x in re.findall(r"-?(?:0x1[.0-9a-f]*p[-+]\d+|0\.0)", body)]


DEFINITIONS: dict[str, tuple[int, Callable[[int], Any]]] = {
    "ROOTS_OF_TWO": (2, lambda j: mpf(2) ** (mpf(j) / 64)),
    "LOGARITHMS": (2, lambda j: -log(table_of("RECIPROCALS")[j])),
    "LN2": (2, lambda _: log(2)),
    "LN2_OVER_64": (2, lambda _: log(2) / 64),
    "ANGLES": (2, lambda j: atan(mpf(j) / 32)),
    "HALF_PI": (4, lambda _: pi / 2),
    "PI": (2, lambda j: (j + 1) * pi / 2),
}
"""How many doubles add up to an entry of a table, and what that is."""


@pytest.mark.parametrize("name", DEFINITIONS)
def test_the_doubles_of_a_table_add_up_to_its_definition(name):
    width, meaning = DEFINITIONS[name]
    numbers = table_of(name)
    with mp.workprec(300):
        for j in range(len(numbers) // width):
            exact, found = meaning(j), sum(map(mpf, numbers[width * j : width * (j + 1)]))
            assert abs(found - exact) <= 2.0**-84 * max(abs(exact), mpf(2) ** -10), j


def test_the_series_of_the_arcsine_is_near_minimax():
    with mp.workprec(300):
        terms = lambda q: (asin(sqrt(q)) / sqrt(q) - 1) / q if q else mpf(1) / 6  # noqa: E731
        assert table_of("ARCSINE") == [float(x) for x in chebyfit(terms, [0, 0.25], 13, asc=True)]
