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
SEAM = 0.5
"""Pixels by which a face is larger than it is, so that neighbours leave none between them."""
RAIL = 24.0
"""Half the length of a rail."""


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
        cover = np.rint(SHADES * np.clip(0.5 - gap, 0.0, 1.0))[:, :, None] / SHADES * opacity
        part = self._pixels[window]
        part += cover * (np.array(colour) - part)

    def face(
        self, *pixels: Pixel, colour: Colour, opacity: float = 1.0, outline: Colour | None = None
    ) -> None:
        """Fill a polygon, and draw lines around it."""
        window = self._window(pixels, 1.0)
        if window:
            y, x = np.mgrid[window] + 0.5
            inside, gap = np.zeros(x.shape, bool), np.full(x.shape, np.inf)
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
        y, x = np.mgrid[window] + 0.5
        ux, uy = b[0] - a[0], b[1] - a[1]
        square = ux * ux + uy * uy
        along = np.zeros_like(x)
        if square > 0.0:
            along = np.clip(((x - a[0]) * ux + (y - a[1]) * uy) / square, 0.0, 1.0)
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

    def rgb(self, level: int = 1) -> NDArray[np.uint8]:
        """Red, green and blue of all pixels, in multiples of a level."""
        return np.rint(self._pixels * (255 / level)).astype(np.uint8) * level

    def png(self) -> bytes:
        """PNG file of a palette; a picture of too many colours is rounded to fewer."""
        for level in (1, 5, 17, 51, 85):  # of 255; the last leaves 4 of each of three colours
            # One number for each colour, and the few that are not the background sorted.
            colours = self.rgb(level).astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)
            ground = colours[0, 0]
            palette = np.unique(np.append(colours[colours != ground], ground))
            if len(palette) <= MOST_COLOURS:
                break
        # Each row begins with its filter; 0 is none.
        rows = np.pad(np.searchsorted(palette, colours).astype(np.uint8), ((0, 0), (1, 0)))
        blocks = {
            b"IHDR": struct.pack(">IIBBBBB", *colours.T.shape, 8, 3, 0, 0, 0),
            b"PLTE": palette.astype(">u4").view(np.uint8).reshape(-1, 4)[:, 1:].tobytes(),
            b"IDAT": zlib.compress(rows.tobytes(), 9),
            b"IEND": b"",
        }
        return b"\x89PNG\r\n\x1a\n" + b"".join(
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
            for kind, data in blocks.items()
        )
