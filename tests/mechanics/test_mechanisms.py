"""Mechanisms of `scenes/` move in as many ways as their textbooks say."""

from __future__ import annotations

import pytest

import solver
from solver.mechanics.mobility import survey
from tests.support.mechanisms.mechanism_runs import scene

FREEDOM = {
    # by counting (Kutzbach), by rank, with drivers, of velocities; joints of the textbooks
    "andrews": (1, 1, 1, 1),
    "bricard": (0, 1, 1, 1),
    "flyball_governor": (4, 4, 4, 4),
    "car_axis": (4, 4, 2, 2),
    "slider_crank": (1, 1, 0, 0),
    "spatial_slider_crank": (0, 1, 0, 0),
    "heavy_top": (3, 3, 3, 3),
    "dzhanibekov": (6, 6, 6, 6),
    "cardan_shaft": (-2, 1, 0, 0),
    "screw_jack": (-3, 1, 1, 1),
    "watt": (1, 1, 1, 1),
    "stephenson": (1, 1, 0, 0),
    "peaucellier": (1, 1, 0, 0),
    "jansen": (1, 1, 0, 0),
    "double_wishbone": (5, 5, 2, 2),  # quarter car, wheel, and the three of the tyre's foot
    "stewart": (6, 6, 0, 0),
    "rolling_disc": (5, 5, 5, 3),
    "chaplygin_sleigh": (3, 3, 3, 2),
    "snakeboard": (6, 6, 3, 1),
    "differential": (2, 2, 2, 2),
}


@pytest.mark.parametrize("name", FREEDOM)
def test_a_mechanism_moves_in_as_many_ways_as_its_textbook_says(name):
    found = survey(solver.assemble(solver.load(scene(name))))
    counts = (
        *(found.mobility_by_count, found.mobility),
        *(found.degrees_of_freedom, found.velocity_freedom),
    )
    assert counts == FREEDOM[name]
