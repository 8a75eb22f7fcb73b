"""Letters as strokes: pairs of digits are places x, y on a grid; 2 is the base line, 8 the top."""

from __future__ import annotations

from viewer.canvas import PAPER, Canvas, Colour, Pixel

_STROKES = """
0 123243473818070312|1 172822|2 07183847460242|3 071838474635 1535 354443321203|4 32380444
5 480805354443321203|6 3817050312324344351504|7 084822|8 15060718384746351504031232434435
9 1233454738180706153546|A 022842 1434|B 02083847463505 3544433202|C 4738180703123243
D 02082847432202|E 48080242 0535|F 480802 0535|G 47381807031232434525|H 0208 4248 0545|I 2228
J 4843321203|K 0208 4805 0542|L 080242|M 0208254842|N 02084248|O 123243473818070312
P 02083847463505|Q 123243473818070312 2442|R 02083847463505 2542|S 473818070615354443321203
T 0848 2228|U 080312324348|V 082248|W 0812263248|X 0842 0248|Y 082548 2522|Z 08480242
a 0516364542 441403123243|b 0802 0516364543321203|c 4536160503123243|d 4842 4536160503123243
e 044445361605031232|f 382722 1636|g 46413010 4536160503123243|h 0802 0516364542|i 2622 2828
j 262110 2828|k 0802 460442|l 2822|m 0602 05162522 25364542|n 0602 0516364542
o 123243453616050312|p 0600 0516364543321203|q 4640 4536160503123243|r 0602 04163645
s 4616051434433202|t 18132232 0636|u 0603123243 4642|v 062246|w 0612243246|x 0642 0246
y 0622 4600|z 06460242|_ 0141|. 2222|- 0545
"""
_GLYPHS = {
    name: strokes.split()
    for name, _, strokes in (
        glyph.partition(" ") for line in _STROKES.split("\n") for glyph in line.split("|")
    )
}
UNIT = 1.15
"""Pixels of a step of the grid."""
ADVANCE = 5.6 * UNIT


def write(canvas: Canvas, text: str, corner: Pixel, colour: Colour) -> None:
    """Write a text with its base line from a corner to the right."""
    x, y = corner
    strokes = [
        [
            (x + k * ADVANCE + UNIT * int(stroke[i]), y - UNIT * (int(stroke[i + 1]) - 2))
            for i in range(0, len(stroke), 2)
        ]
        for k, letter in enumerate(text)
        for stroke in _GLYPHS.get(letter, ())
    ]
    for width, ink in ((3.0, PAPER), (1.1, colour)):  # legible on any ground
        for stroke in strokes:
            canvas.path(*stroke, width=width, colour=ink)
