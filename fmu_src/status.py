"""Codes of the output `solver.status` that belong to the slave, and the names of the logs.

Codes below 100 are the kernel's: they say why a step failed. Those here say that the slave did not
even try one. Zero says that the last communication step succeeded.
"""

from __future__ import annotations

ASSEMBLY_FAILED = 101
"""The mechanism cannot be assembled with its present parameters."""

VALUE_REFUSED = 102
"""A value was refused (not finite, out of range, unknown option, not settable now)."""

STEP_REFUSED = 103
"""A communication step was refused: its size, start or end, or the state of the instance."""

STATE_REFUSED = 104
"""A saved state was refused: of another model or version, or damaged."""

INTERRUPTED = 105
"""The user interrupted the step."""

INTERNAL_FAULT = 106
"""A fault of this program; the log has its text."""

NOT_FINITE = 107
"""An output is not a finite number, and 0 was handed out for it."""

LOG_CATEGORIES = {
    "logStatusWarning": "Effects that you may not expect. The run goes on.",
    "logStatusDiscard": "Why a communication step was discarded, and what to change.",
    "logStatusError": "Values, states and calls that were refused.",
    "logAll": "Everything.",
}

LOGGER = "holonom"
"""Python's logger of all instances: it writes to stderr where the host says nothing else."""
