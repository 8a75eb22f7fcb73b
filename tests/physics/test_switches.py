"""Laws that jump or have a kink: steps end there at every order, and go on with the law behind."""

from __future__ import annotations

import math

import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline, PchipInterpolator, make_interp_spline

import solver
from tests.support.fmus.commands import run
from tests.support.kernel.twins import block, start

POINT = """
name = "point"
dimension = 2
[points]
A = {{ position = [{x}, 0], mass = 1.0, velocity = [{v}, 0] }}
[forces]
f = {{ type = "force", point = "A", value = ["{law}", 0] }}
"""
METHODS = {
    **{f"order {k}": {"step_size": 0.05, "order": k} for k in (2, 4, 6, 8)},
    "tolerance": {"tolerance": 1e-9},
    "tolerance, order 4": {"tolerance": 1e-9, "order": 4},
}


def moved(law, method, *, stop, step, x=0.0, v=0.0, outputs=("A.x", "A.vx")):
    """Place and velocity at the end of a run, of communication steps of this length."""
    model = solver.assemble(solver.loads(POINT.format(law=law, x=x, v=v)))
    integrator = start(model, **METHODS[method])
    for k in range(round(stop / step)):
        integrator.advance(k * step, step)
    return tuple(float(integrator[name]) for name in outputs)


def pushed(pieces):
    """Place and velocity after forces a + b (t - t0) between times (t0, t1, a, b), from rest."""
    x = v = 0.0
    for begin, end, a, b in pieces:
        h = end - begin
        x, v = x + v * h + a * h**2 / 2 + b * h**3 / 6, v + a * h + b * h**2 / 2
    return x, v


TURN = math.pi / 7
CONSTANT = {
    "1 if t < 0.6137 else -1": [(0, 0.6137, 1, 0), (0.6137, 1, -1, 0)],
    "floor(3.7*t)": [(k / 3.7, min(1, (k + 1) / 3.7), k, 0) for k in range(4)],
    "ceil(3.7*t) - 1": [(k / 3.7, min(1, (k + 1) / 3.7), k, 0) for k in range(4)],
    "sign(sin(7*t))": [(0, TURN, 1, 0), (TURN, 2 * TURN, -1, 0), (2 * TURN, 1, 1, 0)],
    "1 if 0.5031 < t < 0.5055 else 0":
        [(0, 0.5031, 0, 0), (0.5031, 0.5055, 1, 0), (0.5055, 1, 0, 0)],
    "1 if t == 0.5 else 2": [(0, 1, 2, 0)],
    "1 if t > (0.3 if t > 0.7 else 0.8) else 0": [(0, 0.7, 0, 0), (0.7, 1, 1, 0)],
    "floor(2000*t)/2000": [(k / 2000, (k + 1) / 2000, k / 2000, 0) for k in range(2000)],
}  # fmt: skip
LINEAR = {
    "mod(t, 0.3)": [(0.3 * k, min(1, 0.3 * (k + 1)), 0, 1) for k in range(4)],
    "min(t, 0.4173)": [(0, 0.4173, 0, 1), (0.4173, 1, 0.4173, 0)],
    "max(0.4173, t)": [(0, 0.4173, 0.4173, 0), (0.4173, 1, 0.4173, 1)],
    "abs(t - 0.4173)": [(0, 0.4173, 0.4173, -1), (0.4173, 1, 0, 1)],
}


@pytest.mark.parametrize("step", [0.05, 1.0])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("law", CONSTANT)
def test_laws_of_the_time_are_met_to_round_off(law, method, step):
    """Forces that stand in between are exact at any order: parabolas are."""
    assert moved(law, method, stop=1.0, step=step) == pytest.approx(
        pushed(CONSTANT[law]), abs=3e-15
    )


@pytest.mark.parametrize("method", [name for name in METHODS if name != "order 2"])
@pytest.mark.parametrize("law", LINEAR)
def test_kinks_of_the_time_are_met_to_round_off(law, method):
    """Cubics are exact above order 2. At a tolerance that may be taken the error is its part."""
    allowed = 1e-9 if "tolerance" in method else 3e-15
    assert moved(law, method, stop=1.0, step=0.25) == pytest.approx(
        pushed(LINEAR[law]), abs=allowed
    )


def test_pulses_that_no_step_samples_are_seen():
    """Eight times as wide as arccos(0.9999)/25."""
    width = 2 * math.acos(0.9999) / 50
    middles = [(math.pi / 2 + 2 * math.pi * k) / 50 for k in range(8)]
    right = sum(width * (1 - t) for t in middles), 8 * width
    found = moved("1 if sin(50*t) > 0.9999 else 0", "order 2", stop=1.0, step=1.0)
    assert found == pytest.approx(right, abs=2e-12)  # 0.9999 is known to 1e-16, its arccos to 1e-14


def test_a_pulse_many_communication_steps_ahead_is_seen():
    _, speed = moved("1 if 1.3301 < t < 1.3302 else 0", "order 2", stop=2.0, step=0.01)
    assert speed == pytest.approx(1e-4, abs=1e-14)


def test_a_switch_comes_sooner_where_a_parameter_or_an_input_begins_to_change():
    """Pushed from 1.55 s, 5 s at first, and from 1.13 s, as u goes up in 0.1 s."""
    text = POINT.format(law="(1 if t > late else 0) + (10 if u > 0.3 else 0)", x=0, v=0)
    text += '[inputs]\nu = { start = 0, interpolation = "ramp" }\n'
    text += '[parameters]\nlate = { value = 5, variability = "tunable" }\n'
    point = start(solver.assemble(solver.loads(text)), step_size=0.05)
    for k in range(20):
        if k == 10:
            point["late"] = 1.55
        if k == 11:
            point["u"] = 1.0
        point.advance(0.1 * k, 0.1)
    assert float(point["A.vx"]) == pytest.approx(0.45 + 10 * 0.87, abs=1e-13)


@pytest.mark.parametrize("kind", ["linear", "monotone"])
def test_conditions_on_profiles_of_the_time_are_met(kind, tmp_path):
    """A saw of period 0.4 is above 0.9 in the last tenth of its ways up and the first ones down."""
    (tmp_path / "saw.csv").write_text("x,y\n0,0\n0.2,1\n0.4,0\n")
    text = POINT.format(law="1 if saw(t) > 0.9 else 0", x=0, v=0)
    text += f'[profiles]\nsaw = {{ file = "saw.csv", interpolation = "{kind}", '
    scene = tmp_path / "saw.toml"
    scene.write_text(text + "periodic = true }\n")
    model = solver.assemble(solver.load(scene))
    once, often = (start(model, step_size=0.05) for _ in range(2))
    once.advance(0.0, 1.0)
    for k in range(1000):
        often.advance(1e-3 * k, 1e-3)
    assert float(once["A.vx"]) == pytest.approx(float(often["A.vx"]), abs=1e-12)
    if kind == "linear":
        assert float(once["A.vx"]) == pytest.approx(2 * 0.04 + 0.02, abs=1e-14)


TABLE = {"x": [0, 0.31, 0.57, 1.2], "y": [0, 2, -1, 0.5]}
TABLES = {
    "linear": lambda x, y: make_interp_spline(x, y, k=1),
    "monotone": PchipInterpolator,
    "cubic": lambda x, y: CubicSpline(x, y, bc_type="natural"),
}


@pytest.mark.parametrize("step", [0.2, 1.2])
@pytest.mark.parametrize("method", ["order 6", "order 8", "tolerance", "tolerance, order 4"])
@pytest.mark.parametrize("kind", TABLES)
def test_forces_by_tables_of_the_time_keep_order_and_tolerance(kind, method, step):
    """Quintics are exact above order 4; SciPy integrates the same curves."""
    curve = TABLES[kind](TABLE["x"], TABLE["y"])
    v = curve.antiderivative(1)
    right = float(v.antiderivative(1)(1.2)), float(v(1.2))
    text = POINT.format(law="g(t)", x=0, v=0)
    text += f'[profiles]\ng = {{ x = {TABLE["x"]}, y = {TABLE["y"]}, interpolation = "{kind}" }}\n'
    point = start(solver.assemble(solver.loads(text)), **METHODS[method])
    for k in range(round(1.2 / step)):
        point.advance(k * step, step)
    allowed = 3e-15 if "order" in method and "tol" not in method else 1e-9
    assert (point["A.x"], point["A.vx"]) == pytest.approx(right, abs=allowed)


@pytest.mark.parametrize("method", METHODS)
def test_a_periodic_table_of_the_place_is_passed_point_by_point(method):
    """Each period of 0.4 m gives 0.2 J: v^2 = 1 + 0.4 n, and more by 10 (x - 0.4 n)^2 behind."""
    text = POINT.format(law="saw(A.x)", x=0, v=1)
    text += "[profiles]\nsaw = { x = [0, 0.1, 0.4], y = [0, 1, 0], periodic = true, "
    point = start(
        solver.assemble(solver.loads(text + 'interpolation = "linear" }')), **METHODS[method]
    )
    for k in range(20):
        point.advance(0.1 * k, 0.1)
        x, v = float(point["A.x"]), float(point["A.vx"])
        n = math.floor(x / 0.4)
        u = x - 0.4 * n
        gained = 5 * u**2 if u < 0.1 else 0.05 + 0.15 - 0.5 * (0.4 - u) ** 2 / 0.3
        assert v * v / 2 == pytest.approx(
            0.5 + 0.2 * n + gained, abs=1e-8 if "tol" in method else 2e-3
        )


def test_conditions_on_a_ramped_input_are_met_within_a_communication_step():
    text = POINT.format(law="1 if u > 0.3 else 0", x=0, v=0)
    text += '[inputs]\nu = { start = 0, interpolation = "ramp" }\n'
    point = start(solver.assemble(solver.loads(text)), step_size=0.05)
    point["u"] = 1.0
    point.advance(0.0, 1.0)
    assert float(point["A.vx"]) == pytest.approx(0.7, abs=1e-14)


def thrown(x, v, a, stop, turn=0.0):
    """Place and velocity of a point with the acceleration -a sign(x - turn)."""
    t = 0.0
    while True:
        side = math.copysign(1.0, x - turn) if x != turn else math.copysign(1.0, v)
        until = side * (v + side * math.sqrt(v * v + 2 * a * side * (x - turn))) / a
        h = min(until, stop - t)
        x, v, t = x + v * h - side * a * h * h / 2, v - side * a * h, t + h
        if t >= stop:
            return x, v
        x = turn


@pytest.mark.parametrize("step", [0.1, 1.0])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "law", ["-sign(A.x)", "1 if A.x < 0 else -1", "-abs(A.x)/A.x", "-1 - 2*floor(A.x/1e3)"]
)
def test_laws_of_the_motion_are_located_to_round_off(law, method, step):
    found = moved(law, method, stop=3.0, step=step, x=1.0)
    assert found == pytest.approx(thrown(1.0, 0.0, 1.0, 3.0), abs=2e-13)
    assert found == pytest.approx((-0.985281374239, 0.171572875254), abs=1e-11)


@pytest.mark.parametrize("method", [name for name in METHODS if name != "order 2"])
def test_a_law_that_moves_with_the_time_is_located_where_it_switches(method):
    """It moves by t^2/2 + t^3/6 up to t = 0.43, then along a parabola: each try begins on time."""
    place, speed = 0.43**2 / 2 + 0.43**3 / 6, 0.43 + 0.43**2 / 2
    law = "1 + t if A.x < 0.43**2/2 + 0.43**3/6 else -1"
    found = moved(law, method, stop=1.0, step=0.25)
    right = (place + speed * 0.57 - 0.57**2 / 2, speed - 0.57)
    assert found == pytest.approx(right, abs=2e-15)


@pytest.mark.parametrize("method", METHODS)
def test_two_switches_in_a_step_are_both_met(method):
    """Work 0.005 J within 0.5 < x < 0.505: v^2 = 1.01 behind it."""
    law = "1 if A.x > 0.5 and A.x < 0.505 else 0"
    _, v = moved(law, method, stop=1.0, step=0.5, v=1.0)
    assert v == pytest.approx(math.sqrt(1.01), abs=1e-11 if method == "tolerance" else 1e-13)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("place", [0.1, 0.12, 0.1249, 0.124999])
def test_a_switch_that_is_crossed_there_and_back_in_a_step_is_seen(place, method):
    """It turns at x = 0.125 after 0.5 s; above the place it is pulled back twice as hard.

    Time is v'/2 where the speed there is v': round-off of the place grows by its inverse.
    """
    v = math.sqrt(0.25 - 2 * place)
    found = moved(f"-2 if A.x > {place} else -1", method, stop=1.0, step=1.0, v=0.5)
    rest = 1.0 - (0.5 - v) - v
    right = place - v * rest - rest * rest / 2, -v - rest
    assert found == pytest.approx(right, abs=1e-13 + 1e-16 / v)


@pytest.mark.parametrize("method", METHODS)
def test_a_switch_that_is_crossed_there_and_back_before_another_one_is_seen(method):
    """It is at x = 0.12 after 0.4 and 0.5 s with 0.1 m/s, and goes at -0.5 m/s after 0.9 s."""
    text = POINT.format(law="-2 if A.x > 0.12 else -1", x=0, v=0.5)
    text = text.replace('", 0]', '", "1 if A.vx < -0.5 else 0"]')
    point = start(solver.assemble(solver.loads(text)), **METHODS[method])
    point.advance(0.0, 1.0)
    assert (point["A.vx"], point["A.vy"]) == pytest.approx((-0.6, 0.1), abs=1e-13)


@pytest.mark.parametrize("method", METHODS)
def test_a_level_is_seen_that_is_crossed_there_and_back_before_the_other_one_in_a_step(method):
    """It goes up through x = 0.12, pulled by 2 there, and down through 0, where nothing pulls."""
    v = math.sqrt(2 * 0.0601)
    u = math.sqrt(v * v - 2 * 0.06)
    down = math.sqrt(u**2 + 2 * 0.12)
    found = moved("-1 - floor(A.x/0.12)", method, stop=1.0, step=1.0, x=0.06, v=v)
    until = (v - u) + u + (down - u)
    assert found == pytest.approx((-down * (1 - until), -down), abs=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_a_level_that_is_touched_there_and_back_in_a_step_is_seen(method):
    """A step of 1 above x = 0.12 alone, where it turns: there and back it is pulled by 2."""
    v = math.sqrt(0.25 - 2 * 0.12)
    law = "-1 - floor(A.x/0.12) if A.x > 0 else -1"
    found = moved(law, method, stop=0.95, step=0.95, v=0.5)
    rest = 0.95 - (0.5 - v) - v
    assert found == pytest.approx((0.12 - v * rest - rest * rest / 2, -v - rest), abs=1e-13)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("law", ["sign", "abs"])
def test_a_law_of_what_joints_hold_at_zero_does_not_switch(law, method):
    """The speed along the axis of a hinge is 0 but for rounding, of either sign."""
    text = """
        name = "hinged"
        gravity = [0, 0, -9.81]
        [bodies.B]
        position = [0, 0, 0]
        mass = 1
        inertia = [1, 2, 2.5]
        [joints.r]
        type = "revolute"
        bodies = ["ground", "B"]
        position = [0.3, 0.4, 0]
        axis = [0.36, 0.48, 0.8]
        [forces.f]
        type = "force"
        point = "B"
    """
    value = f"1e-12*{law}(0.36*B.vx + 0.48*B.vy + 0.8*B.vz)"
    forced, free = (
        start(
            solver.assemble(solver.loads(text + f'value = ["{x}", "0*B.vx", 0]')), **METHODS[method]
        )
        for x in (value, "0")
    )
    for k in range(10):
        forced.advance(0.1 * k, 0.1)
        free.advance(0.1 * k, 0.1)
        assert float(forced["solver.substeps"]) <= float(free["solver.substeps"]) + 1.0
    assert float(forced["B.vx"]) == pytest.approx(float(free["B.vx"]), abs=1e-10)


@pytest.mark.parametrize("method", METHODS)
def test_a_law_without_a_value_behind_its_switch_ends_a_step_before_it(method):
    """v^2 = 1 - 4/3 x^(3/2) at x = 0, where the force ends; sampled forces are of order 2."""
    law = "sqrt(A.x) if A.x > 0 else 0"
    _, v = moved(law, method, stop=1.0, step=0.1, x=0.01, v=-1.0)
    allowed = 1e-7 if method == "tolerance" else 2e-5
    assert v == pytest.approx(-math.sqrt(1 - 4 / 3 * 0.01**1.5), abs=allowed)


@pytest.mark.parametrize("method", METHODS)
def test_a_force_with_the_sign_of_its_rate_holds(method):
    """It loses 1 m/s at 0.3 m/s^2, after 10/3 s at x = 5/3, and stays there."""
    found = moved("0.5 - 0.8*sign(A.vx)", method, stop=5.0, step=0.1, v=1.0)
    assert found == pytest.approx((5 / 3, 0.0), abs=1e-12)


@pytest.mark.parametrize("options", [{"tolerance": 1e-8}, {"step_size": 1e-3, "order": 2}])
def test_a_law_may_begin_on_its_level_where_friction_lets_no_long_step_be_solved(options):
    # A rod of 1 m let go in the horizontal, at the angle a below it: along x its end neither moves
    # nor slips at first. a'' = g cos a - sin a (1 + sin a) while it swings to the left.
    swing = start(
        solver.assemble(
            solver.loads(
                "gravity = [0, -9.81]\n"
                + POINT.format(law="-sign(A.vx) + abs(A.y)", x=1, v=0)
                + "[points.o]\nposition = [0, 0]\nfixed = true\n"
                + '[joints]\nrod = { type = "distance", points = ["o", "A"] }\n'
            )
        ),
        **options,
    )
    for k in range(10):
        swing.advance(0.1 * k, 0.1)
    exact = solve_ivp(
        lambda _, y: [y[1], 9.81 * math.cos(y[0]) - math.sin(y[0]) * (1 + math.sin(y[0]))],
        (0.0, 1.0),
        [0.0, 0.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
    ).y[:, -1]
    found = float(swing["A.x"]), float(swing["A.y"])
    allowed = 3e-8 if "tolerance" in options else 1e-5
    assert found == pytest.approx((math.cos(exact[0]), -math.sin(exact[0])), abs=allowed)


def test_a_force_with_the_sign_of_another_rate_is_refused_where_it_would_hold():
    """No row along that rate would hold with this force, which acts along x and y."""
    law = "-(1 if A.vx + A.vy > 0 else -1)"
    integrator = start(solver.assemble(solver.loads(POINT.format(law=law, x=0, v=0.05))))
    with pytest.raises(solver.StepError, match=r"force 'f': .*A.vx.* give it a hysteresis"):
        integrator.advance(0.0, 0.1)
    assert integrator.time == 0.0


def test_a_law_that_switches_too_often_for_a_communication_step_is_named():
    integrator = start(
        solver.assemble(solver.loads(POINT.format(law="floor(1e7*t)/1e7", x=0, v=0)))
    )
    with pytest.raises(
        solver.StepError, match=r"force 'f': floor.* hundreds of thousands of times"
    ):
        integrator.advance(0.0, 0.5)


BALL = """
name = "ball"
dimension = 2
[points]
A = { position = [0, 1], mass = 1.0, velocity = [1, 0] }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1], restitution = 1.0 }
[forces]
w = { type = "force", point = "A", value = ["2 if t > 0.3137 else 0", "-1 if A.y > 0.4 else -3"] }
"""


@pytest.mark.parametrize("method", METHODS)
def test_impacts_and_switches_are_both_located(method):
    """It falls to 0.4 in sqrt(1.2) s, on to the floor with 3 m/s^2, and comes back as it fell."""
    ball = start(solver.assemble(solver.loads(BALL)), **METHODS[method])
    for k in range(35):
        ball.advance(0.1 * k, 0.1)
    above, v = math.sqrt(1.2), math.sqrt(1.2 + 6 * 0.4)
    below = (v - above) / 3
    late = 3.5 - 2 * above - 2 * below  # it was at 1 m again, and falls anew
    allowed = 1e-8 if method.startswith("tolerance") else 1e-12
    assert 0.0 < late < above
    assert ball["A.y"] == pytest.approx(1.0 - late**2 / 2, abs=allowed)
    assert ball["A.vy"] == pytest.approx(-late, abs=allowed)
    assert ball["A.x"] == pytest.approx(3.5 + (3.5 - 0.3137) ** 2, abs=allowed)
    assert float(ball["solver.events"]) <= 3.0


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "law",
    [
        "-0.3*(1 if A.vx > 0 else -1)",
        "0.3 if 0 > A.vx else -0.3",
        "-0.3 if A.vx > 0 else (0.3 if A.vx < 0 else 0)",
        "0.3 - 0.6*(A.vx >= 0)",
        "0 if A.vx == 0 else -0.3*sign(A.vx)",
    ],
)
def test_friction_that_is_written_with_conditions_holds(law, method):
    """It loses 1 m/s at 0.3 m/s^2, after 10/3 s at x = 5/3, and stays there."""
    assert moved(law, method, stop=5.0, step=0.1, v=1.0) == pytest.approx((5 / 3, 0.0), abs=1e-12)


@pytest.mark.parametrize("method", ["tolerance", "tolerance, order 4"])
@pytest.mark.parametrize(
    "law",
    [
        "-0.3*sign(A.vx) - 0.5*A.vx",
        "-(0.3 + 0.5*A.vx) if A.vx > 0 else 0.3 - 0.5*A.vx",
        "-(0.3 + 0.5*abs(A.vx))*sign(A.vx)",
    ],
)
def test_friction_that_changes_with_its_rate_holds(law, method):
    """It slides by v' = -0.3 - v/2 until e^(t/2) = 16/6; x = 3.2 (1 - e^(-t/2)) - 0.6 t."""
    t = 2 * math.log(16 / 6)
    right = 3.2 * (1 - 6 / 16) - 0.6 * t, 0.0
    assert moved(law, method, stop=5.0, step=0.1, v=1.0) == pytest.approx(right, abs=3e-9)


@pytest.mark.parametrize("method", ["tolerance", "tolerance, order 4"])
def test_friction_of_stribeck_slides_and_holds(method):
    """It goes the integral of v/(0.3 + 0.5/(1 + 10 v)) = (v + 10 v^2)/(0.8 + 3 v) from 0 to 1.

    That is 10/3 v - 5/9 + (4/9)/(0.8 + 3 v).
    """
    right = 10 / 6 - 5 / 9 + 4 / 27 * math.log(3.8 / 0.8)
    law = "-(0.3 + 0.5/(1 + 10*abs(A.vx)))*sign(A.vx)"
    found = moved(law, method, stop=5.0, step=0.1, v=1.0)
    assert found == pytest.approx((right, 0.0), abs=3e-9)


def test_a_force_that_pushes_with_the_sign_of_its_rate_does_not_hold():
    found = moved("0.8*sign(A.vx) - 0.5", "order 2", stop=1.0, step=0.1, v=0.1)
    assert found == pytest.approx((0.1 + 0.15, 0.4), abs=1e-13)


def test_saved_states_continue_bit_for_bit_across_switches():
    model = solver.assemble(solver.loads(POINT.format(law="-sign(A.x) + floor(3*t)", x=1, v=0)))
    whole, first, second = (start(model, tolerance=1e-8) for _ in range(3))
    for k in range(30):
        whole.advance(0.1 * k, 0.1)
    for k in range(17):
        first.advance(0.1 * k, 0.1)
    block(second)[:] = block(first)
    for k in range(17, 30):
        second.advance(0.1 * k, 0.1)
    assert block(second).tobytes() == block(whole).tobytes()


def test_info_lists_the_switches_by_part_and_condition(tmp_path, capsys):
    scene = tmp_path / "point.toml"
    law = "min(t, 2) if A.x < 1 and t < 3 else 0.25*floor(A.vx)"
    scene.write_text(POINT.format(law=law, x=0, v=0))
    code, out, _ = run(capsys, "info", str(scene))
    assert code == 0
    for switch in ("min(t, 2)", "A.x < 1", "t < 3", "floor(A.vx)"):
        assert f"force 'f': {switch}" in out


def test_conditions_of_parameters_alone_are_no_switches():
    text = POINT.format(law="max(k, 1)*(1 if k > 2 else t)", x=0, v=0)
    text += '[parameters]\nk = { value = 3, variability = "tunable" }\n'
    assert solver.assemble(solver.loads(text)).switches == ()
