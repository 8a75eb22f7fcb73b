"""Whether velocities follow the constraints: they do not after a driver that jumps."""

from __future__ import annotations

from collections.abc import Mapping

RESIDUAL = "constraint.velocity"
LARGEST_SHARE = 0.1
"""Of the fastest motion; all scenes stay below 0.006, after a jump it is 1 and more."""
SMALLEST = 1e-9
"""Coordinate in m that tells a size."""
ROUND_OFF = 1e-6
"""Residual in 1/s below which nothing is said: what stands still moves by round-off."""


def largest_allowed(by_unit: Mapping[str, float]) -> float:
    """Return what the residual of the velocities may be [1/s].

    `by_unit` has the largest sizes of outputs of the run, by unit. A speed counts by the largest
    coordinate, where one is not round-off.
    """
    size = by_unit.get("m", 0.0)
    speed = by_unit.get("m/s", 0.0) / size if size > SMALLEST else 0.0
    fastest = max(by_unit.get("rad/s", 0.0), speed)
    return LARGEST_SHARE * fastest + ROUND_OFF


def objection(largest: float, by_unit: Mapping[str, float]) -> str:
    """Return a sentence about the largest residual of a run [1/s]; empty if there is none."""
    limit = largest_allowed(by_unit)
    if not largest > limit:
        return ""
    return (
        f"velocities do not follow the constraints: {RESIDUAL} reaches {largest:.2g} 1/s, and "
        f"{limit:.2g} would be a tenth of the fastest motion; look for a driver or a constraint "
        "whose value or rate jumps, and let it go smoothly"
    )
