"""Spatial mechanisms move as another multibody code, Exudyn, moves them: recorded, or run anew.

Both methods are of order 2, and of both E(h) = (4 q(h/2) - q(h))/3 is compared, with the largest
change of E when h is halved as its uncertainty: more than the error that remains in E(h/2).
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import solver
from benchmarks.measuring.effort import TINY
from benchmarks.peers import exudyn_peer
from tests.recorded.peer_models import RUNS, extrapolated, load

SCENES = Path(__file__).resolve().parents[2] / "scenes"
ROUNDING = 1e-11
"""What both codes leave when they stop to iterate, relative to lengths of 1 m and 10^4 steps."""
ROAD = "0.03*(1 - cos(6*t))"


@dataclass(frozen=True, slots=True)
class Case:
    """Our scene of a recorded model."""

    scene: str
    step: float
    """Largest internal step [s]."""
    names: dict[str, tuple[str | None, ...]]
    """Our names of the components of each record; None where there is none."""
    drop: tuple[str, ...] = ()
    """Tables that the recorded model does not have."""
    road: str = ""
    """What stands in for the input `road`."""

    def model(self) -> solver.Model:
        """Assembled scene."""
        text = (SCENES / f"{self.scene}.toml").read_text(encoding="utf-8")
        for table in self.drop:
            text = re.sub(rf"^\[{table}\]\n(?:[^\[\n].*\n|\n)*", "", text, flags=re.MULTILINE)
        if self.road:
            text = text.replace('"road"', f'"{self.road}"')
        return solver.assemble(solver.loads(text, name=f"{self.scene}.toml"))


def place(name: str) -> dict[str, tuple[str | None, ...]]:
    """Names of a place in space."""
    return {name: tuple(f"{name}.{axis}" for axis in "xyz")}


CASES = {
    "bricard": Case("bricard", 0.01, place("rod3.end")),
    "heavy_top": Case("heavy_top", 2e-3, place("top.nose")),
    "spatial_slider_crank": Case(
        "spatial_slider_crank",
        1e-4,
        place("slider") | place("crank.pin") | {"motor": (None, None, "motor.torque")},
    ),
    "free_slider_crank": Case(
        "spatial_slider_crank", 1e-4, place("slider") | place("crank.pin"), drop=("drivers",)
    ),
    "flyball_governor": Case("flyball_governor", 5e-3, place("slider") | place("right_ball")),
    "double_wishbone": Case(
        "double_wishbone",
        2e-3,
        place("car") | place("axle") | place("upright"),
        drop=("inputs",),
        road=ROAD,
    ),
}
SHARP = {"motor": 1e-2}
"""Largest tolerance of a comparison that says something, where it is not `SHARPEST`."""
SHARPEST = 1e-6


def ours(name: str) -> tuple[dict[str, np.ndarray], dict[str, float]]:
    """Our E(h/2) of each record, components that have no name as zeros, and its uncertainty."""
    case, run = CASES[name], RUNS[name]
    model = case.model()
    wanted = [n for names in case.names.values() for n in names if n]
    paths = [
        solver.simulate(
            model, stop_time=run.stop, step_size=run.period, internal_step=h, outputs=wanted
        )
        for h in (case.step, case.step / 2, case.step / 4)
    ]
    values, uncertainty = {}, {}
    for record, names in case.names.items():
        zero = np.zeros(len(paths[0].t))
        q = [np.stack([p[n] if n else zero for n in names], axis=1) for p in paths]
        coarse, fine = ((4.0 * b - a) / 3.0 for a, b in itertools.pairwise(q))
        values[record] = fine
        uncertainty[record] = float(np.max(np.abs(fine - coarse)))
    return values, uncertainty


@pytest.mark.parametrize("name", CASES)
def test_another_multibody_code_finds_the_same_motion(name):
    theirs = load(name)
    values, uncertainty = ours(name)
    for record, names in CASES[name].names.items():
        tolerance = theirs["uncertainty"][record] + uncertainty[record] + ROUNDING
        assert tolerance < SHARP.get(record, SHARPEST), f"{record}: {tolerance:.1e} says nothing"
        named = [i for i, n in enumerate(names) if n]
        expected = np.array(theirs["values"][record])[:, named]
        assert values[record][:, named] == pytest.approx(expected, abs=tolerance, rel=0), record


@pytest.mark.parametrize("name", CASES)
def test_a_record_says_where_it_comes_from(name):
    content = load(name)
    assert {"program", "version", "integrator", "steps", "day"} <= content["origin"].keys()
    assert content["times"][-1] == RUNS[name].stop
    assert all(len(table) == len(content["times"]) for table in content["values"].values())
    assert content["values"].keys() == content["uncertainty"].keys() >= CASES[name].names.keys()


@pytest.mark.parametrize("name", CASES)
def test_the_record_is_what_the_other_code_computes(name):
    pytest.importorskip("exudyn")
    theirs, run = load(name), RUNS[name]
    # The first of the two extrapolations that were recorded: their difference is the uncertainty.
    for record, values in extrapolated(run, run.step).items():
        tolerance = 1.5 * theirs["uncertainty"][record] + ROUNDING
        assert values == pytest.approx(np.array(theirs["values"][record]), abs=tolerance, rel=0)


# ------------------------------------------------------------------ beside our own steps, in time


def test_the_other_code_is_timed_in_a_process_of_its_own():
    pytest.importorskip("exudyn")
    jobs = [
        exudyn_peer.Job(name, name, n, 1e-4, 2)
        for name, n in (("planar_chain", (3,)), ("rigid_chain", (3,)), ("bricard", ()))
    ]
    found, remarks = exudyn_peer.measured(jobs, TINY)
    assert len(remarks) == 1, remarks
    assert all(found[job.key]["step"] > 0.0 for job in jobs)


def test_planar_models_of_the_other_code_move_as_their_references():
    pytest.importorskip("exudyn")
    from benchmarks.peers.exudyn_problem import Build
    from benchmarks.problems.catalogue import andrews, four_bar

    ends = []
    for problem, step, stop in ((andrews(), 1e-5, 0.03), (four_bar(2), 1e-3, 1.0)):
        build = Build(problem, stop)
        build.solve(round(stop / step), stop, newton=1e-10)
        ends.append(build.recorded())
    crank, bars = ends
    # Order 2: a tenth of the step would leave a hundredth of 9e-5 and 2.4e-5.
    angle = 15.81077119629904  # Test Set for IVP Solvers
    direction = crank["K1", "x"][-1, :2] / 0.00092
    assert direction == pytest.approx((np.cos(angle), np.sin(angle)), abs=2e-4)
    place = (-0.195020302, -0.980799206)  # one degree of freedom, by quadrature
    assert bars["crank0", "watch0"][-1, :2] == pytest.approx(place, abs=5e-5)
