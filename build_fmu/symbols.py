"""Symbols of a picture, in pixels: coil of a spring, ground, rail of a joint that slides."""

from __future__ import annotations

import math

from build_fmu.canvas import Canvas, Colour, Pixel

DARK: Colour = (0.13, 0.15, 0.18)
PAPER: Colour = (1.0, 1.0, 1.0)
RAIL = 24.0
"""Half the length of a rail."""


def coil(a: Pixel, b: Pixel, turns: int = 7, half: float = 5.0) -> list[Pixel]:
    """Zigzag between two pixels."""
    length = math.hypot(b[0] - a[0], b[1] - a[1])
    if length < 1.0:
        return [a, b]
    along = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
    knots = [(0.0, 0.0), (0.15, 0.0)]
    for k in range(2 * turns):
        knots.append((0.15 + 0.7 * (k + 0.5) / (2 * turns), half if k % 2 else -half))
    knots += [(0.85, 0.0), (1.0, 0.0)]
    return [
        (a[0] + s * length * along[0] - w * along[1], a[1] + s * length * along[1] + w * along[0])
        for s, w in knots
    ]


def pin(canvas: Canvas, p: Pixel) -> None:
    """Draw what turns."""
    canvas.disc(p, 4.5, DARK)
    canvas.disc(p, 2.6, PAPER)


def rail(canvas: Canvas, p: Pixel, direction: Pixel) -> None:
    """Draw two lines through a pixel, along which something slides; `direction` has length 1."""
    (x, y), (u, w) = p, direction
    for side in (-6.0, 6.0):
        ends = [(x + s * u - side * w, y + s * w + side * u) for s in (-RAIL, RAIL)]
        canvas.path(ends, 1.8, DARK)


def block(canvas: Canvas, p: Pixel, direction: Pixel) -> None:
    """Draw what slides and does not turn."""
    (x, y), (u, w) = p, direction
    for half, width, colour in ((8.0, 8.0, DARK), (7.0, 5.0, PAPER)):
        canvas.line((x - half * u, y - half * w), (x + half * u, y + half * w), width, colour)


def hatch(canvas: Canvas, p: Pixel) -> None:
    """Draw the sign of the ground below a pixel."""
    x, y = p
    canvas.path([(x, y), (x - 8.0, y + 12.0), (x + 8.0, y + 12.0), (x, y)], 1.6, DARK)
    canvas.line((x - 13.0, y + 12.0), (x + 13.0, y + 12.0), 1.6, DARK)
    for k in range(5):
        left = x - 12.0 + 5.6 * k
        canvas.line((left, y + 12.5), (left - 4.0, y + 17.5), 1.2, (0.72, 0.74, 0.77))
