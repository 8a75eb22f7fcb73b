"""Mechanisms that cannot move every way they might get: disc, sleigh and snakeboard."""

from __future__ import annotations

import pytest

from tests.support.mechanisms.mechanism_runs import extrapolated, run, times
from tests.support.mechanisms.nonholonomic_models import snakeboard


def test_the_snakeboard_goes_as_the_oracle():
    exact = snakeboard(times(5.0, 1.0))
    found = extrapolated("snakeboard", ["board.x", "board.y", "board.angle"], 0.01, 5.0, every=1.0)
    assert exact[-1, 0] > 1.0  # it gets along, though nobody pushes
    assert found == pytest.approx(exact, abs=1e-6)


def test_the_rider_pays_for_the_way_of_the_snakeboard():
    kinetic, work, error = run(
        "snakeboard", ["energy.kinetic", "energy.work", "energy.error"], 0.01, 10.0, every=0.5
    ).T
    assert work == pytest.approx(kinetic - kinetic[0], abs=1e-12)
    assert work[-1] > 1.0
    assert error.max() < 1e-12
