"""Right values of the corpus: kept within a tolerance, approached with the order, by default."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.truth.record import RIGHT, different, right_now
from tests.truth.system import (
    BEYOND_TOLERANCE,
    BY_DEFAULT,
    FASTEST,
    OF_ORDER,
    ROUND_OFF,
    TOLERANCES,
    WRONG,
    System,
)
from tests.truth.systems import SYSTEMS


def checks(names: Callable[[System], Iterator[str]]) -> pytest.MarkDecorator:
    """Each check of each system; one that fails today names the issue that mends it."""
    return pytest.mark.parametrize(
        ("system", "check"),
        [
            pytest.param(
                system, name, id=f"{system.name}-{name.replace(' ', '_')}",
                marks=[pytest.mark.xfail(reason=f"issue {system.fails[name]}", raises=WRONG)]
                if name in system.fails else [],
            )
            for system in SYSTEMS
            for name in names(system)
        ],
    )  # fmt: skip


@checks(lambda _: iter((*TOLERANCES, *FASTEST)))
def test_a_run_keeps_its_tolerance(system: System, check: str) -> None:
    tolerance = check.removeprefix("fastest ")
    method = "conserving" if check == tolerance else "fastest"
    error = system.error(RIGHT[system.name], tolerance=float(tolerance), method=method)
    assert error < system.bounds.get(tolerance, BEYOND_TOLERANCE * float(tolerance))


@checks(lambda system: (f"order {order}" for order in system.orders))
def test_the_error_of_equal_steps_falls_with_the_order(system: System, check: str) -> None:
    right, order = RIGHT[system.name], int(check.split()[1])
    long, short = (
        system.error(right, internal_step=step, order=order)
        for step in (system.internal_step, system.internal_step / 2)
    )
    assert short < max(ROUND_OFF, long / (OF_ORDER * 2**order))


@checks(lambda _: iter(["default"]))
def test_a_run_without_settings_is_right(system: System, check: str) -> None:
    error = system.error(RIGHT[system.name])
    assert error < system.bounds.get(check, BY_DEFAULT)


def test_the_corpus_has_right_values_of_each_system() -> None:
    assert [system.name for system in SYSTEMS] == list(RIGHT)
    assert len(SYSTEMS) == len({system.name for system in SYSTEMS})


def test_marks_name_checks_of_their_system() -> None:
    for system in SYSTEMS:
        known = {"default", *TOLERANCES, *FASTEST, *(f"order {order}" for order in system.orders)}
        assert known >= {*system.fails, *system.bounds}, system.name
        assert bool(system.bounds) == bool(system.reason), system.name


@pytest.mark.long
@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_recorded_values_are_those_of_closed_forms_and_references(system: System) -> None:
    assert different(right_now(system), RIGHT[system.name]) < 1e-10
