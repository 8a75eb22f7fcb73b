"""A step counts only if its ledger closes: small increments alone do not tell that it is solved.

The same kernel runs with and without that rule. Where rows depend on each other and a singular
configuration is near, increments fall below the tolerance before the residual does.
"""

from __future__ import annotations

import pytest

from tests.support.kernel.kernels_without_skips import (
    integrator_with,
    kernel_without,
    needs_compiler,
)
from tests.support.mechanisms.problems import Content, assemble, four_bar

pytestmark = needs_compiler


def worst_ledger(content: Content, until: float, h: float, *, energy_decides: bool) -> float:
    """Largest error of the energy of a run at order 4, at points 20 ms apart."""
    library = kernel_without(0, 2, energy_decides=energy_decides)
    run = integrator_with(library, assemble(content), step_size=h, order=4.0)
    errors = []
    while run.time < until:
        run.advance(run.time, 0.02)
        errors.append(float(run["energy.error"]))
    return max(errors)


def hyperstatic() -> Content:
    """Two loops that a row too many guides, through their flat configuration at 0.714 s."""
    again = {"type": "distance", "points": ["A1", "B1"]}
    return four_bar(2) | {"joints": {"again": again}}


@pytest.mark.parametrize("h", [2e-4, 1e-4])
def test_steps_of_a_hyperstatic_mechanism_close_their_ledger_only_because_it_decides(h):
    assert worst_ledger(hyperstatic(), 0.75, h, energy_decides=True) < 1e-13
    assert worst_ledger(hyperstatic(), 0.75, h, energy_decides=False) > 1e-11
