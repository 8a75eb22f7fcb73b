"""Work and precision: every code solves the same problems, and the references deserve the name."""

from __future__ import annotations

import math
from dataclasses import replace
from importlib import import_module

import numpy as np
import pytest

from benchmarks.peers.peer_methods import distance
from benchmarks.peers.peer_reduced import reduced, unwritten
from benchmarks.peers.peer_scipy import PEERS, compiled_path, equations
from benchmarks.problems import exact
from benchmarks.problems.catalogue import PROBLEMS
from benchmarks.problems.mechanisms import scene, start_scene
from benchmarks.problems.parts import GROUND, energies
from benchmarks.problems.work_precision_references import reference
from benchmarks.sections import work_precision_ours
from tests.recorded.peer_models import load

SHORT = 0.5
"""End of short runs, as a part of the problem's."""
REDUCED = [key for key in PROBLEMS if not unwritten(PROBLEMS[key]())]
KEYS = [key for key in REDUCED if key not in ("chain_100", "chain_1000", "four_bar_40")]
"""Large ones are the same functions of a number."""
DAMPED = ["hanging_chain", "governor"]


def problem_of(key):
    return PROBLEMS[key]()


def state_of(key, t, tolerance=1e-13):
    problem = replace(problem_of(key), stop=t)
    return reduced(problem).look(t, compiled_path(problem, tolerance)[1][-1])


# ------------------------------------------------------------------------------- exact solutions


@pytest.mark.parametrize(
    ("t", "points"),
    [
        (1.0, [(-0.585168391999, -0.810911803469), (-1.444818849943, -1.321794461381)]),
        (2.0, [(-0.4644128687, -0.885618816075), (-1.434124817464, -1.129870195647)]),
        (5.0, [(-0.586869209816, -0.809681746472), (-1.55077846947, -1.075912734813)]),
    ],
)
def test_the_double_pendulum_is_where_an_independent_integration_has_it(t, points):
    # DOP853 at 1e-13, printed with twelve digits; its error grows from t = 1 to 5.
    state = exact.double_pendulum_motion(math.pi / 2, t)
    q, _, _ = equations("double_pendulum_90").look(t, np.array(state, dtype=float))
    assert q[:, :2] == pytest.approx(np.array(points), abs=2e-11)


@pytest.mark.parametrize(
    ("t", "place"),
    [
        (1.0, (-0.195020302, -0.980799206)),
        (2.0, (0.057815796, 0.998327268)),
        (5.0, (-0.811310461, -0.584615545)),
        (10.0, (0.328458112, 0.944518538)),
    ],
)
def test_the_four_bar_is_where_an_independent_integration_has_it(t, place):
    q, _, _ = equations("four_bar_2").look(t, np.array(exact.four_bar_motion(t)))
    assert q[:, :2] == pytest.approx(np.array([place, (2 + place[0], place[1])]), abs=1e-9)


@pytest.mark.parametrize("angle", [math.pi / 6, math.pi / 2])
def test_the_extrapolated_solution_does_not_depend_on_its_step(angle):
    coarse, fine = (exact.double_pendulum_motion(angle, 3.0, h) for h in (0.025, 0.0125))
    assert np.max(np.abs(coarse - fine)) < 1e-13


@pytest.mark.parametrize("key", ["double_pendulum_30", "double_pendulum_90", "four_bar_40"])
def test_exact_solutions_solve_the_compiled_equations(key):
    problem = replace(problem_of(key), stop=2.0)
    right = reference(problem)
    q, v, _ = state_of(key, 2.0)
    assert q == pytest.approx(np.array(right.q), abs=1e-10)
    assert v == pytest.approx(np.array(right.v), abs=1e-9)


def test_the_reduced_squeezer_ends_where_the_test_set_has_it():
    y = compiled_path(problem_of("andrews"), 1e-13)[1][-1]
    # Mazzia and Magherini (2008), part II.3: angle and rate of the crank, good to 1e-9 of them.
    assert y == pytest.approx([15.81077119629904, 1139.920302151208], rel=1e-9)


def test_the_reduced_car_axis_ends_where_the_test_set_has_it():
    q, v, _ = state_of("car_axis", 3.0)
    # The same, part II.5.
    places = [[0.04934557842755629, 0.4969894602303324], [1.041742524885400, 0.3739110272652214]]
    speeds = [
        [-0.07705836840321485, 0.007446866596327776],
        [0.01755681574942899, 0.7703410437794031],
    ]
    assert q[:, :2] == pytest.approx(np.array(places), abs=1e-9)
    assert v[:, :2] == pytest.approx(np.array(speeds), abs=1e-8)


@pytest.mark.parametrize(
    ("key", "name", "place"),
    [
        ("bricard", "rod3.end", 0),
        ("heavy_top", "top.nose", 0),
        ("governor", "slider", 0),
        ("governor", "right_ball", 1),
    ],
)
def test_the_reduced_equations_move_as_another_code_recorded(key, name, place):
    record = load({"governor": "flyball_governor"}.get(key, key))
    for t, expected in list(zip(record["times"], record["values"][name], strict=True))[5::10]:
        found = state_of(key, t)[0][place]
        # The uncertainty is that of two extrapolations, without the rounding of 1e5 steps.
        tolerance = 3 * record["uncertainty"][name] + 1e-11
        assert found == pytest.approx(expected, abs=tolerance, rel=0)


# ------------------------------------------------------------------------- one problem, many codes


def start_of(problem):
    """What the numbers of a problem say of its start."""

    def read(name, what):
        body = problem.bodies[name]
        values = {"x": body.position, "v": body.velocity, "w": body.omega}
        if what in values:
            return np.array([values[what]])
        place = problem.springs[int(what[6])].ends[int(what[7])][1]
        return np.array([body.position + body.attitude @ np.array(place)])

    places, speeds = [], []
    for name, place in problem.watch:
        body = problem.bodies[name]
        arm = body.attitude @ np.array(place)
        places.append(np.array(body.position) + arm)
        speeds.append(np.array(body.velocity) + np.cross(body.attitude @ np.array(body.omega), arm))
    return np.array(places), np.array(speeds), float(energies(problem, read)[0])


@pytest.mark.parametrize("key", REDUCED)
def test_equations_and_numbers_have_the_same_start_and_energy(key):
    problem = problem_of(key)
    q, v, energy = start_of(problem)
    equation = reduced(problem)
    reduced_q, reduced_v, reduced_energy = equation.look(0.0, equation.start)
    assert reduced_q == pytest.approx(q, abs=1e-14)
    assert reduced_v == pytest.approx(v, abs=1e-14)
    # The equations of the governor leave out the shaft's weight, which never moves.
    shaft = 0.3 * 9.81 * 0.5 if key == "governor" else 0.0
    assert reduced_energy + shaft == pytest.approx(energy, rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("key", PROBLEMS)
def test_scene_and_numbers_have_the_same_start_and_energy(key):
    problem = problem_of(key)
    q, v, energy = start_of(problem)
    integrator = start_scene(scene(work_precision_ours.DRAWN[key].content()))
    our_q, our_v = work_precision_ours.watched(problem, integrator)
    # 1e-13: Andrews' scene is closed by a Newton iteration.
    assert our_q == pytest.approx(q, abs=1e-13)
    # The car's wheel is driven, and its rate a difference quotient: round-off over 1e-2 steps.
    assert our_v == pytest.approx(v, abs=1e-12 if key == "car_axis" else 1e-13)
    # Our scene of the car also has the wheel that is moved, with 1 m/s.
    wheel = 0.5 * work_precision_ours.WHEEL if key == "car_axis" else 0.0
    assert integrator["energy.total"] - wheel == pytest.approx(energy, rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("key", [key for key in KEYS if key not in DAMPED])
def test_the_mechanism_as_drawn_moves_as_the_reduced_equations_say(key):
    problem = replace(problem_of(key), stop=SHORT * problem_of(key).stop)
    method = work_precision_ours.methods(problem)[3]
    assert method.name == "holonom conserving, order 8"
    found = method.observe(problem, 8 * work_precision_ours.DRAWN[key].first)
    q, v, _ = state_of(key, problem.stop)
    # A wrong mass or length would be 1e-3.
    assert distance(found.q, q.tolist()) < 1e-5
    assert distance(found.v, v.tolist()) < 1e-2 if key == "andrews" else 1e-4


@pytest.mark.parametrize("key", DAMPED)
def test_with_dampers_orders_2_and_8_come_to_the_reduced_equations(key):
    problem = replace(problem_of(key), stop=0.1 * problem_of(key).stop)
    plain, _, _, eighth, *_ = work_precision_ours.methods(problem)
    counts = [16 * work_precision_ours.DRAWN[key].first * k for k in (1, 2)]
    coarse, fine = (np.array(plain.observe(problem, n).q) for n in counts)
    q, _, _ = state_of(key, problem.stop)
    assert distance(((4 * fine - coarse) / 3).tolist(), q.tolist()) < 1e-5
    found = eighth.observe(problem, counts[0])
    assert distance(found.q, q.tolist()) < 1e-5
    assert not found.remark


def test_a_tolerance_is_a_curve_of_its_own_for_each_method():
    problem = problem_of("double_pendulum_30")
    right = reference(problem)
    *_, conserving, fastest = work_precision_ours.methods(problem)
    for curve in (conserving, fastest):
        errors = [distance(curve.observe(problem, e).q, right.q) for e in (1e-3, 1e-6, 1e-9)]
        assert errors[0] > errors[1] > errors[2]
        assert errors[2] < 1e-7
    assert "conserving" in conserving.name
    assert "fastest" in fastest.name


@pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.name)
@pytest.mark.parametrize("key", ["double_pendulum_30", "heavy_top", "car_axis"])
def test_peers_on_reduced_equations_reach_the_reference(key, peer):
    problem = replace(problem_of(key), stop=0.25)
    found = peer.observe(problem, 1e-10)
    right = reference(problem)
    assert distance(found.q, right.q) < 1e-8
    assert abs(found.change - right.change) < 1e-7


@pytest.mark.parametrize(
    ("key", "part"),
    [
        *(("double_pendulum_30", 0.1), ("bricard", 0.1), ("governor", 0.05), ("andrews", 0.7)),
        *(("rigid_chain_10", 0.5), ("stewart", 0.2), ("double_wishbone", 1.0)),
    ],
)
def test_a_model_of_another_code_moves_as_the_reference(key, part):
    pytest.importorskip("exudyn")
    from benchmarks.peers.peer_exudyn import METHODS

    problem = replace(problem_of(key), stop=part * problem_of(key).stop)
    right = reference(problem)
    coarse, fine = (distance(METHODS[0].observe(problem, n).q, right.q) for n in (400, 800))
    assert fine < 1e-4
    assert coarse / fine == pytest.approx(4.0, rel=0.2)  # order 2


@pytest.mark.parametrize(
    ("module", "package", "setting"),
    [
        ("peer_mujoco", "mujoco", 1600),
        ("peer_sundials", "sksundae", 1e-8),
        ("peer_ida", "casadi", 1e-7),
        ("peer_drake", "pydrake", 1e-6),
        ("peer_simbody", "opensim", 1e-7),
    ],
)
@pytest.mark.parametrize(
    "key",
    [
        *("double_pendulum_30", "andrews", "heavy_top", "bricard"),
        *("rigid_chain_10", "stewart", "double_wishbone"),
    ],
)
def test_every_code_moves_the_same_mechanism(key, module, package, setting):
    # OpenSim brings a CasADi of its own: of the two, the one that comes second is skipped.
    pytest.importorskip(package, exc_type=ImportError)
    (first, *_) = import_module(f"benchmarks.{module}").METHODS
    problem = replace(problem_of(key), stop=0.5 * problem_of(key).stop)
    if first.excuse(problem):
        pytest.skip(first.excuse(problem))
    found = first.observe(problem, setting)
    right = reference(problem)
    # A hundredth of what a body, a joint or a spring that is missing would do.
    assert distance(found.q, right.q) < 1e-5
    assert abs(found.change - right.change) < 1e-3


def test_ground_is_no_body():
    assert all(GROUND not in build().bodies for build in PROBLEMS.values())
