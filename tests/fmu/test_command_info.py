"""`holonom info`: what a mechanism consists of, how it can move, and where it comes to rest."""

from __future__ import annotations

import json
import re

import pytest

import solver
from build_fmu.commands.info import FORCES
from solver.scene.scene import TYPES
from tests.fmu.test_archive import repack
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

DOUBLE_ROD = """
name = "double_rod"
dimension = 2
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1 }
[joints]
one = { type = "distance", points = ["O", "A"] }
two = { type = "distance", points = ["O", "A"] }
"""

UNEVEN_BEAM = """
name = "uneven_beam"
dimension = 2
gravity = [0, -10]
[bodies]
beam = { position = [1, 0], mass = 6.0, inertia = 2.0, points = { left = [-1, 0], right = [2, 0] } }
[joints]
pin = { type = "revolute", bodies = ["ground", "beam"], position = [0, 0] }
roller = { type = "point_on_line", point = "beam.right", axis = [1, 0] }
"""


def info(capsys, target, *arguments) -> dict:
    code, out, err = run(capsys, "info", target, "--json", *arguments)
    assert (code, err) == (0, "")
    return json.loads(out)


def lines(capsys, target, *arguments) -> dict[str, str]:
    """Rows of the first table, by their first column."""
    code, out, _ = run(capsys, "info", target, *arguments)
    assert code == 0
    table = out.partition("\n\n")[2].partition("\n\n")[0]
    rows = (re.split(r"\s{2,}", line, maxsplit=1) for line in table.splitlines())
    return {name: text.strip() for name, text in rows}


# -------------------------------------------------------------------------------------- counts


def test_info_shows_the_energy_that_each_cause_takes_as_check_does(capsys):
    scene = SCENES / "falling_rod.toml"
    taken = json.loads(run(capsys, "info", scene, "--json")[1])["taken"]
    assert (taken.pop("duration"), taken.pop("reason")) == (1.0, "")
    checked = json.loads(run(capsys, "check", scene, "--json")[1])["taken"]
    assert taken == pytest.approx(checked, rel=1e-12)
    assert taken["impact"] > 7.0
    assert "J by impact; in a run of 1 s" in lines(capsys, scene)["energy taken out"]


def test_info_says_the_same_of_a_scene_and_its_fmu(capsys):
    code, out, _ = run(capsys, "info", SCENES / "four_bar.toml", "--json")
    of_fmu = json.loads(run(capsys, "info", scene_fmu("four_bar"), "--json")[1])
    document = json.loads(out)
    assert code == 0
    assert of_fmu.pop("package")["kind"] == "Python, by pythonfmu"
    assert of_fmu == document
    assert document["bodies"] == ["crank0", "crank1", "crank2", "coupler0", "coupler1"]
    assert (document["coordinates"], document["rows"]) == (6, 5)
    assert (document["degrees_of_freedom"], document["redundant_rows"]) == (1, 0)


def test_a_step_has_three_unknowns_of_a_turn_in_place_of_nine_directors_and_six_rows(capsys):
    # Five bodies; the model's counts are those of their directors.
    step = info(capsys, SCENES / "bricard.toml")["step"]
    model = solver.assemble(solver.load(SCENES / "bricard.toml"))
    sizes = model.sizes
    assert [step[key] for key in ("coordinates", "turns", "multipliers")] == [15, 15, 30]
    assert (3 * sizes["n_free"], sizes["n_rows"]) == (60, 60)
    assert len(model.tables["lu_ptr"]) == 15 + 15 + 30 + 1


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("bricard", "multipliers follow before Newton's iteration ends"),
        ("pile_of_discs", "multipliers follow before Newton's iteration ends"),
        (
            "cam_and_follower",
            "multipliers follow before Newton's iteration ends while all contacts of their part "
            "are open, else they are held",
        ),
    ],
)
def test_it_says_where_multipliers_follow_early(capsys, name, words):
    code, out, _ = run(capsys, "info", SCENES / f"{name}.toml")
    assert code == 0
    assert words in " ".join(out.split())


def test_redundant_rows_are_counted_and_their_joints_named(capsys, tmp_path):
    scene = tmp_path / "double_rod.toml"
    scene.write_text(DOUBLE_ROD)
    table = lines(capsys, scene)
    assert table["redundant rows"].startswith("1  among those of joint 'one', joint 'two' (")
    assert table["mobility"] == "1 by rank, 0 by counting (Kutzbach), without drivers"
    assert table["degrees of freedom"] == "1"


def test_the_grid_of_a_mesh_and_its_errors_are_told_of_a_scene_and_its_fmu(capsys, tmp_path):
    """The same by both, which needs no library for an FMU; large errors are told at the build."""
    target = SCENES / "die_in_a_bowl.toml"
    found = info(capsys, target)["meshes"]["bowl"]
    assert found == info(capsys, scene_fmu("die_in_a_bowl"))["meshes"]["bowl"]
    assert (found["file"], found["triangles"], found["points"]) == ("bowl.obj", 800, 12)
    assert (found["cells"], found["resolution"]) == ([34, 34, 12], 0.024)
    assert 0.0 < found["mean_error"] < found["largest_error"] < 0.3 * found["resolution"]
    row = lines(capsys, target)["mesh of bowl"]
    assert row.startswith(
        "bowl.obj, 800 triangles; 34 x 34 x 12 cells of 0.024 m; distances to 5.9e"
    )
    settings = "--set", "contacts.bowl.resolution=0.06", "--set", "experiment.stop_time=0.02"
    _, _, err = run(capsys, "build", target, "-o", tmp_path / "a.fmu", *settings)
    assert "contact 'bowl': distances to the mesh 'bowl.obj' are up to" in err


@pytest.mark.parametrize(
    ("name", "drivers", "motions"),
    [("stewart", [f"drive{i}" for i in range(1, 7)], 6), ("double_wishbone", ["profile"], 3)],
)
def test_drivers_are_named_whether_they_move_joints_or_points(capsys, name, drivers, motions):
    found = info(capsys, SCENES / f"{name}.toml")
    assert (found["drivers"], found["prescribed_motions"]) == (drivers, motions)


def test_an_fmu_of_an_earlier_format_is_not_read_as_one_of_this(capsys, tmp_path):
    def earlier(path, data):
        return path, data.replace(b'"format":3', b'"format":2')[
            :-4
        ] if "model.bin" in path else data

    old = repack(scene_fmu("four_bar"), tmp_path / "old.fmu", earlier)
    code, out, err = run(capsys, "info", old)
    assert (code, out) == (2, "")
    assert "of an earlier version" in err


# --------------------------------------------------------------------------------- equilibrium


def test_a_mass_comes_to_rest_where_its_spring_carries_it(capsys):
    # m g = 19.62 N stretches 200 N/m by 0.0981 m; the search stops at 1e-10 of the mechanism.
    for target in (SCENES / "spring_pendulum.toml", scene_fmu("spring_pendulum")):
        found = info(capsys, target, "--equilibrium")
        assert found["positions"]["A"] == pytest.approx({"x": 0, "y": 0, "z": -0.9981}, abs=1e-9)
        spring = {"length": 0.9981, "force": 19.62}
        assert found["forces"]["spring"] == pytest.approx(spring, abs=1e-7)
        assert found["outputs"] == pytest.approx({"stretch": 0.0981}, abs=1e-9)
        assert not found["held"]


def test_the_supports_of_a_beam_share_its_weight_by_the_lever(capsys, tmp_path):
    # 60 N at a third of the way from the pin to the roller.
    scene = tmp_path / "beam.toml"
    scene.write_text(UNEVEN_BEAM)
    found = info(capsys, scene, "--equilibrium")["reactions"]
    assert found["pin"] == pytest.approx({"force.x": 0, "force.y": 40}, abs=1e-9)
    assert found["roller"] == pytest.approx({"force.x": 0, "force.y": 20}, abs=1e-9)


def test_reactions_that_are_not_unique_are_said_to_be(capsys, tmp_path):
    scene = tmp_path / "double_rod.toml"
    scene.write_text(DOUBLE_ROD)
    out = run(capsys, "info", scene, "--equilibrium")[1]
    assert "\nreactions, not unique in joint 'one', joint 'two'\n" in out


def test_a_driver_that_moves_is_held_where_it_is_at_the_start(capsys):
    found = info(capsys, SCENES / "car_axis.toml", "--equilibrium")
    assert found["held"]
    out = run(capsys, "info", SCENES / "car_axis.toml", "--equilibrium")[1]
    assert "drivers are held" in out.splitlines()[0]


def test_the_tables_have_units_and_show_rounding_as_zero(capsys):
    code, out, _ = run(capsys, "info", SCENES / "flyball_governor.toml", "--equilibrium")
    assert code == 0
    rows = [line.split() for line in out.splitlines()]
    assert next(row[:2] for row in rows if "[N]" in row and "torque.x" in row) == ["force.x", "[N]"]
    guide = next(row for row in rows if row[:1] == ["guide"] and len(row) == 7)
    assert set(guide[1:]) == {"0"}


def test_where_nothing_comes_to_rest_the_end_is_3_and_a_sentence(capsys):
    code, out, err = run(capsys, "info", SCENES / "screw_jack.toml", "--equilibrium", "--json")
    assert (code, out) == (3, "")
    assert err.startswith("holonom: screw_jack: no static equilibrium was found")
    assert err.count("\n") == 1


HUNG = """
name = "hung"
dimension = 2
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = 1 }
B = { position = [2, 0], mass = 1 }
[joints]
upper = { type = "distance", points = ["O", "A"] }
[forces]
hang = { type = "spring", points = ["ground", "B"], at = [[2, 1], [2, 0]], stiffness = 10.0 }
hold = { type = "damper", points = ["ground", "B"], at = [[3, 1], [2, 0]], damping = 10.0 }
"""


def test_what_is_fixed_names_the_places_that_no_table_of_points_has(capsys, tmp_path):
    """An FMU does not know which of its fixed places were points of the scene."""
    scene = tmp_path / "hung.toml"
    scene.write_text(HUNG)
    _, out, _ = run(capsys, "info", scene)
    points = "points 2 moving (origins of bodies count), 3 fixed (fixed points, and places where"
    assert points in " ".join(out.split())


def test_formulas_of_constraints_and_rows_of_the_mechanism_are_told_apart(capsys):
    table = lines(capsys, SCENES / "four_bar.toml")
    assert table["constraint formulas"] == "0"
    assert table["constraint rows"].endswith("of bodies, joints, drivers and formulas")


# -------------------------------------------------------------------------------------- forces

FORCED = """
name = "forced"
dimension = 2
[points]
P = { position = [2, 0], mass = 1 }
[bodies]
arm = { position = [0, 0], mass = 1, inertia = 1 }
[joints]
pin = { type = "revolute", bodies = ["ground", "arm"], position = [0, 0] }
[forces]
"""
OF_TYPES = {
    "spring": 'points = ["P", "arm"], stiffness = 0.0',
    "damper": 'points = ["P", "arm"], damping = 0.0',
    "torsion_spring": 'joint = "pin", stiffness = 0.0',
    "torsion_damper": 'joint = "pin", damping = 0.0',
    "joint_torque": 'joint = "pin", value = 0.0',
    "torque": 'body = "arm", value = 0.0',
    "force": 'point = "P", value = [0, 0]',
    "potential": 'value = "P.x**2"',
    "gravitation": 'points = ["P", "arm"], constant = 1.0',
    "actuator": 'joint = "pin", value = 0.0',
}


def test_every_type_of_force_has_its_row():
    assert {*OF_TYPES} == {*TYPES["forces"]}
    assert sorted(word for types in FORCES.values() for word in types) == sorted(OF_TYPES)


@pytest.mark.parametrize("word", OF_TYPES)
def test_a_force_is_counted_as_what_it_is(capsys, tmp_path, word):
    """Also where its numbers are 0 at the start."""
    scene = tmp_path / "forced.toml"
    scene.write_text(f'{FORCED}one = {{ type = "{word}", {OF_TYPES[word]} }}\n')
    table = lines(capsys, scene)
    for kind, types in FORCES.items():
        assert table[kind] == ("1  one" if word in types else "0")
    assert info(capsys, scene)["forces"] == {word: ["one"]}


def test_what_has_a_power_on_demand_is_no_driver(capsys, tmp_path):
    scene = tmp_path / "forced.toml"
    text = FORCED.replace("position = [0, 0] }\n[forces]", "position = [0, 0], {} }}\n[forces]")
    text = text.replace("{} }}", "friction = { preload = 1, radius = 1 } }")
    one = 'one = { type = "torsion_damper", joint = "pin", damping = 1 }\n'
    scene.write_text(f'{text}{one}[outputs]\nlost = {{ value = "one.power + pin.power" }}\n')
    assert info(capsys, scene)["drivers"] == []


def test_springs_and_dampers_of_joints_are_counted_with_those_of_forces(capsys, tmp_path):
    scene = tmp_path / "forced.toml"
    text = FORCED.replace("position = [0, 0] }\n[forces]", "position = [0, 0], {} }}\n[forces]")
    scene.write_text(text.replace("{} }}", "stiffness = 1, damping = 2 }"))
    table = lines(capsys, scene)
    assert table["springs"] == "1  pin.spring"
    assert table["dampers"] == "1  pin.damper"
    assert info(capsys, scene)["forces"] == {
        "torsion_spring": ["pin.spring"],
        "torsion_damper": ["pin.damper"],
    }


def test_the_mechanism_comes_first_and_the_solver_last(capsys):
    out = run(capsys, "info", SCENES / "four_bar.toml")[1]
    names = [
        line.split()[0] for line in out.partition("meaning")[2].splitlines()[2:] if line[:1].strip()
    ]
    solvers = [name.startswith("solver.") for name in names]
    assert solvers == sorted(solvers)
    assert any(solvers)


# ------------------------------------------------------------------------------------ friction

RUBBING = """
name = "rubbing"
dimension = 2
[parameters]
c = 1.5
[points]
A = { position = [0, 0], mass = 1, velocity = [1, 0] }
[bodies]
arm = { position = [3, 0], mass = 1, inertia = 1 }
[joints]
pin = { type = "revolute", bodies = ["ground", "arm"], position = [3, 0] }
[forces]
drag = { type = "force", point = "A", value = ["-(0.5*c if A.vx > 0 else -0.5*c)", "-A.vy"] }
brake = { type = "joint_torque", joint = "pin", value = "0.2 - 2*sign(pin.angular_velocity)" }
push = { type = "force", point = "A", value = [0, "0.25*sign(A.vy)"] }
motor = { type = "actuator", joint = "pin", value = 1, ratio = 2, efficiency = 0.8 }
"""
RUBS = [
    "force 'drag': the sign of A.vx is friction, which holds up to 0.75 N where A.vx is 0",
    "force 'brake': the sign of pin.angular_velocity is friction, which holds up to 2 N.m where "
    "pin.angular_velocity is 0",
    "force 'motor': its gear is friction, which holds up to 0.45 N.m at the start",
]


def test_forces_whose_sign_of_a_rate_became_friction_are_named(capsys, tmp_path):
    """One that pushes along its rate is left to switch."""
    scene, fmu = tmp_path / "rubbing.toml", tmp_path / "rubbing.fmu"
    scene.write_text(RUBBING)
    assert run(capsys, "build", scene, "-o", fmu)[0] == 0
    for target in (scene, fmu):
        document = json.loads(run(capsys, "info", target, "--json")[1])
        assert document["rubbing"] == RUBS
        assert document["switches"] == ["force 'push': sign(A.vy)"]
    out = " ".join(run(capsys, "info", scene)[1].split())
    assert all(f" friction {told}" in out for told in RUBS)


def test_friction_of_joints_is_no_sign_of_a_force(capsys):
    document = json.loads(run(capsys, "info", SCENES / "belt_and_block.toml", "--json")[1])
    assert document["rubbing"] == []
