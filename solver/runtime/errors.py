"""What can go wrong once a model exists."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable, Iterable
from enum import IntEnum

from solver.options import removed

LARGEST = sys.float_info.max


class AssemblyError(Exception):
    """The mechanism cannot be assembled with its parameters: one sentence per broken rule."""


def in_one_line(error: BaseException) -> str:
    """Sentences of an error in one line; what to do, behind `;`, is said once for those alike."""
    lines = str(error).splitlines()
    remedies = [line.partition("; ")[2] for line in lines]
    return "; ".join(
        line.removesuffix(f"; {remedy}") if remedy in remedies[i:] else line
        for i, (line, remedy) in enumerate(zip(lines, remedies, strict=True), start=1)
    )


class StepError(Exception):
    """A step could not be solved; the state is as before it.

    `status` is the kernel's, and OK where the step was not even tried. Of `holonom.simulate`,
    `trajectory` is the run before it.
    """

    trajectory: object = None

    def __init__(self, message: str, status: Status | None = None) -> None:
        super().__init__(message)
        self.status = Status.OK if status is None else status


class OptionError(ValueError):
    """A value was set that no rule allows; nothing was changed."""


class UnknownNameError(OptionError, KeyError):
    """There is no variable of this name; `known` are those there are. Says where one has gone."""

    def __init__(self, name: str, known: Iterable[str]) -> None:
        from difflib import get_close_matches  # only where a name is wrong

        gone, near = removed(name), get_close_matches(name, known, 1)
        hint = f": {gone}" if gone else f"; did you mean {near[0]!r}?" if near else ""
        super().__init__(f"no variable is named {name!r}{hint}")

    __str__ = ValueError.__str__  # KeyError's is the message in quotation marks


class Status(IntEnum):
    """Status codes of the kernel, one meaning each."""

    OK = 0
    NEWTON_DIVERGED = 1  # inner Newton iteration did not reach the tolerance
    UZAWA_DIVERGED = 2  # outer Uzawa iteration left the constraints unsatisfied
    SINGULAR_TANGENT = 3  # a pivot of the tangent matrix is zero
    NOT_FINITE = 4  # an increment, a residual or a number of the model is not finite
    ZERO_LENGTH = 5  # a length or a turned link is zero, an angle has no direction
    BAD_STEP = 6  # step length is not a finite positive number
    BAD_LAW = 7  # a stiffness, free length or damping is negative, or work not a number
    TURN_TOO_LARGE = 8  # a body would turn by more than 2.5 rad in a half step
    DAMPING_REVERSED = 9  # a step of order > 2 goes back in between: dampers fed energy
    STEP_COLLAPSED = 10  # a tolerance asks for more than 1e6 internal steps in one, or 40 repeats
    CONTACT_UNDECIDED = 11  # no set of contacts and frictions agrees with the forces
    IMPACT_UNSOLVED = 12  # no impulses obey the law of impact
    TOO_MANY_EVENTS = 13  # contacts change more often in a communication step than they may
    PENETRATION = 15  # a gap is negative at the start
    AT_DEAD_CENTRE = 16  # velocities at the start belong to no motion: rows lack accelerations
    STOPPED = 17  # who waits for the step has asked for its end
    BAD_DRIVER = 18  # the value, rate or second derivative of a signal is not finite
    MESH_EVENTS = 19  # contacts or frictions change in another order than in the recorded run
    MESH_METHODS = 20  # a step cannot be taken as it was in the recorded run
    MESH_STEPPED = 21  # the recorded run has steps whose contacts change without being located
    LAW_SWITCHES = 22  # a law changes sides more often in a communication step than it may
    SIGNAL_JUMPS = 23  # the value of a driver or constraint jumps
    MESH_SWITCHES = 24  # a law changes sides in another order than in the recorded run
    NEXT_STATE = 25  # the next value of a sampled state is not finite


def is_double(value: object) -> bool:
    """Whether a value is a number that a double holds; an integer may be too large."""
    return isinstance(value, float) or (isinstance(value, int) and abs(value) <= LARGEST)


def shown(value: object) -> str:
    """Text that shows a value in a sentence."""
    too_long = isinstance(value, int) and not is_double(value)
    return "an integer of more than 308 digits" if too_long else repr(value)


def tell(log: Callable[[str], None] | None, sentence: str) -> None:
    """Say a sentence in the log, or in a warning if there is none: somebody must hear of it.

    The warning names the line that called this package.
    """
    if log:
        log(sentence)
        return
    package, depth, frame = os.path.dirname(os.path.dirname(__file__)), 2, sys._getframe(1)
    while frame.f_back and frame.f_code.co_filename.startswith(package):
        depth, frame = depth + 1, frame.f_back
    warnings.warn(sentence, RuntimeWarning, stacklevel=depth)
