"""Errors of the core's elementary functions against mpmath.

`python -m tests.support.kernel.elementary_errors COUNT` prints the largest of so many random
arguments each.
"""

from __future__ import annotations

import ctypes
import functools
import math
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import mpmath

from build_kernel.compiler import system_compiler, zig_compiler

KERNEL = Path(__file__).parents[3] / "solver" / "kernel"
SOURCES = [str(KERNEL / "math" / name) for name in ("exponential.c", "trigonometric.c")]
ONE = (
    "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "atanh",
)  # fmt: skip
TWO = ("atan2", "pow", "hypot")


@functools.cache
def library() -> ctypes.CDLL:
    """The functions as this machine's compiler makes them."""
    compiler = system_compiler() or zig_compiler() or ["cc"]
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder, "elementary.so")
        flags = ["-std=c99", "-O3", "-ffp-contract=off", "-fPIC", "-shared"]
        command = [*compiler, *flags, "-o", str(target), *SOURCES, "-lm"]
        subprocess.run(command, check=True)
        return ctypes.CDLL(str(target))


def core(name: str) -> Callable[..., float]:
    """Return a function of the core by its name in C."""
    function = getattr(library(), f"hm_{name}")
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_double] * (1 if name in ONE else 2)
    return function


def scattered(chance: random.Random, low: int, high: int) -> float:
    """Number of either sign with an exponent between two."""
    return chance.choice([1, -1]) * math.ldexp(chance.uniform(0.5, 1), chance.randint(low, high))


def near_a_multiple_of_half_pi(chance: random.Random) -> float:
    """Argument of sine and tangent whose remainder has lost most of its digits."""
    multiple = chance.randint(1, 10**6) * math.pi / 2
    return multiple * (1 + chance.choice([0, 1, -1, 3]) * 2.0**-52)


def argument(chance: random.Random, name: str) -> float:
    """Return one of the arguments at which a function of one is hard."""
    kind = chance.randrange(4)
    if name in ("sin", "cos", "tan"):
        choices = (
            chance.uniform(-10, 10), scattered(chance, -30, 22),
            near_a_multiple_of_half_pi(chance), scattered(chance, 20, 1023),
        )  # fmt: skip
        return choices[kind]
    if name in ("asin", "acos", "atanh"):
        near_one = chance.choice([1, -1]) * (1 - abs(scattered(chance, -52, -2)))
        return (chance.uniform(-1, 1), scattered(chance, -30, -1), near_one, near_one)[kind]
    if name == "log":
        near_one = 1 + scattered(chance, -50, -2)
        return (abs(scattered(chance, -1073, 1023)), chance.uniform(0.3, 3), near_one, near_one)[
            kind
        ]
    large = 709.7 if name == "exp" else 60.0 if name == "atan" else 710.4
    return (
        chance.uniform(-large, large), scattered(chance, -40, 8), chance.uniform(-2, 2),
        scattered(chance, -5, 5),
    )[kind]  # fmt: skip


def arguments(chance: random.Random, name: str) -> tuple[float, ...]:
    """Arguments of a function whose value is a finite double."""
    if name in ONE:
        return (argument(chance, name),)
    if name in ("atan2", "hypot"):
        middle = chance.randint(-1000, 950)
        low, high = chance.choice([(-3, 3), (middle, middle + 70), (-1000, 1000)])
        return scattered(chance, low, high), scattered(chance, low, high)
    y = scattered(chance, -10, 53)  # and x such that the power is a double
    largest = min(700.0 / abs(y), 700.0)
    x = math.exp(chance.uniform(-largest, largest))
    return (x, y) if x != 1.0 else (2.0, 0.5)


def error_in_ulp(exact: mpmath.mpf, found: float) -> float:
    """Distance in units of the last place that the exact value has."""
    exponent = max(int(mpmath.floor(mpmath.log(abs(exact), 2))) - 52, -1074) if exact else -1074
    return float(abs(mpmath.mpf(found) - exact) / mpmath.mpf(2) ** exponent)


def largest_error(name: str, count: int, seed: int = 0) -> tuple[float, tuple[float, ...]]:
    """Return the largest error [ulp] over so many random arguments, and where it is."""
    chance, function, worst = random.Random(f"ulp {name} {seed}"), core(name), (-1.0, ())
    exact = getattr(mpmath, "power" if name == "pow" else name)
    with mpmath.workprec(1300 if name in ("sin", "cos", "tan") else 200):
        for _ in range(count):
            values = arguments(chance, name)
            found = function(*values)
            worst = max(worst, (error_in_ulp(exact(*map(mpmath.mpf, values)), found), values))
    return worst


def main(count: int) -> None:
    """Print the largest error of each function."""
    with ProcessPoolExecutor() as pool:
        found = pool.map(largest_error, (*ONE, *TWO), [count] * len((*ONE, *TWO)))
        for name, (error, values) in zip((*ONE, *TWO), found, strict=True):
            print(f"{name:6} {error:.3f} ulp at {', '.join(map(float.hex, values))}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]))
