"""A small canvas with smooth lines and discs, and the PNG file that it becomes.

Shapes are drawn by their distance from each pixel, so that edges are smooth without a library for
graphics; equal shapes give equal bytes.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Colour = tuple[float, float, float]
Pixel = tuple[float, float]

WHITE: Colour = (1.0, 1.0, 1.0)
SHADES = 8
"""Of an edge, from outside to inside: enough for the eye, and few colours in all."""
MOST_COLOURS = 256
"""Of a PNG file with one byte a pixel, which is a third as large as one with three."""


class Canvas:
    """Pixels, x to the right and y downwards from the upper left corner."""

    def __init__(self, width: int, height: int, colour: Colour = WHITE) -> None:
        self.width, self.height = width, height
        self._pixels: Array = np.ones((height, width, 3)) * np.array(colour)

    def line(self, a: Pixel, b: Pixel, width: float, colour: Colour) -> None:
        """Draw a line with round ends."""
        window = self._window((a, b), 0.5 * width)
        if window is None:
            return
        rows, columns, x, y = window
        ux, uy = b[0] - a[0], b[1] - a[1]
        square = ux * ux + uy * uy
        along = np.zeros_like(x)
        if square > 0.0:
            along = np.clip(((x - a[0]) * ux + (y - a[1]) * uy) / square, 0.0, 1.0)
        gap = np.hypot(x - a[0] - along * ux, y - a[1] - along * uy)
        self._blend(rows, columns, gap - 0.5 * width, colour)

    def disc(self, centre: Pixel, radius: float, colour: Colour) -> None:
        """Draw a filled circle."""
        self.line(centre, centre, 2.0 * radius, colour)

    def ring(self, centre: Pixel, radius: float, width: float, colour: Colour) -> None:
        """Draw a circle."""
        window = self._window((centre,), radius + 0.5 * width)
        if window is None:
            return
        rows, columns, x, y = window
        gap = np.abs(np.hypot(x - centre[0], y - centre[1]) - radius)
        self._blend(rows, columns, gap - 0.5 * width, colour)

    def path(self, pixels: Sequence[Pixel], width: float, colour: Colour) -> None:
        """Draw lines from each pixel to the next."""
        for a, b in pairwise(pixels):
            self.line(a, b, width, colour)

    def _window(
        self, pixels: Sequence[Pixel], margin: float
    ) -> tuple[slice, slice, Array, Array] | None:
        """Rows and columns that a shape can touch, and the middles of their pixels."""
        spans = []
        for k, end in ((0, self.width), (1, self.height)):
            values = [pixel[k] for pixel in pixels]
            first = max(0, int(min(values) - margin - 1.0))
            last = min(end, int(max(values) + margin + 2.0))
            if first >= last:
                return None
            spans.append((first, last))
        (left, right), (top, bottom) = spans
        y, x = np.mgrid[top:bottom, left:right] + 0.5
        return slice(top, bottom), slice(left, right), x, y

    def _blend(self, rows: slice, columns: slice, gap: Array, colour: Colour) -> None:
        """Lay a colour over the pixels; `gap` is their distance from the shape's edge."""
        cover = np.rint(SHADES * np.clip(0.5 - gap, 0.0, 1.0))[:, :, None] / SHADES
        part = self._pixels[rows, columns]
        part += cover * (np.array(colour) - part)

    def png(self) -> bytes:
        """PNG file of a palette; a picture of too many colours is rounded to fewer."""
        for level in (1, 5, 17, 51, 85):  # of 255; the last leaves 4 of each of three colours
            levels = np.rint(self._pixels * (255 / level)).astype(np.uint8) * level
            # One number for each colour, and the few that are not the background sorted.
            colours = levels.astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)
            ground = colours[0, 0]
            palette = np.unique(np.append(colours[colours != ground], ground))
            if len(palette) <= MOST_COLOURS:
                break
        # Each row begins with its filter; 0 is none.
        rows = np.zeros((self.height, 1 + self.width), np.uint8)
        rows[:, 1:] = np.searchsorted(palette, colours)
        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 3, 0, 0, 0)
        blocks = [
            (b"IHDR", header),
            (b"PLTE", palette.astype(">u4").view(np.uint8).reshape(-1, 4)[:, 1:].tobytes()),
            (b"IDAT", zlib.compress(rows.tobytes(), 9)),
            (b"IEND", b""),
        ]
        return b"\x89PNG\r\n\x1a\n" + b"".join(_block(kind, data) for kind, data in blocks)


def _block(kind: bytes, data: bytes) -> bytes:
    checksum = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)
