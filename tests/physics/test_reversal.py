"""A motion reversed returns to its start: the step is symmetric in both ends."""

from __future__ import annotations

import numpy as np
import pytest

from tests.support.kernel.kernel_cases import SOURCES, is_plain
from tests.support.kernel.twins import advance, start, vector
from tests.support.mechanisms.scene_files import SMOOTH


def conservative(integrator):
    """Switch off what drives or damps."""
    for name in {"damping", "drive", "push"} & {v.name for v in integrator.model.variables}:
        integrator[name] = 0.0
    integrator.initialise()


REVERSIBLE = ("bricard", "dzhanibekov", "heavy_top", "chaplygin_sleigh", "rolling_disc", "watt")
"""Mechanisms of bodies, joints, functions and velocity rows that nothing drives or damps."""


@pytest.mark.parametrize("name", [*(path.stem for path in SMOOTH if is_plain(path)), *REVERSIBLE])
def test_a_motion_reversed_returns_to_its_start(name):
    run = start(SOURCES[name])
    conservative(run)
    q, v = vector(run, "q"), vector(run, "v")
    speed = max(1.0, np.max(np.abs(v)))
    advance(run, 20)
    there = vector(run, "q")
    for part in ("v", "v_low"):
        half = np.asarray(run.state.vectors[part])
        half[:] = -half
    advance(run, 20)
    # rounding 1e-16 of 80 half steps, which multipliers of either parity carry on
    assert np.max(np.abs(vector(run, "q") - q)) < 1e-12 * speed
    assert np.max(np.abs(vector(run, "v") + v)) < 1e-9 * speed
    assert np.max(np.abs(there - q)) > 1e-5
