"""Impacts of random sets of contacts obey the laws that they name.

One or two bodies with 1 to 3 contacts; V, P and T are the largest rate before and impulse, and
the kinetic energy.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from tests.support.contact.contact_laws import HAS_COMPILER, Impact, Laws
from tests.support.contact.contact_sets import ContactSet, random_sets
from tests.support.mechanisms.problems import Array

pytestmark = pytest.mark.skipif(not HAS_COMPILER, reason="no C compiler")

EXACT = {2: 1e-11, 3: 1e-10}
"""Round-off of straight paths, and the error of the Runge-Kutta pair where slips turn."""
ALIKE = {2: 1e-9, 3: 1e-7}
"""Likewise, of two runs; events of almost the same time may come in another order."""
STEEP = 1e3
"""Bound of slopes: rates over V, for a change of a coefficient of friction or restitution."""


@pytest.fixture(scope="module")
def laws(tmp_path_factory) -> Laws:
    return Laws(tmp_path_factory.mktemp("laws"))


SETS = {"hard": {}, "some": {2: (11, 100), 3: (12, 100)}, "many": {2: (21, 5000), 3: (22, 1000)}}
"""Seed and number of sets by the dimension."""
HARD = Path(__file__).with_name("hard_impacts.json")
"""Jams, slips that stop with the walls, and turns of walls: one or two of a thousand drawn sets."""


def hard_sets(dimension: int) -> list[ContactSet]:
    return [
        ContactSet(
            **{word: np.array(value) for word, value in x.items()},
            tangents=[dimension - 1] * len(x["coefficient"]),
        )
        for x in json.loads(HARD.read_text())[str(dimension)]
    ]


@pytest.fixture(
    params=[
        pytest.param((size, dimension), marks=[pytest.mark.long] if size == "many" else [])
        for size in SETS
        for dimension in (2, 3)
    ],
    ids=lambda x: f"{x[0]}-{x[1]}D",
)
def dimension_and_sets(request) -> tuple[int, list[ContactSet]]:
    size, dimension = request.param
    if size == "hard":
        return dimension, hard_sets(dimension)
    seed, count = SETS[size][dimension]
    return dimension, list(islice(random_sets(dimension, seed), count))


def sizes(x: ContactSet, found: Impact) -> tuple[float, float, float]:
    return float(np.abs(x.before).max()), float(np.abs(found.impulse).max()), x.energy


def hit(x: ContactSet, laws: Laws) -> Impact:
    found = x.hit(laws)
    assert not found.failed
    assert not found.newton
    return found


def smooth(*found: Impact) -> bool:
    """Tell whether rates were unique all along: neither jams nor several solutions."""
    return not any(x.jam or x.several for x in found)


def tangents(x: ContactSet) -> Iterator[tuple[int, slice]]:
    for k, n in zip(x.first, x.tangents, strict=True):
        yield int(k), slice(int(k) + 1, int(k) + 1 + n)


def test_impulses_push_and_contacts_part(laws, dimension_and_sets):
    dimension, sets = dimension_and_sets
    for x in sets:
        found = hit(x, laws)
        V, P, _ = sizes(x, found)
        assert found.impulse[x.first].min() >= 0.0
        assert found.after[x.first].min() >= -EXACT[dimension] * V
        assert P > 0.0


def test_friction_stays_in_the_cone_of_each_contact(laws, dimension_and_sets):
    dimension, sets = dimension_and_sets
    for x in sets:
        found = hit(x, laws)
        P = sizes(x, found)[1]
        for (k, across), mu in zip(tangents(x), x.coefficient, strict=True):
            force = np.linalg.norm(found.impulse[across])
            assert force <= mu * found.impulse[k] + EXACT[dimension] * P


def test_the_loss_is_what_contacts_keep_and_friction_takes(laws, dimension_and_sets):
    """Never below 0, and e^2 of each compression comes back where nothing jams."""
    dimension, sets = dimension_and_sets
    for x in sets:
        found = hit(x, laws)
        small = 10.0 * EXACT[dimension] * x.energy
        kept = found.compression - found.expansion
        assert found.loss >= -small
        assert found.friction >= -small
        assert abs(found.loss - kept.sum() - found.friction - found.plastic) <= small
        back = x.restitution**2 * found.compression
        assert (found.expansion <= back + small).all()
        if not found.jam:
            assert found.expansion == pytest.approx(back, abs=small)


def test_friction_that_vanishes_gives_the_frictionless_impact(laws, dimension_and_sets):
    _, sets = dimension_and_sets
    for x in sets:
        none = hit(replace(x, coefficient=0.0 * x.coefficient), laws)
        for mu in (1e-3, 1e-6, 1e-9):
            found = hit(replace(x, coefficient=np.full(len(x.tangents), mu)), laws)
            change = np.abs(found.after - none.after).max()
            assert change <= STEEP * mu * sizes(x, found)[0]


@pytest.mark.parametrize("word", ["restitution", "coefficient"])
def test_a_small_change_of_a_number_changes_rates_by_little(laws, dimension_and_sets, word):
    _, sets = dimension_and_sets
    for x in sets:
        found = hit(x, laws)
        numbers: Array = getattr(x, word)
        other = hit(
            replace(x, **{word: np.where(numbers == 1.0, numbers - 1e-6, numbers + 1e-6)}), laws
        )
        if smooth(found, other):
            assert np.abs(other.after - found.after).max() <= STEEP * 1e-6 * sizes(x, found)[0]


def test_the_order_of_contacts_does_not_count(laws, dimension_and_sets):
    dimension, sets = dimension_and_sets
    for x in sets:
        found, order = hit(x, laws), list(range(len(x.tangents)))[::-1]
        other = hit(x.with_contacts(order), laws)
        rows = [k for i in order for k in x.rows_of(i)]
        if smooth(found, other):
            assert other.after == pytest.approx(
                found.after[rows], abs=ALIKE[dimension] * sizes(x, found)[0]
            )


def test_units_of_mass_and_speed_do_not_count(laws, dimension_and_sets):
    dimension, sets = dimension_and_sets
    for x in sets:
        found = hit(x, laws)
        small = ALIKE[dimension] * sizes(x, found)[0]
        heavy, fast = hit(replace(x, M=10.0 * x.M), laws), hit(replace(x, v=10.0 * x.v), laws)
        if smooth(found, heavy, fast):
            assert heavy.after == pytest.approx(found.after, abs=small)
            assert fast.after / 10.0 == pytest.approx(found.after, abs=small)


def test_slips_that_stop_with_the_walls_do_so_whatever_order_and_units_are(laws):
    """Bodies of three contacts that come to rest at once: digits must not tell what is first."""
    for x in hard_sets(2):
        found, order = hit(x, laws), list(range(len(x.tangents)))[::-1]
        small, rows = ALIKE[2] * sizes(x, found)[0], [k for i in order for k in x.rows_of(i)]
        assert hit(x.with_contacts(order), laws).after == pytest.approx(
            found.after[rows], abs=small
        )
        for factor in (0.7, 10.0):
            heavy = hit(replace(x, M=factor * x.M), laws)
            fast = hit(replace(x, v=factor * x.v), laws)
            assert heavy.after == pytest.approx(found.after, abs=small)
            assert fast.after / factor == pytest.approx(found.after, abs=small)


def test_a_contact_that_stands_there_twice_changes_nothing(laws, dimension_and_sets):
    """Where rows are independent; else what contacts give back follows how they share."""
    dimension, sets = dimension_and_sets
    for x in sets:
        if not x.independent:
            continue
        found = hit(x, laws)
        twice = hit(x.with_contacts([*range(len(x.tangents)), 0]), laws)
        if smooth(found, twice):
            assert twice.after[: len(found.after)] == pytest.approx(
                found.after, abs=ALIKE[dimension] * sizes(x, found)[0]
            )


def test_impulse_and_rebound_of_one_contact_grow_with_restitution(laws, dimension_and_sets):
    _, sets = dimension_and_sets
    for x in sets:
        if len(x.tangents) > 1:
            continue
        runs = [hit(replace(x, restitution=np.array([e])), laws) for e in np.linspace(0, 1, 5)]
        V, P, T = sizes(x, runs[-1])
        assert (np.diff([run.impulse[0] for run in runs]) >= -1e-11 * P).all()
        assert (np.diff([run.after[0] for run in runs]) >= -1e-11 * V).all()
        assert np.ptp([run.compression[0] for run in runs]) <= 1e-11 * T


def test_elastic_impacts_without_friction_lose_nothing(laws, dimension_and_sets):
    _, sets = dimension_and_sets
    for x in sets:
        elastic = replace(x, coefficient=0.0 * x.coefficient, restitution=np.ones(len(x.tangents)))
        assert abs(hit(elastic, laws).loss) <= 1e-12 * x.energy


def test_one_contact_that_slides_all_along_has_newtons_rebound_where_slip_does_not_press(laws):
    """A ball, whose slip and gap are not coupled: gamma_N = e v and p_T = -mu p_N."""
    W = np.diag([1.0, 3.5, 3.5])
    slip = np.array([30.0, -40.0])
    for e in (0.0, 0.5, 1.0):
        found = laws.impact(W, np.array([-1.0, *slip]), [2], [0.3], [e])
        assert found.after[0] == pytest.approx(e, abs=1e-14)
        assert found.impulse[1:] == pytest.approx(-0.3 * (1 + e) * slip / 50.0, rel=1e-13)
