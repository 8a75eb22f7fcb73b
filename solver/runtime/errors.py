"""What can go wrong once a model exists, and the sentence for each of the kernel's status codes."""

from __future__ import annotations

from enum import IntEnum


class AssemblyError(Exception):
    """The mechanism cannot be assembled with its parameters: one sentence per broken rule."""


class StepError(Exception):
    """A step could not be solved; the state is as before it."""


class OptionError(ValueError):
    """A value was set that no rule allows; nothing was changed."""


class Status(IntEnum):
    """Status codes of the kernel, one meaning each."""

    OK = 0
    NEWTON_DIVERGED = 1
    UZAWA_DIVERGED = 2
    SINGULAR_TANGENT = 3
    NOT_FINITE = 4
    ZERO_LENGTH = 5
    BAD_STEP = 6


SENTENCE = {
    Status.OK: "done",
    Status.NEWTON_DIVERGED: (
        "Newton's iteration did not converge, even with the step halved 6 times; "
        "a smaller solver.step_size usually helps"
    ),
    Status.UZAWA_DIVERGED: (
        "the constraints could not be met, even with the step halved 6 times; check that the "
        "lengths can be closed, or use a larger solver.penalty or solver.max_uzawa"
    ),
    Status.SINGULAR_TANGENT: (
        "the tangent matrix is singular, even with the step halved 6 times; "
        "look for a part without mass or a force that pushes without bound"
    ),
    Status.NOT_FINITE: (
        "a number grew beyond all bounds, even with the step halved 6 times; "
        "a smaller solver.step_size usually helps"
    ),
    Status.ZERO_LENGTH: (
        "a spring, damper or torque acts on two points that coincide, so that its direction is "
        "undefined; move the points apart, or use a spring with free_length = 0"
    ),
    Status.BAD_STEP: (
        "the step must be a finite number > 0 s and at most 1e9 internal steps long; "
        "use a shorter communication step or a larger solver.step_size"
    ),
}
"""What each status means, and the remedy."""
