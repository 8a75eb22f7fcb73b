"""The table of laws of contact: our figures, textbook laws, and figures that see what is broken."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from benchmarks.contact_laws import by_holonom, judge, section, textbook
from benchmarks.contact_laws.experiments import IMPACTS, Impact, cases, slid
from benchmarks.contact_laws.method import Answers, answers
from benchmarks.pages.report import Value
from benchmarks.peers.peer_interpreter import answer

READ = 2e-9
"""Round-off of rows over the 10 us after which velocities are read, and their curvature in it."""
VALUES = Path(__file__).parents[1] / "core" / "impact_values.json"
SETS = {"rod": "rod", "kane": "kane", "corner": "box3_corner", "flat": "box3_flat",
        "cradle3": "cradle3", "cradle7": "cradle7"}  # fmt: skip


def figure(row: Mapping[str, Value], name: str) -> float:
    """Return a figure that was measured."""
    value = row[name]
    assert isinstance(value, float)
    return value


@pytest.fixture(scope="module")
def located() -> Answers:
    return answers(by_holonom.METHODS[0])


@pytest.fixture(scope="module")
def stepped() -> Answers:
    return answers(by_holonom.METHODS[1])


@pytest.fixture(scope="module", params=[0, 1], ids=["Newton", "Poisson"])
def of_textbook(request) -> Answers:
    return answers(textbook.METHODS[request.param])


@pytest.mark.parametrize(
    "law", ["energy", "cone", "restitution", "elastic", "limit", "order", "momentum"]
)
def test_located_impacts_keep_every_law(located, law):
    assert figure(judge.figures(located), law) < READ


def test_located_impacts_all_have_an_answer(located):
    assert judge.figures(located)["answered"] == "50 of 50"


def test_located_impacts_take_what_was_computed_apart(located):
    """Of recorded values, from a prototype of the law that knows nothing of scenes."""
    sets, compared = json.loads(VALUES.read_text())["sets"], 0
    for (impact, mu, e), after in judge.found(located):
        for known in sets[SETS[impact.key]]["cases"]:
            if (known["coefficient"], known["restitution"]) == (mu, e):
                energy = impact.energy(impact.before)
                assert judge.loss(impact, after) == pytest.approx(known["loss"], abs=READ * energy)
                compared += 1
    assert compared > 30


def test_an_elastic_impact_of_one_contact_is_that_of_a_stiff_spring(located):
    """Of 4000 steps a contact; the error falls with their length, and is 7e-5 with 1000."""
    assert figure(judge.figures(located), "springs") < 3e-5


@pytest.mark.parametrize(
    "name", ["rod", "kane", "box3_corner", "box3_spin", "ball_fast", "rod_jam"]
)
def test_recorded_elastic_impacts_of_one_contact_are_those_of_a_stiff_spring(name):
    """Also where friction pulls a contact in; 1000 steps a contact, of first order."""
    given = json.loads(VALUES.read_text())["sets"][name]
    M, before = np.linalg.inv(given["W"]), np.array(given["before"])
    impact = Impact(
        key=name, title=name, M=M, G=np.eye(len(before)), before=before,
        tangents=len(before) - 1, order=(0,),
    )  # fmt: skip
    elastic = [case for case in given["cases"] if case["restitution"] == 1.0]
    assert elastic
    for case in elastic:
        after = textbook.springs(impact, case["coefficient"], 1000)
        assert after == pytest.approx(case["after"], abs=5e-4 * impact.speed)


@pytest.mark.parametrize("law", ["energy", "limit", "order", "momentum"])
def test_stepped_impacts_keep_these_laws(stepped, law):
    assert figure(judge.figures(stepped), law) < READ


@pytest.mark.parametrize("law", ["cone", "restitution", "elastic", "springs"])
def test_stepped_impacts_keep_these_laws_to_the_order_of_the_step(stepped, law):
    """Bodies turn by up to 2e-4 rad in the steps of 10 us between the impact and the reading."""
    assert figure(judge.figures(stepped), law) < 1e-4


@pytest.mark.parametrize("mode", ["located", "stepped"])
def test_a_parked_box_stays_below_what_friction_holds_and_slides_above(mode, request):
    row = judge.parked(request.getfixturevalue(mode))
    assert slid(0.601) == pytest.approx(4.905e-3, rel=1e-10)
    assert row["changes"] == 0
    for name in ("parked", "lift", "below", "above"):
        assert figure(row, name) < 1e-12


# ------------------------------------------------------------------------------ laws of textbooks


def test_laws_of_textbooks_agree_without_friction_and_where_nothing_gives_back(
    of_textbook, located
):
    """With friction at e = 0 as long as no slip stops before the end: Kane's pendulum with 0.1.

    The box turns by 1e-4 rad until its velocities are read, and its turn rate with it.
    """
    ours = {(i.key, mu, e): v for (i, mu, e), v in judge.found(located) if i.order != i.turned}
    for (impact, mu, e), after in judge.found(of_textbook):
        if impact.order != impact.turned and (
            mu == 0.0 or (impact.key, mu, e) == ("kane", 0.1, 0.0)
        ):
            assert after == pytest.approx(ours[impact.key, mu, e], abs=1e-7)


def test_newtons_law_makes_energy_of_friction_and_poissons_takes_more_than_the_path():
    """Kane and Levinson 1985; values of the rod by hand: pieces of Routh's path."""
    rod, kane = IMPACTS["rod"], IMPACTS["kane"]
    newton, poisson = (method.impact for method in textbook.METHODS)
    assert judge.loss(kane, newton(kane, 0.5, 0.5)) < -0.5 * kane.energy(kane.before)
    assert judge.loss(rod, newton(rod, 0.5, 1.0)) == pytest.approx(-0.299286601, abs=1e-9)
    assert judge.loss(rod, poisson(rod, 0.5, 1.0)) == pytest.approx(0.274883338, abs=1e-9)


# ----------------------------------------------------------------------------------- the figures


def answered(change) -> Answers:
    """Return answers of a code that has nothing but the changes of velocities of the cases."""
    after = [(i.before + change(i)).tolist() for i, _, _ in cases()]
    return {"name": "none", "settings": "", "after": after, "rest": {}}


def test_energy_that_is_made_is_seen():
    found = judge.figures(answered(lambda impact: 0.1 * impact.before))
    assert found["energy"] == pytest.approx(0.21)
    assert found["momentum"] == pytest.approx(0.1)


def test_friction_beyond_its_cone_is_seen():
    """An impulse of 1 along the first contact and of 2 across it; the least friction is 1e-9."""

    def change(impact):
        row = impact.G[0] + 2.0 * impact.G[1] if impact.tangents else impact.G[0]
        return np.linalg.solve(impact.M, row)

    assert judge.figures(answered(change))["cone"] == pytest.approx(2.0 - 1e-9, rel=1e-12)


def test_what_was_not_answered_has_no_figure():
    refused = answered(lambda _: 0.0) | {"after": ["no"] * len(cases())}
    row = judge.figures(refused)
    assert row.pop("answered") == "0 of 50"
    assert row.pop("solver") == "none"
    assert set(row.values()) == {None}


# ------------------------------------------------------------------------------------ other codes


@pytest.mark.parametrize("module", section.PEERS)
def test_another_code_lets_a_ball_of_the_cradle_hit_and_keeps_its_momentum(module):
    _, package, variable = section.PEERS[module]
    if section.packages_there([package], variable).absence(package):
        pytest.skip(f"no {package}")
    program = ["-m", "benchmarks.peers.peer_run", "benchmarks.contact_laws.method"]
    request = {"module": module, "keys": ["cradle3"]}
    rows = [judge.figures(row) for row in answer(program, request, variable=variable)]
    answered = [row for row in rows if row["answered"] != "0 of 50"]  # Drake's discrete has no e
    assert answered
    assert all(figure(row, "momentum") < 1e-6 for row in answered)
