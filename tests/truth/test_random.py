"""Random trees and loops keep their tolerance, judged by Pinocchio in joint coordinates."""

from __future__ import annotations

import numpy as np
import pytest

from tests.truth.random_record import LONG, SHORT, calculated, fails, recorded
from tests.truth.random_runs import error
from tests.truth.random_systems import KINDS, WAYS, drawn
from tests.truth.system import BEYOND_TOLERANCE, TOLERANCES, WRONG

FAILS = fails()


def checks(seeds: tuple[int, ...]) -> pytest.MarkDecorator:
    """Each tolerance of each seed; one that fails today names the issue that mends it."""
    return pytest.mark.parametrize(
        ("seed", "check"),
        [
            pytest.param(
                seed, check, id=f"{drawn(seed).name}-{check}",
                marks=[pytest.mark.xfail(reason=f"issue {FAILS[seed][check]}", raises=WRONG)]
                if check in FAILS.get(seed, {}) else [],
            )
            for seed in seeds
            for check in TOLERANCES
        ],
    )  # fmt: skip


@checks(SHORT)
def test_a_random_system_keeps_its_tolerance(seed: int, check: str) -> None:
    found = error(*recorded(seed), float(check))
    assert found < BEYOND_TOLERANCE * float(check)


def test_short_runs_have_each_kind_and_each_way() -> None:
    systems = [drawn(seed) for seed in SHORT]
    assert {system.kind for system in systems} == {*KINDS}
    assert {system.way for system in systems} == {*WAYS}
    assert len(SHORT) == 21


@pytest.mark.long
@checks(LONG)
def test_more_random_systems_keep_their_tolerance(seed: int, check: str) -> None:
    pytest.importorskip("pinocchio")
    found = error(*calculated(seed), float(check))
    assert found < BEYOND_TOLERANCE * float(check)


@pytest.mark.long
@pytest.mark.parametrize("seed", SHORT)
def test_recorded_values_are_those_of_pinocchio(seed: int) -> None:
    pytest.importorskip("pinocchio")
    _, scene, right = recorded(seed)
    _, drawn_now, values = calculated(seed)
    assert drawn_now == scene
    assert right.keys() == values.keys()
    for name, row in right.items():
        assert np.abs(row - values[name]).max() <= 1e-9 * max(1.0, np.abs(row).max()), name


FOR_MUJOCO = [
    system.seed
    for system in map(drawn, (*SHORT, *LONG))
    if system.kind in ("tree", "fast") and not system.jumps  # its steps would not end at jumps
][:12]


@pytest.mark.long
@pytest.mark.parametrize("seed", FOR_MUJOCO)
def test_mujoco_finds_the_motions_of_pinocchio(seed: int) -> None:
    pytest.importorskip("pinocchio")
    pytest.importorskip("mujoco")
    from tests.truth.random_mujoco import end_by_mujoco

    system, _, right = calculated(seed)
    for i, (place, velocity) in enumerate(end_by_mujoco(system)):
        for k, axis in enumerate("xy" if system.planar else "xyz"):
            x, v = right[f"b{i}.{axis}"], right[f"b{i}.v{axis}"]
            assert abs(place[k] - x[-1]) < 1e-6 * max(1.0, np.abs(x).max())
            assert abs(velocity[k] - v[-1]) < 1e-6 * max(1.0, np.abs(v).max())
