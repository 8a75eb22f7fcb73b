"""What can go wrong once a model exists, and the sentence for each of the kernel's status codes."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Callable, Iterable
from enum import IntEnum


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

    `status` is the kernel's, and OK where the step was not even tried.
    """

    def __init__(self, message: str, status: Status | None = None) -> None:
        super().__init__(message)
        self.status = Status.OK if status is None else status


class OptionError(ValueError):
    """A value was set that no rule allows; nothing was changed."""


class UnknownNameError(OptionError, KeyError):
    """There is no variable of this name; `known` are those there are."""

    def __init__(self, name: str, known: Iterable[str]) -> None:
        from difflib import get_close_matches  # only where a name is wrong

        near = get_close_matches(name, known, 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        super().__init__(f"no variable is named {name!r}{hint}")

    __str__ = ValueError.__str__  # KeyError's is the message in quotation marks


class Status(IntEnum):
    """Status codes of the kernel, one meaning each."""

    OK = 0
    NEWTON_DIVERGED = 1
    UZAWA_DIVERGED = 2
    SINGULAR_TANGENT = 3
    NOT_FINITE = 4
    ZERO_LENGTH = 5
    BAD_STEP = 6
    BAD_LAW = 7
    TURN_TOO_LARGE = 8
    DAMPING_REVERSED = 9
    STEP_COLLAPSED = 10


SENTENCE = {
    Status.OK: "done",
    Status.NEWTON_DIVERGED: (
        "Newton's iteration did not converge, even with the step halved 6 times; "
        "a smaller solver.step_size, or solver.longest_step with a tolerance, "
        "usually helps"
    ),
    Status.UZAWA_DIVERGED: (
        "the constraints could not be met, even with the step halved 6 times; check that the "
        "lengths can be closed, or use a larger solver.penalty or solver.max_uzawa"
    ),
    Status.SINGULAR_TANGENT: (
        "the tangent matrix is singular, even with the step halved 6 times; "
        "look for a force that pushes without bound, or use a smaller solver.penalty"
    ),
    Status.NOT_FINITE: (
        "a number grew beyond all bounds, even with the step halved 6 times; "
        "a smaller solver.step_size, or solver.longest_step with a tolerance, "
        "usually helps"
    ),
    Status.ZERO_LENGTH: (
        "a spring, damper, torque, driver or formula acts along two points that coincide, or by an "
        "angle of a vector of length zero, so that its direction is undefined; move the points "
        "apart, or use a spring with free_length = 0"
    ),
    Status.BAD_STEP: (
        "the step must be a finite number > 0 s and at most 1e9 internal steps long; "
        "use a shorter communication step or a larger solver.step_size"
    ),
    Status.BAD_LAW: (
        "a stiffness, free length or damping became negative, or a spring, damper or potential not "
        "a number; look at their expressions at this time and with these inputs"
    ),
    Status.TURN_TOO_LARGE: (
        "a body turns by more than 2.5 rad within a half step, even halved 6 times; "
        "a smaller solver.step_size is needed to tell which way it turns"
    ),
    Status.DAMPING_REVERSED: (
        "dampers fed energy, even with the step halved 6 times: steps of an order above 2 also go "
        "back, too far for such strong dampers; use solver.order = 2 or a smaller step_size"
    ),
    Status.STEP_COLLAPSED: (
        "the internal step collapsed: solver.tolerance asks for more than 1e6 of them in this "
        "communication step; take shorter communication steps or a wider solver.tolerance; if "
        "neither helps, look for masses or sizes that are many powers of ten apart"
    ),
}
"""What each status means, and the remedy."""

NO_EQUILIBRIUM = (
    "no static equilibrium was found from the drawn configuration; look for a part that nothing "
    "holds, or draw it closer to where it comes to rest"
)
"""What is said where the setting start = "equilibrium" finds none."""

AT_THE_START = {
    Status.SINGULAR_TANGENT: (
        "its equations have no unique solution as drawn; look for a part that nothing holds "
        "against its constraints, or use a smaller solver.penalty"
    ),
    Status.NOT_FINITE: (
        "a number of it is not finite; look at the expressions of positions, forces and drivers at "
        "the start"
    ),
}
"""What is said instead of `SENTENCE` where it happens before the first step."""


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


def at_the_start(status: Status, equilibrium: bool) -> str:
    """Return what is said of a start that failed; `equilibrium`: while one was sought."""
    if status is Status.NEWTON_DIVERGED and equilibrium:
        return NO_EQUILIBRIUM
    return AT_THE_START.get(status, SENTENCE[status])
