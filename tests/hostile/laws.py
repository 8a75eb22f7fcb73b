"""Random laws with switches: a run keeps its tolerance against SciPy's, or ends in a sentence."""

from __future__ import annotations

from pathlib import Path

import solver
from tests.support.mechanisms.switched_laws import UnfitError, drawn, excess

NEEDS = ("scipy",)
CPU_LIMIT = 120.0
TIMES_THE_REQUEST = 10.0
"""Above it a switch was missed: errors of single steps grow by a few times."""


def prepare(_folder: Path) -> None:
    """Nothing: scenes are drawn."""


def case(seed: str, number: int, _folder: Path) -> str | None:
    """Draw a law on a mechanism, and compare its motion."""
    drawn_case = drawn(f"{seed}/{number}")
    for tolerance in (1e-4, 1e-6):
        try:
            times = excess(drawn_case, tolerance)
        except UnfitError:
            return None
        except (solver.SceneError, solver.StepError) as error:
            return f"at {tolerance:g}: {error}"
        if not times < TIMES_THE_REQUEST:
            return f"at {tolerance:g} it errs by {times:.3g} times the request"
    return None
