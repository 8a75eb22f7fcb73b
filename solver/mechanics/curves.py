"""Curves that follow from a profile: the path of a wheel's centre, and how far a cam reaches.

    road    x_c = x - R p'/s,  y_c = p + R/s,                s = sqrt(1 + p'^2)
    cam     C = P + R n,       P = r (cos phi, sin phi),     n = (r e_r - r' e_phi)/sqrt(r^2 + r'^2)
    flat    psi = phi - atan(r'/r),                          h = r^2/sqrt(r^2 + r'^2)

with h(psi) the support function: the distance from the axis of a tangent whose normal has the angle
psi. Each is a spline through points of the exact curve, among them those at the profile's knots,
between which it is smooth; the pieces are halved until the spline fits. Where the curvature of the
profile jumps, the pieces have the exact slopes instead: of a path that of the profile, of a centre
at r_c e_r that of the tangent, and h' = P . e_psi.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import atan2, hypot

from solver.mechanics.rows import Rows
from solver.scene import Profile
from solver.scene.expression import Curve, apply
from solver.scene.profiles import table_of

FITS = 1e-9
"""Distance from the exact curve at which pieces are no longer halved, relative to its size."""
MOST_HALVINGS = 7
"""Of the pieces between knots; a curve that does not fit by then is taken as it is."""
ROUNDING = 1e-15
"""Height, relative to the largest, that is left of a matrix by rounding alone."""
Place = tuple[float, float, float]
"""Of a curve: argument, value and slope."""


def centres_above(rows: Rows, profile: Profile, radius: float) -> Curve:
    """Return the heights of the centre of a wheel that rolls on a profile y(x)."""

    def place(x: float) -> Place:
        y, slope = _value_and_slope(profile, x)
        s = hypot(1.0, slope)
        return x - radius * slope / s, y + radius / s, slope

    text = "the wheel is larger than the hollow of '{}' at x = {:.6g} m, where it touches twice"
    return _traced(rows, profile, place, text, ".radius") if radius > 0.0 else profile.curve


def centres_around(rows: Rows, profile: Profile, radius: float) -> Curve:
    """Return the distances of the centre of a roller that rolls on a cam r(phi)."""

    def place(phi: float) -> Place:
        r, slope = _value_and_slope(profile, phi)
        q = hypot(r, slope)
        out, across = r + radius * r / q, -radius * slope / q
        distance = hypot(out, across)
        tangent = slope * out + r * across, r * out - slope * across
        return phi + atan2(across, out), distance, distance * tangent[0] / tangent[1]

    text = "the roller is larger than the hollow of '{}' at {:.6g} rad, where it touches twice"
    return _traced(rows, profile, place, text, ".radius") if radius > 0.0 else profile.curve


def support_function(rows: Rows, profile: Profile) -> Curve:
    """Return the support function h(psi) of a cam r(phi)."""

    def place(phi: float) -> Place:
        r, slope = _value_and_slope(profile, phi)
        q = hypot(r, slope)
        return phi - atan2(slope, r), r * r / q, r * slope / q

    text = "the cam '{}' is hollow at {:.6g} rad, where a flat face touches it twice"
    return _traced(rows, profile, place, text, ".face")


def separated(
    heights: Sequence[Sequence[float]],
) -> Iterator[tuple[list[float], list[float]]]:
    """Yield columns u and rows v whose products add up to a matrix, by its largest pivots.

    A spline is linear in its values: that through the matrix is the sum of U(x) V(y).
    """
    rest = [list(row) for row in heights]
    size = max(abs(z) for row in rest for z in row)
    for _ in range(min(len(rest), len(rest[0]))):
        pivot, i, k = max(
            (abs(z), i, k) for i, row in enumerate(rest) for k, z in enumerate(row)
        )  # fmt: skip
        if pivot <= ROUNDING * size:
            return
        u, v = [row[k] for row in rest], [z / rest[i][k] for z in rest[i]]
        rest = [
            [z - a * b for z, b in zip(row, v, strict=True)] for row, a in zip(rest, u, strict=True)
        ]
        yield u, v


def _value_and_slope(profile: Profile, x: float) -> tuple[float, float]:
    return apply("spline", x, profile.curve), apply("spline_slope", x, profile.curve)


def _traced(
    rows: Rows, profile: Profile, place: Callable[[float], Place], text: str, field: str
) -> Curve:  # fmt: skip
    """Return the spline through places of a curve; one that turns back is reported by `text`."""
    knots = list(profile.x)
    name = profile.curve.name
    size = max(abs(y) for _, y, _ in map(place, knots)) + knots[-1] - knots[0]
    curve = profile.curve
    for _ in range(MOST_HALVINGS):
        places = [place(x) for x in knots]
        for (before, *_), (after, *_), x in zip(places, places[1:], knots[1:], strict=False):
            if not after - before > 0.0:
                rows.problem(text.format(name, x), field)
                return profile.curve
        xs, ys, slopes = ([*column] for column in zip(*places, strict=True))
        if profile.periodic:  # up to rounding it is
            xs[-1], ys[-1], slopes[-1] = xs[0] + knots[-1] - knots[0], ys[0], slopes[0]
        known = () if profile.interpolation == "cubic" else slopes
        curve = Curve(name, table_of(xs, ys, slopes=known, periodic=profile.periodic))
        middles = list(_middles(knots))
        error = max(abs(apply("spline", x, curve) - y) for x, y, _ in map(place, middles))
        if error <= FITS * size:
            break
        knots = sorted([*knots, *middles])
    return curve


def _middles(knots: list[float]) -> Iterator[float]:
    for left, right in pairwise(knots):
        yield 0.5 * (left + right)
