"""Tables of the core's elementary functions, from their definitions in decimal arithmetic."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal, getcontext, localcontext
from functools import cache
from math import frexp

DIGITS, MANY_DIGITS = 60, 420
"""Of the arithmetic; of 2/pi, of which the largest double needs 40 words of 32 bits."""
TWO = Decimal(2)


def text(x: Decimal) -> str:
    """C's notation of the nearest double."""
    return float(x).hex().replace("0x1.0000000000000p", "0x1p").replace("0x0.0p+0", "0.0")


def rounded(x: Decimal, bits: int) -> Decimal:
    """Nearest multiple of 2^-bits."""
    return (x * TWO**bits).to_integral_value() / TWO**bits


def pair(x: Decimal, head: Decimal | None = None) -> str:
    """Two numbers whose sum is x, of which the first is the nearest double or `head`."""
    first = Decimal(float(x)) if head is None else head
    return f"{{{text(first)}, {text(x - first)}}}"


def parts(x: Decimal, bits: int, count: int) -> list[str]:
    """`count` numbers whose sum is x, of so many leading bits each but the last."""
    found = []
    for _ in range(count - 1):
        unit = TWO ** (frexp(x)[1] - bits)
        found.append(x // unit * unit)
        x -= found[-1]
    return [text(part) for part in (*found, x)]


def reciprocal(j: int) -> Decimal:
    """1/c of nine bits after the point, c in the middle of the class j of mantissas."""
    if j in (79, 80):  # on either side of 1, so that logarithms near 0 keep their digits
        return Decimal(1)
    low, width = (Decimal(176 + j) / 256, 256) if j < 80 else (Decimal(48 + j) / 128, 128)
    return rounded(1 / (low + Decimal(1) / (2 * width)), 9)


def arctangent(x: Decimal) -> Decimal:
    """atan(x) = 16 atan(y) for 0 <= x <= 1, with y from four half angles, by its series."""
    for _ in range(4):
        x = x / (1 + (1 + x * x).sqrt())
    terms = ((-1) ** k * x ** (2 * k + 1) / (2 * k + 1) for k in range(getcontext().prec // 2))
    return 16 * sum(terms, Decimal(0))


def array(kind: str, name: str, comment: str, items: list[str], per_line: int) -> str:
    """C's definition of a table."""
    lines = [", ".join(items[i : i + per_line]) for i in range(0, len(items), per_line)]
    body = ",\n    ".join(lines)
    return f"/* {comment} */\nstatic const {kind} {name}[{len(items)}] = {{\n    {body}\n}};\n"


def exponential() -> Iterator[str]:
    """Tables of exponential.c."""
    roots = [pair(TWO ** (Decimal(j) / 64)) for j in range(64)]
    yield array("pair", "ROOTS_OF_TWO", "2^(j/64)", roots, 2)
    inverse, ln2 = [reciprocal(j) for j in range(128)], TWO.ln()
    comment = "1/c for the class j of mantissas from 0.6875 on"
    yield array("double", "RECIPROCALS", comment, [text(x) for x in inverse], 8)
    logs = [pair(-x.ln(), rounded(-x.ln(), 42)) for x in inverse]
    yield array("pair", "LOGARITHMS", "log c, its first part a multiple of 2^-42", logs, 2)
    comment = "the first part a multiple of 2^-42"
    yield array("pair", "LN2", comment, [pair(ln2, rounded(ln2, 42))], 1)
    yield array("double", "LN2_OVER_64", "the first part of 32 bits", parts(ln2 / 64, 32, 2), 2)


def trigonometric() -> Iterator[str]:
    """Tables of trigonometric.c."""
    angles = [arctangent(Decimal(j) / 32) for j in range(33)]
    half, pi = 2 * angles[32], 4 * angles[32]
    yield array("pair", "ANGLES", "atan(j/32)", [pair(x) for x in angles], 2)
    comment = "three parts of 33 bits, and the rest"
    yield array("double", "HALF_PI", comment, parts(half, 33, 4), 4)
    yield array("pair", "PI", "pi/2 and pi", [pair(half), pair(pi)], 2)
    with localcontext() as context:
        context.prec = MANY_DIGITS
        bits = int(1 / (2 * arctangent(Decimal(1))) * TWO**1280)
    words = [f"0x{bits >> 32 * k & 0xFFFFFFFF:08x}" for k in reversed(range(40))]
    yield array("uint32_t", "TWO_OVER_PI", "bits of 2/pi", words, 8)


@cache
def tables() -> dict[str, tuple[str, ...]]:
    """Return the tables of each header by its name."""
    with localcontext() as context:
        context.prec = DIGITS
        return {f"{x.__name__}_tables": tuple(x()) for x in (exponential, trigonometric)}
