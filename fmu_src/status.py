"""Phases of a slave, its codes in the output `solver.status`, and the names of the logs.

Codes below 100 are the kernel's: they say why a step failed. Those here say that the slave did not
even try one. Zero says that the last communication step succeeded. ``native/slave_parts.h`` has the
phases and some codes, too.
"""

from __future__ import annotations

INSTANTIATED, INITIALIZING, STEPPING = range(3)

ASSEMBLY_FAILED = 101  # the mechanism cannot be assembled with its present parameters
VALUE_REFUSED = 102  # a value: not finite, out of range, unknown option, not settable now
STEP_REFUSED = 103  # a communication step: its size, start or end, or the state of the instance
STATE_REFUSED = 104  # a saved state: of another model or version, or damaged
INTERRUPTED = 105  # the user interrupted the step
INTERNAL_FAULT = 106  # a fault of this program; the log has its text
NOT_FINITE = 107  # an output is not a finite number, and 0 was handed out for it

OK, WARNING, DISCARD, ERROR, FATAL = range(5)  # fmi2Status

LOG_CATEGORIES = {
    "logStatusWarning": "Effects that you may not expect. The run goes on.",
    "logStatusDiscard": "Why a communication step was discarded, and what to change.",
    "logStatusError": "Values, states and calls that were refused.",
    "logAll": "Everything.",
}

LOGGER = "holonom"
"""Python's logger of all instances: it writes to stderr where the host says nothing else."""
