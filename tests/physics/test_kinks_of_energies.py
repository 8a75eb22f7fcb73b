"""Energies with kinks, compliant contacts above all: steps of a tolerance end there.

How near runs come to the right values is asked of the corpus (tests/truth/systems/buffers.py).
"""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import solver
from build_fmu.fmu_runner import FmuRunner
from tests.support.fmus.commands import run
from tests.support.fmus.native_fmus import native_fmu

LAW = 'law = "hunt-crossley", damping = 0.4, stiffness = 2e4'
BALL = f"""
name = "ball"
dimension = 2
gravity = [0, -9.81]
[points]
A = {{ position = [0, 0.1], mass = 1.1 }}
[contacts]
floor = {{ type = "plane", point = "A", axis = [0, 1], {LAW} }}
"""
STOP = """
name = "slider"
dimension = 2
[bodies]
block = { position = [0, 0], velocity = [0.5, 0], mass = 2, inertia = 1 }
[joints]
guide = { type = "prismatic", bodies = ["ground", "block"], axis = [1, 0] }
[contacts]
ends = { type = "stop", joint = "guide", min = -0.05, max = 0.05, law = "hertz", stiffness = 1e6 }
"""
ROPE = """
name = "rope"
dimension = 2
gravity = [0, -9.81]
[points]
O = { position = [0, 0], fixed = true }
A = { position = [0.3, 0.1], velocity = [1.2, 0.8], mass = 0.7 }
[forces]
rope = { type = "spring", points = ["O", "A"], energy = "150*max(length - 0.5, 0)**2" }
well = { type = "potential", value = "2*abs(A.x - 0.1)" }
"""
DAMPED = "pushes, or its damping takes all of its force"


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (BALL, ["contact 'floor' opens or closes", f"contact 'floor' {DAMPED}"]),
        (STOP, [f"contact 'ends' at {end} opens or closes" for end in ("min", "max")]),
        (ROPE, ["force 'rope': max((length - 0.5), 0)", "force 'well': abs((A.x - 0.1))"]),
    ],
    ids=["plane", "stop", "energies"],
)
def test_info_says_where_contacts_open_and_energies_have_kinks(text, names, tmp_path, capsys):
    scene = tmp_path / "scene.toml"
    scene.write_text(text)
    code, out, _ = run(capsys, "info", str(scene))
    assert code == 0
    assert list(solver.assemble(solver.load(scene)).switches) == names
    assert all(name in " ".join(out.split()) for name in names)


def test_a_condition_that_a_law_shares_with_an_energy_is_one_switch():
    law = 'push = { type = "force", point = "A", value = ["0.1*max(A.x - 0.1, 0)", 0] }'
    found = solver.assemble(solver.loads(f"{ROPE}{law}")).switches
    assert found == ("force 'push': max((A.x - 0.1), 0)", "force 'rope': max((length - 0.5), 0)")


def test_equal_steps_go_through_kinks():
    """Slopes of energies are exact there: a pair of half steps for each step, and no more."""
    found = solver.simulate(
        solver.loads(BALL), stop_time=0.5, step_size=0.05, internal_step=0.01,
        outputs=["solver.substeps", "A.y", "energy.error"],
    )  # fmt: skip
    assert np.array_equal(found["solver.substeps"][1:], np.full(10, 10.0))
    assert found["A.y"].min() < 0.0
    assert found["energy.error"].max() < 1e-14


def test_more_compliant_contacts_than_formulas_may_switch_are_followed():
    """Of 70 balls each has the motion of one; the warning of formulas is not for them."""
    one = solver.loads(BALL)
    points = "".join(f"P{k} = {{ position = [{k}, 0.1], mass = 1.1 }}\n" for k in range(1, 70))
    floors = "".join(
        f'f{k} = {{ type = "plane", point = "P{k}", axis = [0, 1], {LAW} }}\n' for k in range(1, 70)
    )
    many = BALL.replace("[contacts]\n", f"{points}[contacts]\n{floors}")
    settings = {"stop_time": 0.2, "step_size": 0.2, "tolerance": 1e-6}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = solver.simulate(solver.loads(many), outputs=["P69.vy"], **settings)
    alone = solver.simulate(one, outputs=["A.vy"], **settings)
    assert found["P69.vy"][-1] == pytest.approx(alone["A.vy"][-1], abs=6e-6)


def test_a_mesh_ends_steps_at_kinks_and_gives_the_same_bits_again():
    settings = {"stop_time": 0.5, "step_size": 0.05}
    model = solver.assemble(solver.loads(BALL))
    first = solver.simulate(model, record_mesh=True, tolerance=1e-6, **settings)
    again = solver.simulate(model, mesh=first.mesh, **settings)
    assert first == solver.simulate(model, tolerance=1e-6, **settings)
    assert np.array_equal(first["A.y"], again["A.y"])
    assert np.array_equal(first["A.vy"], again["A.vy"])


def test_a_native_fmu_ends_its_steps_there_too():
    """To the last bit the run of the core, which a step through the kink would not give."""
    model = solver.assemble(solver.loads(BALL))
    times = [0.02 * k for k in range(26)]
    names = ["A.y", "A.vy", "floor.force", "solver.newton_iterations"]
    fmu = FmuRunner(native_fmu(model))
    found = fmu.run({"solver.tolerance": 1e-6}, times, names)
    fmu.close()
    assert found.reason == ""
    core = solver.simulate(model, stop_time=0.5, step_size=0.02, outputs=names, tolerance=1e-6)
    assert np.array_equal(np.array(found.values), core.table)


@pytest.mark.parametrize("tolerance", [1e-9, 1e-5])
def test_a_switch_is_met_in_few_steps(tolerance):
    """The speed of a thrown ball is a line: 1.1 m/s is where a line leads, and no halving."""
    text = BALL.split("[contacts]")[0].replace("mass", "velocity = [1, 2], mass")
    law = '[forces]\nf = { type = "force", point = "A", value = ["3.3*(A.vy > 1.1)", 0] }'
    found = solver.simulate(
        solver.loads(text + law), stop_time=0.5, step_size=0.5, tolerance=tolerance,
        outputs=["A.vx", "solver.newton_iterations"],
    )  # fmt: skip
    assert found["A.vx"][-1] == pytest.approx(1 + 3 * 0.9 / 9.81, abs=1e-14)
    assert found["solver.newton_iterations"][-1] < 100
