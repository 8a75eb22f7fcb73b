"""Write the tables of the core's elementary functions from their definitions; needs mpmath.

python -m build_kernel.elementary_tables
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from mpmath import asin, atan, chebyfit, floor, log, mp, mpf, nint, pi, sqrt

KERNEL = Path(__file__).parent.parent / "solver" / "kernel"
WORDS = 40
"""Of 32 bits of 2/pi: those that the largest double needs."""


def text(x: Any) -> str:
    """C's notation of the nearest double."""
    return float(x).hex().replace("0x1.0000000000000p", "0x1p").replace("0x0.0p+0", "0.0")


def rounded(x: Any, bits: int) -> Any:
    """Nearest multiple of 2^-bits."""
    return nint(x * mpf(2) ** bits) / mpf(2) ** bits


def pair(x: Any, head: Any = None) -> str:
    """Two numbers whose sum is x, of which the first is the nearest double or `head`."""
    first = float(x) if head is None else head
    return f"{{{text(first)}, {text(x - first)}}}"


def parts(x: Any, bits: int, count: int) -> list[str]:
    """`count` numbers whose sum is x, of so many leading bits each but the last."""
    found = []
    for _ in range(count - 1):
        unit = mpf(2) ** (int(floor(log(x, 2))) + 1 - bits)
        found.append(floor(x / unit) * unit)
        x -= found[-1]
    return [text(part) for part in (*found, x)]


def reciprocal(j: int) -> Any:
    """1/c of nine bits after the point, c in the middle of the class j of mantissas."""
    if j in (79, 80):  # on either side of 1, so that logarithms near 0 keep their digits
        return mpf(1)
    low, width = (mpf(176 + j) / 256, 256) if j < 80 else (mpf(48 + j) / 128, 128)
    return rounded(1 / (low + mpf(1) / (2 * width)), 9)


def arcsine(count: int) -> list[str]:
    """Coefficients of (asin s/s - 1)/s^2 in powers of s^2 up to 1/4, near-minimax."""

    def terms(q: Any) -> Any:
        return (asin(sqrt(q)) / sqrt(q) - 1) / q if q else mpf(1) / 6

    return [text(x) for x in chebyfit(terms, [mpf(0), mpf(1) / 4], count, asc=True)]


def array(kind: str, name: str, comment: str, items: list[str], per_line: int) -> str:
    """C's definition of a table."""
    lines = [", ".join(items[i : i + per_line]) for i in range(0, len(items), per_line)]
    body = ",\n    ".join(lines)
    return f"/* {comment} */\nstatic const {kind} {name}[{len(items)}] = {{\n    {body}\n}};\n"


def exponential() -> list[str]:
    """Tables of exponential.c."""
    roots = [pair(mpf(2) ** (mpf(j) / 64)) for j in range(64)]
    logs = [-log(reciprocal(j)) for j in range(128)]
    return [
        array("pair", "ROOTS_OF_TWO", "2^(j/64)", roots, 2),
        array(
            *("double", "RECIPROCALS", "1/c for the class j of mantissas from 0.6875 on"),
            *([text(reciprocal(j)) for j in range(128)], 8),
        ),
        array(
            *("pair", "LOGARITHMS", "log c, its first part a multiple of 2^-42"),
            *([pair(x, rounded(x, 42)) for x in logs], 2),
        ),
        array(
            *("pair", "LN2", "the first part a multiple of 2^-42"),
            *([pair(log(2), rounded(log(2), 42))], 1),
        ),
        array(
            *("double", "LN2_OVER_64", "the first part of 32 bits"),
            *(parts(log(2) / 64, 32, 2), 2),
        ),
    ]


def trigonometric() -> list[str]:
    """Tables of trigonometric.c."""
    with mp.workprec(32 * WORDS + 64):
        bits = int(floor(2 / pi * mpf(2) ** (32 * WORDS)))
    words = [f"0x{bits >> 32 * k & 0xFFFFFFFF:08x}" for k in reversed(range(WORDS))]
    return [
        array("pair", "ANGLES", "atan(j/32)", [pair(atan(mpf(j) / 32)) for j in range(33)], 2),
        array(
            *("double", "HALF_PI", "three parts of 33 bits, and the rest"),
            *(parts(pi / 2, 33, 4), 4),
        ),
        array("pair", "PI", "pi/2 and pi", [pair(pi / 2), pair(pi)], 2),
        array(
            *("double", "ARCSINE", "(asin s/s - 1)/s^2 in powers of s^2 up to 1/4"),
            *(arcsine(13), 4),
        ),
        array("uint32_t", "TWO_OVER_PI", "bits of 2/pi", words, 8),
    ]


def headers() -> dict[Path, str]:
    """Return the text of each header."""
    found = {}
    with mp.workprec(300):
        for tables in (exponential, trigonometric):
            name = f"{tables.__name__}_tables"
            guard = f"HOLONOM_{name.upper()}_H"
            first = f"/* Written by build_kernel/elementary_tables.py. */\n#ifndef {guard}\n"
            first += f'#define {guard}\n\n#include "double_double.h"\n'
            found[KERNEL / f"{name}.h"] = "\n".join([first, *tables(), "#endif\n"])
    return found


if __name__ == "__main__":
    for path, content in headers().items():
        path.write_text(content, "utf-8")
