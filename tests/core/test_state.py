"""A saved state comes back whole, or is refused and the present one stays."""

from __future__ import annotations

import contextlib
import math
import struct
from pathlib import Path

import pytest

from solver.runtime import Integrator, OptionError, StepError
from solver.runtime.layout import ISLAND, PLACE, state_sections
from tests.support.kernel.kernels_without_skips import counted, integrator_without, needs_compiler
from tests.support.kernel.saved_states import NUMBERS_AT, PHASE_AT, signed
from tests.support.kernel.twins import PENDULUM, advance, block, model_of, start

SCENES = Path(__file__).parents[2] / "scenes"
ENDLESS = ("mean_time", "mean_time_before", "wanted")
"""What may be infinite: times of means that are not known, a step that nothing limits."""

SPRING_OF_INPUT = """
name = "spring_of_input"
dimension = 2
[inputs]
k = { start = 10.0 }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 0.3 }
[forces]
spring = { type = "spring", points = ["O", "A"], stiffness = "29.98 - t*k", free_length = 0.5 }
"""


def moved(source: str = PENDULUM) -> Integrator:
    integrator = start(source)
    advance(integrator, 5)
    return integrator


def assert_refused_and_kept(data: bytes, words: str, source: str = PENDULUM) -> None:
    integrator = moved(source)
    before, phase = block(integrator).tobytes(), integrator.phase
    with pytest.raises(OptionError, match=words):
        integrator.restore(data)
    assert block(integrator).tobytes() == before
    assert integrator.phase == phase
    advance(integrator, 1)


@pytest.mark.parametrize("name", ["penalty", "step_size", "time", "max_newton"])
@pytest.mark.parametrize("value", [1e6, float("nan")], ids=str)
def test_a_scalar_changed_in_the_bytes_is_noticed(name, value):
    data = bytearray(moved().save())
    struct.pack_into("<d", data, NUMBERS_AT + 8 * PLACE[name], value)
    assert_refused_and_kept(bytes(data), "damaged")


@pytest.mark.parametrize("place", [45, 52, -1, -200])
def test_a_single_bit_changed_in_the_bytes_is_noticed(place):
    data = bytearray(moved().save())
    data[place] ^= 1
    assert_refused_and_kept(bytes(data), "the saved state")


def test_a_phase_that_does_not_exist_is_refused_even_with_the_right_checksum():
    saved = bytearray(moved().save())
    struct.pack_into("<q", saved, PHASE_AT, 7)
    assert_refused_and_kept(signed(saved), "damaged")


def forged(number: float, place: int, source: str = PENDULUM) -> bytes:
    """A saved state with another number at a place, and the checksum of that."""
    data = bytearray(moved(source).save())
    struct.pack_into("<d", data, NUMBERS_AT + 8 * place, number)
    return signed(data)


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_a_number_that_is_not_finite_is_refused_anywhere_even_with_the_right_checksum(number):
    endless = [PLACE[name] for name in ENDLESS] if number == math.inf else []
    for place in range(len(block(moved()))):
        if place not in endless:
            assert_refused_and_kept(forged(number, place), "not finite; save it again")


def test_a_state_after_a_jump_of_its_loads_comes_back():
    # Two neighbouring means of multipliers are then not known: the time of the last is infinite.
    run = moved(SPRING_OF_INPUT)
    run["k"] = 9.0
    assert run.state.head["mean_time"] == math.inf
    other = Integrator(model_of(SPRING_OF_INPUT))
    other.restore(run.save())
    assert other.save() == run.save()


@pytest.mark.parametrize("cut", [0, 7, 56, 59, 60, 61, -8, -1])
def test_a_state_that_was_cut_off_is_refused(cut):
    assert_refused_and_kept(moved().save()[:cut], "the saved state")


@pytest.mark.parametrize("mark", [b"holonom1", b"holonom2"])
def test_the_state_of_an_earlier_format_is_refused(mark):
    assert_refused_and_kept(mark + moved().save()[8:], "not one of this format")


def test_the_state_of_another_model_is_refused():
    other = start(PENDULUM.replace("mass = 2.0", "mass = 3.0"))
    assert_refused_and_kept(other.save(), "another model")


def test_a_state_that_time_has_brought_beyond_a_rule_comes_back():
    # At t = 3 s the stiffness is -0.02 N/m, at the last midpoint before it was still positive:
    # nobody set it so, and a saved state is taken as it is.
    integrator = start(SPRING_OF_INPUT)
    integrator.advance(0.0, 3.0)
    saved = integrator.save()
    other = Integrator(model_of(SPRING_OF_INPUT))
    for each in (integrator, other):
        each.restore(saved)
        assert each.save() == saved
        with pytest.raises(StepError, match="became negative"):
            each.advance(3.0, 0.1)


def damaged_die(vector: str, place: int, value: float) -> tuple[Integrator, bytes]:
    """A die at rest on corners in its bowl, and its saved state with another number."""
    run = start(SCENES / "die_in_a_bowl.toml")
    run.advance(0.0, 0.6)
    good = run.save()
    run.state.vectors[vector][place] = value
    damaged = run.save()
    run.restore(good)
    return run, damaged


@pytest.mark.parametrize("value", [0.0, 5e-324, 1e300, 3.0, -1.0], ids=str)
def test_a_state_that_deforms_a_body_is_refused_by_its_name(value):
    """Taken, the zeroed axes of the die cost 5,000 iterations a step, and none was solved."""
    run, damaged = damaged_die("q", 5, value)
    before, numbers = run.save(), bytes(run.numbers)
    with pytest.raises(OptionError, match=r"does not fit body 'die', by .* of its size; save it"):
        run.restore(damaged)
    assert (run.save(), bytes(run.numbers)) == (before, numbers)
    run.advance(run.time, 0.01)


@pytest.mark.parametrize("level", [1e18, 4.0, 0.5, -1.0], ids=str)
def test_a_state_whose_penalty_no_run_comes_to_is_refused(level):
    # Raised 1e18 times, it once kept the kernel from ever ending a step.
    place = state_sections(model_of(PENDULUM).sizes)["islands"][0] + ISLAND.index("penalty_level")
    assert_refused_and_kept(forged(level, place), "a penalty that no run comes to")


@pytest.mark.parametrize("name", ["bend", "lean_contraction", "predicts_lambda"])
@pytest.mark.parametrize("number", [-1.0, 1e17])
def test_a_state_whose_learned_contraction_no_run_comes_to_is_refused(name, number):
    # It would take a first increment for the last one.
    place = state_sections(model_of(PENDULUM).sizes)["islands"][0] + ISLAND.index(name)
    assert_refused_and_kept(forged(number, place), "a contraction that no run comes to")


def test_a_long_rest_leaves_a_state_that_comes_back():
    # Each step of one increment trusts less in what was learned, by a twentieth, for ever.
    run = start(PENDULUM)
    run.advance(0.0, 0.2)
    run.state.vectors["islands"][ISLAND.index("bend")] = 1e15
    run.advance(run.time, 2.0)
    other = start(PENDULUM)
    other.restore(run.save())
    assert block(other).tobytes() == block(run).tobytes()


@pytest.mark.filterwarnings(  # what the log says of steps of 40 times the length
    "ignore:until t = .* the friction of contacts acts at the end:RuntimeWarning"
)
@pytest.mark.parametrize("scene", sorted(SCENES.glob("*.toml")), ids=lambda path: path.stem)
def test_a_state_of_any_run_is_taken_however_loosely_its_steps_are_solved(scene):
    run = start(scene)
    run.reset()
    step = 40.0 * run.state.head["step_size"]
    run["solver.newton_tolerance"], run["solver.step_size"] = 1e-3, step
    changed = [
        v for v in run.model.variables if "tunable" in v.variability or v.causality == "input"
    ]
    run.initialise(0.0)
    for k in range(8):
        saved = run.save()
        run.restore(saved)
        assert run.save() == saved
        with contextlib.suppress(StepError):
            run.advance(run.time, step)
        with contextlib.suppress(OptionError):
            for name in (variable.name for variable in changed[k::8]):
                value = run[name]
                assert isinstance(value, float)
                run[name] = 1.1 * value + 0.1


@needs_compiler
def test_a_step_that_slides_and_has_no_solution_ends_after_a_bounded_number_of_cuts():
    """There are a thousand, of 20 factorisations; twenty for each millionth took minutes."""
    run = integrator_without(0, model_of(SCENES / "bowling_ball.toml"))
    run.advance(0.0, 0.01)
    derived, rows = run.state.vectors["derived"], run.model.sizes["n_rows"]
    for row in range(rows):
        derived[2 + rows + row] = 1e300  # row_sigma: no update changes a multiplier
        for name in ("mu_first", "mu_second"):  # and none holds the ball
            run.state.vectors[name][row] = 0.0
    before = counted(0, 3).factorisations
    with pytest.raises(StepError, match="near contact 'lane'"):
        run.advance(run.time, 0.01)
    assert counted(0, 3).factorisations - before < 50 * 1000


def test_a_state_outlives_the_name_of_its_integrator():
    state = start(PENDULUM).state
    others = [start(PENDULUM) for _ in range(20)]
    for other in others:
        other.state.head["horizon"] = 7.0
    assert state.head["horizon"] != 7.0
