"""Log, page and `info` tell the steps that a run takes in the same words, and they are true."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from build_fmu.documentation import solved
from build_fmu.self_check import self_check
from solver.runtime import Integrator
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import Instance, instance, text_fmu
from tests.support.fmus.native_fmus import native_fmu

SWING = """
name = "swing"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
"""
KINKED = f"""{SWING}
[forces]
pull = {{ type = "potential", value = "0.1*abs(A.y + 0.3)" }}
"""
BALL = """
name = "ball"
dimension = 2
gravity = [0, -9.81]
[points]
A = { position = [0, 0.2], mass = 1.0 }
[contacts]
floor = { type = "plane", point = "A", axis = [0, 1] }
"""
BRAKE = """
[forces.brake]
type = "damper"
points = ["ground", "A"]
at = [3, 0]
damping = 1.0
"""
BRAKED = SWING + BRAKE
BRAKED_BY_FORMULA = BRAKED.replace("damping = 1.0", 'damping = "1 + t"')
BESIDE = SWING.replace("[joints]", "B = { position = [5, 0], mass = 1.0 }\n[joints]")
RUBBED = f"""{BESIDE}{BRAKE}
[contacts.floor]
type = "plane"
point = "A"
position = [0, -9]
axis = [0, 1]
friction = 0.3
smooth_speed = 0.01
"""
READ = f"""{BESIDE}{BRAKE}
[forces.pull]
type = "force"
point = "B"
value = ["A.x", "0"]
"""
CHOSEN = "chosen for a relative error of the run of"
EXPLICIT = "and explicit ones where they are possible"
CASES = [
    (SWING, {}, f"conserving steps, {CHOSEN} 0.0001"),
    (SWING, {"tolerance": 1e-6}, f"conserving steps, {CHOSEN} 1e-06"),
    (SWING, {"tolerance": 1e-6, "order": 4}, f"conserving steps of order 4, {CHOSEN} 1e-06"),
    (
        SWING,
        {"order": 4},
        "conserving steps of order 4, of at most 0.01 s, by symmetric compositions",
    ),
    (
        BRAKED,
        {"order": 4},
        "conserving steps of order 4, of at most 0.01 s, by weighted covers, since 'brake' takes "
        "energy out",
    ),
    (
        BRAKED_BY_FORMULA,
        {"order": 4},
        "conserving steps of order 4, of at most 0.01 s, by weighted covers, since 'brake' takes "
        "energy out",
    ),
    (
        RUBBED,
        {"order": 6},
        "conserving steps of order 6, of at most 0.01 s, by weighted covers where 'brake' and "
        "1 other take energy out or parts touch or rub, elsewhere by symmetric compositions",
    ),
    (
        READ,
        {"order": 8},
        "conserving steps of order 8, of at most 0.01 s, by weighted covers, since 'brake' takes "
        "energy out and formulas read the motion",
    ),
    (BRAKED, {"order": 2}, "conserving steps of order 2, of at most 0.01 s"),
    (BRAKED, {"order": 4, "tolerance": 1e-6}, f"conserving steps of order 4, {CHOSEN} 1e-06"),
    (SWING, {"step_size": 0.002}, "conserving steps of order 2, of at most 0.002 s"),
    (SWING, {"method": "fastest"}, f"conserving steps, {EXPLICIT}, {CHOSEN} 0.0001"),
    (
        SWING,
        {"method": "fastest", "tolerance": 1e-9, "order": 8},
        f"conserving steps of order 8, {EXPLICIT}, {CHOSEN} 1e-09",
    ),
    (
        SWING,
        {"method": "fastest", "tolerance": 1e-6, "order": 4},
        f"conserving steps of order 4, {CHOSEN} 1e-06",
    ),
    (
        SWING,
        {"method": "fastest", "step_size": 0.01, "order": 8},
        "conserving steps of order 8, of at most 0.01 s, by symmetric compositions",
    ),
    (KINKED, {"method": "fastest"}, f"conserving steps, {CHOSEN} 0.0001"),
    (BALL, {"method": "fastest"}, f"conserving steps, {EXPLICIT}, {CHOSEN} 0.0001"),
    (
        BALL,
        {"contact_mode": "stepped", "tolerance": 1e-5},
        "conserving steps of order 2, of at most 0.01 s: "
        "contact_mode stepped takes equal steps, whatever the tolerance",
    ),
]


def ran(fmu: Instance) -> tuple[bool, set[float]]:
    """Whether some steps were explicit, and the orders of the last step before each point."""
    seen = []
    for k in range(20):
        assert fmu.step(0.05 * k, 0.05), fmu.log
        seen.append([fmu.get("solver.method_in_use"), fmu.get("solver.order_in_use")])
    methods, orders = np.array(seen).T
    return bool((methods > 1.0).any()), set(orders)


@pytest.mark.parametrize(("text", "settings", "words"), CASES)
@pytest.mark.parametrize("kind", ["python", "native", "fmi 3"])
def test_the_log_tells_the_steps_that_run(kind, text, settings, words):
    model = solver.assemble(solver.loads(text))
    path = native_fmu(model, 3) if kind == "fmi 3" else text_fmu(text, native=kind == "native")
    with instance(path) as fmu:
        fmu.initialise(**{f"solver__{name}": value for name, value in settings.items()})
        assert fmu.log == [(0, "logAll", f"solver: {words}")]
        is_explicit, orders = ran(fmu)
        assert is_explicit == ("explicit" in words)
        if "of order" in words:
            assert orders == {float(words.partition("of order ")[2].partition(",")[0].split()[0])}


@pytest.mark.parametrize(("text", "settings", "words"), CASES)
def test_info_and_the_page_tell_what_the_log_tells(text, settings, words):
    lines = [
        f'{name} = "{x}"' if isinstance(x, str) else f"{name} = {x}" for name, x in settings.items()
    ]
    model = solver.assemble(solver.loads("\n".join([text, "[solver]", *lines])))
    assert Integrator(model).steps() == words
    assert solved(model, self_check(model)).endswith(f"solved in {words}.")


def test_info_prints_it(capsys, tmp_path):
    path = tmp_path / "swing.toml"
    path.write_text(SWING, encoding="utf-8")
    code, out, _ = run(capsys, "info", str(path), "--set", "solver.tolerance=1e-5")
    assert code == 0
    assert f"conserving steps, {CHOSEN} 1e-05" in out


@pytest.mark.parametrize("native", [False, True], ids=["python", "native"])
def test_the_tolerance_told_is_that_of_the_host_where_it_is_tighter(native):
    for asked, told in ((1e-2, "0.0001"), (1e-7, "1e-07")):
        with instance(text_fmu(SWING, native=native)) as fmu:
            fmu.fmu.setupExperiment(tolerance=asked)
            fmu.fmu.enterInitializationMode()
            fmu.fmu.exitInitializationMode()
            assert fmu.log[-1] == (0, "logAll", f"solver: conserving steps, {CHOSEN} {told}")


def test_without_logging_it_is_not_told():
    with instance(text_fmu(SWING), logging=False) as fmu:
        fmu.initialise()
        assert fmu.log == []
