"""A small canvas with smooth lines, the symbols of a mechanism, and the PNG file that it becomes.

A line is drawn by its distance from each pixel, so that edges are smooth without a library for
graphics; equal shapes give equal bytes. Pillow draws no smooth lines, takes three times as long to
import, draw and compress, and its files are twice as large.
"""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Colour = tuple[float, float, float]
Pixel = tuple[float, float]

PAPER: Colour = (1.0, 1.0, 1.0)
DARK: Colour = (0.13, 0.15, 0.18)
HATCHING: Colour = (0.72, 0.74, 0.77)
SHADES = 3
"""Of an edge, from outside to inside: enough for the eye, and few colours in all."""
MOST_COLOURS = 256
"""Of a PNG file with one byte a pixel, which is a third as large as one with three."""
WEIGHTS = np.array([1 << 16, 1 << 8, 1], np.uint32)
"""Of red, green and blue in the number of a colour."""
COARSE = np.array([*np.ndindex(4, 4, 4)], np.uint32) * 85 @ WEIGHTS
"""Colours of which each colour has one near it."""
SEAM = 0.5
"""Pixels by which a face is larger than it is, so that neighbours leave none between them."""
RAIL = 24.0
"""Half the length of a rail."""


def parts(colours: NDArray[np.uint32]) -> NDArray[np.uint8]:
    """Red, green and blue of numbers of colours."""
    return colours.astype(">u4").view(np.uint8).reshape(-1, 4)[:, 1:]


def _middles(window: tuple[slice, ...]) -> tuple[Array, Array]:
    """Middles of the pixels of a window: y (rows, 1) and x (1, columns)."""
    rows, columns = (np.arange(span.start, span.stop) + 0.5 for span in window)
    return rows[:, None], columns[None]


class Canvas:
    """Pixels, x to the right and y downwards from the upper left corner."""

    def __init__(self, width: int, height: int) -> None:
        self._pixels: Array = np.ones((height, width, 3)) * PAPER

    def path(self, *pixels: Pixel, width: float, colour: Colour) -> None:
        """Draw lines with round ends from each pixel to the next."""
        for a, b in pairwise(pixels):
            self._line(a, b, width, colour)

    def _window(self, pixels: Sequence[Pixel], reach: float) -> tuple[slice, ...]:
        """Rows and columns that a shape can touch; none where it lies beside the canvas."""
        window = []
        for k, end in ((1, self._pixels.shape[0]), (0, self._pixels.shape[1])):
            first = max(0, int(min(p[k] for p in pixels) - reach - 1.0))
            window.append(slice(first, min(end, int(max(p[k] for p in pixels) + reach + 2.0))))
        return tuple(window) if all(span.start < span.stop for span in window) else ()

    def _ink(self, window: tuple[slice, ...], gap: Array, colour: Colour, opacity: float) -> None:
        """Colour what lies nearer than nothing to a shape."""
        near = np.minimum(np.maximum(0.5 - gap, 0.0), 1.0)
        cover = np.rint(SHADES * near)[:, :, None] / SHADES * opacity
        part = self._pixels[window]
        part += cover * (np.array(colour) - part)

    def face(
        self, *pixels: Pixel, colour: Colour, opacity: float = 1.0, outline: Colour | None = None
    ) -> None:
        """Fill a polygon, and draw lines around it."""
        window = self._window(pixels, 1.0)
        if window:
            y, x = _middles(window)
            inside, gap = np.zeros((len(y), x.size), bool), np.full((len(y), x.size), np.inf)
            for a, b in zip(pixels, (*pixels[1:], pixels[0]), strict=True):
                ux, uy = b[0] - a[0], b[1] - a[1]
                square = ux * ux + uy * uy
                if square == 0.0:
                    continue
                along = np.clip(((x - a[0]) * ux + (y - a[1]) * uy) / square, 0.0, 1.0)
                gap = np.minimum(gap, np.hypot(x - a[0] - along * ux, y - a[1] - along * uy))
                if uy:  # a ray to the left crosses the edge
                    crossed = (a[1] > y) != (b[1] > y)
                    inside ^= crossed & (x > a[0] + (y - a[1]) / uy * ux)
            seam = SEAM if opacity == 1.0 else 0.0
            self._ink(window, np.where(inside, -gap, gap) - seam, colour, opacity)
        if outline is not None:
            self.path(*pixels, pixels[0], width=1.0, colour=outline)

    def _line(self, a: Pixel, b: Pixel, width: float, colour: Colour, opacity: float = 1.0) -> None:
        window = self._window((a, b), 0.5 * width)
        if not window:
            return
        y, x = _middles(window)
        ux, uy = b[0] - a[0], b[1] - a[1]
        square = ux * ux + uy * uy
        along = 0.0
        if square > 0.0:
            along = ((x - a[0]) * ux + (y - a[1]) * uy) / square
            along = np.minimum(np.maximum(along, 0.0), 1.0)
        gap = np.hypot(x - a[0] - along * ux, y - a[1] - along * uy) - 0.5 * width
        self._ink(window, gap, colour, opacity)

    def disc(self, centre: Pixel, *, radius: float, colour: Colour, opacity: float = 1.0) -> None:
        """Draw a filled circle."""
        self._line(centre, centre, 2.0 * radius, colour, opacity)

    def ring(self, centre: Pixel, *, radius: float, width: float, colour: Colour) -> None:
        """Draw a circle."""
        x, y = centre
        turns = [2.0 * math.pi * k / 48 for k in range(49)]
        rim = [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns]
        self.path(*rim, width=width, colour=colour)

    def coil(self, a: Pixel, b: Pixel, *, width: float, colour: Colour) -> None:
        """Draw a spring: a zigzag."""
        ux, uy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(ux, uy)
        sides = [(0.15 + 0.05 * (k + 0.5), 5.0 if k % 2 else -5.0) for k in range(14)]
        knots = [(0.15, 0.0), *sides, (0.85, 0.0)] if length >= 1.0 else []
        bends = [
            (a[0] + s * ux - w * uy / length, a[1] + s * uy + w * ux / length) for s, w in knots
        ]
        self.path(a, *bends, b, width=width, colour=colour)

    def joint(self, p: Pixel, *, ground: bool, direction: Pixel | None, turns: bool) -> None:
        """Draw a joint: hatched on the ground, on a rail if it slides along a direction [1]."""
        x, y = p
        if ground:
            base = y + 12.0
            self.path(p, (x - 8.0, base), (x + 8.0, base), p, width=1.6, colour=DARK)
            self.path((x - 13.0, base), (x + 13.0, base), width=1.6, colour=DARK)
            for left in (x - 12.0 + 5.6 * k for k in range(5)):
                ends = (left, base + 0.5), (left - 4.0, base + 5.5)
                self.path(*ends, width=1.2, colour=HATCHING)
        u, w = direction or (0.0, 0.0)
        for side in (-6.0, 6.0) if direction else ():
            ends = [(x + s * u - side * w, y + s * w + side * u) for s in (-RAIL, RAIL)]
            self.path(*ends, width=1.8, colour=DARK)
        if turns or direction is None:
            self.disc(p, radius=4.5, colour=DARK)
            self.disc(p, radius=2.6, colour=PAPER)
            return
        for half, width, colour in ((8.0, 8.0, DARK), (7.0, 5.0, PAPER)):
            ends = (x - half * u, y - half * w), (x + half * u, y + half * w)
            self.path(*ends, width=width, colour=colour)

    def rgb(self) -> NDArray[np.uint8]:
        """Red, green and blue of all pixels."""
        return np.rint(self._pixels * 255).astype(np.uint8)

    def png(self) -> bytes:
        """PNG file of a palette; of too many colours, rare ones are rounded to others."""
        # One number for each colour, and the few that are not the background sorted.
        colours = self.rgb().astype(np.uint32) @ WEIGHTS
        drawn = np.append(colours[colours != colours[0, 0]], colours[0, 0])
        found, counts = np.unique(drawn, return_counts=True)
        palette, place = found, np.arange(len(found))
        if len(found) > MOST_COLOURS:
            often = found[np.argsort(-counts, kind="stable")[: MOST_COLOURS - len(COARSE)]]
            palette = np.concatenate([often, COARSE])
            gaps = parts(found)[:, None].astype(np.int16) - parts(palette)
            place = np.argmin(abs(gaps).max(axis=2), axis=1)
        # Each row begins with its filter; 0 is none.
        rows = np.pad(place.astype(np.uint8)[np.searchsorted(found, colours)], ((0, 0), (1, 0)))
        blocks = {
            b"IHDR": struct.pack(">IIBBBBB", *colours.T.shape, 8, 3, 0, 0, 0),
            b"PLTE": parts(palette).tobytes(),
            b"IDAT": zlib.compress(rows.tobytes(), 9),
            b"IEND": b"",
        }
        return b"\x89PNG\r\n\x1a\n" + b"".join(
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
            for kind, data in blocks.items()
        )
