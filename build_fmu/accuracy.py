"""How far two runs of one mechanism are apart, and what that tells of the error of the coarser one.

Energy and constraints hold at any step; the path has an error, which a second run with half the
step or a tenth of the tolerance shows. With equal steps of order p the error is the difference d
from half the step times 2^p/(2^p - 1) (Richardson). With a tolerance it is d. Where the motion
multiplies small errors d shows from what time on the path is lost.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from build_fmu.motion import LOSSES, OF_THE_SOLUTION, quaternions_among, rotation_between
from build_fmu.reference import ROUND_OFF
from solver.options import USUAL_TOLERANCE

if TYPE_CHECKING:
    from numpy.typing import NDArray

KINDS = {
    "m": "places",
    "rad": "angles",
    "m/s": "velocities",
    "rad/s": "angular velocities",
    "N": "forces",
    "N.m": "torques",
    "J": "works and losses",
}
"""What is compared, by unit."""
PATH = ("m", "rad")
STATE = (*PATH, "m/s", "rad/s")
"""What a tolerance is for."""
NO_PATH = ("m/s", "rad/s", "N", "N.m")
WORKS = ("energy.work", "energy.dissipated")
"""Outputs in J that are compared, where not 0: `energy.error` shows no error of what is booked."""
NO_PATH_TIMES = 10.0
"""Times the error of a path that one of velocities and forces may be: it has a larger constant."""
SHORTER = 0.95
"""Rounding to two digits makes a step at most 5 % longer."""
TOO_LONG = "are too long for this motion"
"""Of equal steps; the FMU's log, which cannot measure the error, says the same of its estimate."""
MOST_TIMES = 10.0
"""Times the tolerance, or USUAL_TOLERANCE, that an error may be without a warning."""
LOST = 0.1
"""Difference of paths over the size, or in rad, beyond which it no longer grows freely."""
SEEN = 1e-3
"""Part of a difference with which its growth begins."""
FEWEST = 16
"""Communication steps that tell how it grows: in a few of them a motion may have just begun."""
GROWTH = 12.0
"""Times by which a difference grows in the second half of a time only where the motion multiplies
it. Errors that add up grow with at most the fourth power of time, from rest, and by a factor of 8.3
from SEEN on; those of all scenes that are not chaotic by less than 10."""


@dataclass(frozen=True)
class Difference:
    """The largest difference of one kind of outputs.

    Attributes
    ----------
    unit, name : str
        Of the output that has it.
    amount, time : float
        Its size in the unit, and when it is so large [s].
    scale : float
        What it is compared with, in the unit: the largest extent, speed, force or energy; of
        angles 1 rad.
    """

    unit: str
    name: str
    amount: float
    time: float
    scale: float

    @property
    def relative(self) -> float:
        """Over the scale; 0 where nothing is to be compared with."""
        return self.amount / self.scale if self.scale > 0.0 else 0.0

    def told(self, factor: float = 1.0) -> str:
        """Return the kind, and how far it is apart, times a factor, in words."""
        if self.unit == "rad":
            size = f"{factor * self.amount:.2g} rad"
        else:
            size = f"{100.0 * factor * self.relative:.2g} % of {self.scale:.3g} {self.unit}"
        return f"{KINDS[self.unit]} by about {size} ({self.name!r} at t = {self.time:.4g} s)"


class Comparison:
    """Two runs at the same times: what is apart, by kind, and how that grows.

    Parameters
    ----------
    times : array of shape (points,)
        Of both [s].
    a, b : mapping of str to array of shape (points,)
        Their outputs, by name.
    units : mapping of str to str or None
        Units of the outputs, by name.
    size : float
        Of the mechanism [m]; places are compared with the box of all of them, if that is larger.
    """

    def __init__(
        self, times: NDArray[np.float64], a: Mapping[str, NDArray[np.float64]],
        b: Mapping[str, NDArray[np.float64]], units: Mapping[str, str | None], size: float,
    ) -> None:  # fmt: skip
        kept = {name: unit for name, unit in units.items() if not name.startswith(OF_THE_SOLUTION)}
        names = {unit: [n for n in kept if kept[n] == unit] for unit in KINDS} | {
            "J": [name for name in WORKS if name in kept and a[name].any()]
        }
        columns = {unit: [a[n] for n in names[unit]] for unit in KINDS}
        columns["J"] += [a[name] for name in kept if name == "energy.kinetic"]
        scales = _scales(columns, names["m"], size)
        self.size = scales["m"]
        self.has_contacts = not kept.keys().isdisjoint(LOSSES)
        """With contacts or friction velocities and forces jump: a late jump is off by all of it."""
        self.differences: dict[str, Difference] = {}
        self._times, self._course = times, np.zeros(len(times))
        for unit in KINDS:
            apart = {name: abs(a[name] - b[name]) for name in names[unit]}
            if unit == "rad":
                apart = {name: _within_a_turn(name, x) for name, x in apart.items()}
                for four in quaternions_among(kept):
                    p, q = (np.stack([run[name] for name in four], axis=1) for run in (a, b))
                    apart[four[0].removesuffix(".qw")] = rotation_between(p, q)
            if not apart:
                continue
            table = np.array([*apart.values()])
            row, column = divmod(int(table.argmax()), len(times))
            amount, time = float(table[row, column]), float(times[column])
            self.differences[unit] = Difference(unit, [*apart][row], amount, time, scales[unit])
            if unit in PATH:
                self._course = np.maximum(self._course, table.max(axis=0) / scales[unit])

    @property
    def path(self) -> float:
        """Largest difference of the path: of a place over the size, or of an angle in rad."""
        return float(self._course.max())

    @property
    def is_none(self) -> bool:
        """Whether both runs are the same to the last bit."""
        return not any(found.amount for found in self.differences.values())

    @property
    def growth(self) -> tuple[float, float]:
        """How the path's grew in the second half of the time in which it grew freely.

        By how many times, and how long one power of ten took at that rate [s].
        """
        level = min(self.path, LOST)
        begin = max(int((self._course >= SEEN * level).argmax()) - 1, 0)
        end = int((self._course >= level).argmax())
        half = 0.5 * (self._times[begin] + self._times[end])
        before = float(self._course[self._times <= half].max())
        if end - begin < FEWEST or not 0.0 < before < level:
            return 0.0, math.inf
        return level / before, float(self._times[end] - half) / math.log10(level / before)

    def beyond(self, units: Sequence[str], limit: float) -> list[Difference]:
        """Differences of these kinds that are larger than a limit, relative or in rad."""
        found = (self.differences[unit] for unit in units if unit in self.differences)
        return [each for each in found if each.relative > limit]

    def first_beyond(self, limit: float) -> float:
        """Time at which the paths are first further apart, over the size or in rad [s]."""
        return float(self._times[int((self._course > limit).argmax())])


@dataclass(frozen=True)
class Verdict:
    """What a comparison says of the coarser run.

    Attributes
    ----------
    error : float
        Estimated error of the path: of places over the size, or of angles in rad.
    sentence : str
        For the user.
    is_warning : bool
        Whether the error is more than MOST_TIMES what was asked for, or USUAL_TOLERANCE.
    """

    error: float
    sentence: str
    is_warning: bool


_SAME = Verdict(0.0, "both runs are the same, which does not show how exact they are", False)


def of_equal_steps(seen: Comparison, order: float, step: float, remedy: str = "") -> Verdict:
    """Judge a run with equal steps [s] by one with half of the step; `remedy` comes first."""
    if seen.is_none:
        return _SAME
    factor = 2.0**order / (2.0**order - 1.0)
    error, limit = factor * seen.path, MOST_TIMES * USUAL_TOLERANCE
    if seen.path > LOST and seen.growth[0] >= GROWTH:
        return Verdict(error, _of_chaos(seen, limit), is_warning=True)
    beyond = seen.beyond(PATH, limit / factor)
    if not seen.has_contacts:
        beyond += seen.beyond(NO_PATH, NO_PATH_TIMES * limit / factor)
    if not beyond:
        return Verdict(
            error, f"its path is off by about {_in_words(error, seen)}", is_warning=False
        )
    worst = max(each.relative for each in beyond if error <= limit or each.unit in PATH)
    shorter = SHORTER * step * (USUAL_TOLERANCE / (factor * worst)) ** (1.0 / order)
    told = ", ".join(each.told(factor) for each in beyond)
    sentence = (
        f"steps of {step:.3g} s {TOO_LONG}: it is off in {told}; {remedy}"
        f"set solver.step_size <= {shorter:.2g} s, for an error of {USUAL_TOLERANCE:g}"
    )
    return Verdict(error, sentence, is_warning=True)


def of_a_tolerance(seen: Comparison, tolerance: float) -> Verdict:
    """Judge a run with a tolerance, relative to the size, by one with a tenth of it, or less."""
    if seen.is_none:
        return _SAME
    limit = max(MOST_TIMES * tolerance, ROUND_OFF)
    if seen.path > limit and seen.growth[0] >= GROWTH:
        return Verdict(seen.path, _of_chaos(seen, limit), is_warning=True)
    beyond = seen.beyond(PATH if seen.has_contacts else STATE, limit)
    if not beyond:
        sentence = f"its path is off by about {_in_words(seen.path, seen)}"
        return Verdict(seen.path, sentence, is_warning=False)
    told = ", ".join(each.told() for each in beyond)
    sentence = (
        f"the run misses its tolerance of {tolerance:g} more than {MOST_TIMES:g} times: it is off "
        f"in {told}; remedy: a smaller solver.tolerance"
    )
    return Verdict(seen.path, sentence, is_warning=True)


def _in_words(error: float, seen: Comparison) -> str:
    """Error of a path, and what it is compared with."""
    scales = {"m": f"of {seen.size:.3g} m", "rad": "rad"}
    return f"{error:.1e} {' or '.join(scales[unit] for unit in PATH if unit in seen.differences)}"


def _of_chaos(seen: Comparison, limit: float) -> str:
    """Sentence on a motion that multiplies small errors; its path may be off by `limit`."""
    worst = max(seen.beyond(PATH, limit), key=lambda each: each.relative)
    return (
        "this motion multiplies small errors, as chaos and impacts do: the two runs agree to "
        f"{_in_words(limit, seen)} until t = {seen.first_beyond(limit):.4g} s, and are then apart "
        f"in {worst.told()}; a tenth of the error moves this time by some {seen.growth[1]:.1g} s, "
        "and what comes later is one of many motions that are as likely"
    )


def _scales(
    columns: Mapping[str, Sequence[NDArray[np.float64]]], places: Sequence[str], size: float
) -> dict[str, float]:
    """Return what differences are compared with, by unit.

    Speeds and angular velocities count for each other, at the size of the mechanism, and so do
    forces and torques: where one of them is round-off the other tells how large that is. Works
    and losses are compared with the largest of them and of the kinetic energy.
    """
    largest = {
        unit: max((float(abs(x).max()) for x in found), default=0.0)
        for unit, found in columns.items()
    }
    sides = [0.0]
    for direction in (".x", ".y", ".z"):
        rows = [x for n, x in zip(places, columns["m"], strict=True) if n.endswith(direction)]
        sides += [float(np.ptp(rows))] if rows else []
    extent = max(size, math.hypot(*sides)) or 1.0
    scales = {"m": extent, "rad": 1.0, "J": largest["J"]}
    arm_of_parts = size or extent  # the way of a wheel is no arm
    for straight, turning, arm in (
        ("m/s", "rad/s", arm_of_parts),
        ("N", "N.m", 1.0 / arm_of_parts),
    ):
        scales[straight] = max(largest[straight], largest[turning] * arm)
        scales[turning] = scales[straight] / arm
    return scales


def _within_a_turn(name: str, difference: NDArray[np.float64]) -> NDArray[np.float64]:
    """Angles of parts and joints count turns; those of formulas may jump by one, as atan2."""
    if name.endswith(".angle"):
        return difference
    return abs(difference - 2.0 * np.pi * np.round(difference / (2.0 * np.pi)))
