"""The guide to scenes says what happens: its examples are read, its report is the real one."""

import re
import sys
import textwrap
from pathlib import Path

import pytest

from solver import simulate
from solver.scene import SceneError, SolverSettings, loads
from solver.scene.expression import FUNCTIONS
from solver.scene.names import RESERVED
from solver.scene.scene import TYPES

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "scene.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^```toml\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE)
FIRST, *PIECES = EXAMPLES
SPATIAL = next(k for k, example in enumerate(EXAMPLES) if k and example.startswith("name"))
BEHIND = 1 + next(k for k, example in enumerate(EXAMPLES) if example.startswith("[drivers]"))
"""The scene in space, and the first example that does not belong to it."""


@pytest.fixture(autouse=True)
def _among_the_meshes(monkeypatch):
    monkeypatch.chdir(ROOT / "scenes")


def test_the_first_scene_is_complete():
    assert loads(FIRST).name == "pendulum"


def test_the_scene_in_space_is_complete_with_all_that_follows_it():
    scene = loads("".join(EXAMPLES[SPATIAL:BEHIND]))
    assert scene.dimension == 3
    assert scene.warnings == ()
    assert scene.joints["shoulder"].on == ("column.top", "arm.root")
    assert scene.constraints
    assert scene.contacts
    assert scene.forces
    assert scene.drivers


@pytest.mark.parametrize("piece", PIECES, ids=lambda piece: piece.splitlines()[0])
def test_every_other_example_fits_the_first_scene(piece):
    if piece not in EXAMPLES[SPATIAL:BEHIND]:
        loads(FIRST + piece)


@pytest.mark.parametrize(("table", "types"), TYPES.items())
def test_every_type_is_in_the_tables_and_has_an_example(table, types):
    scene = tomllib.loads("".join(EXAMPLES[SPATIAL:BEHIND]))
    scenes = scene, *(tomllib.loads(piece) for piece in EXAMPLES[BEHIND:] if table in piece)
    shown = {part.get("type", "rigid") for x in scenes for part in x.get(table, {}).values()}
    assert set(types) - shown <= {"bar"}
    for name in set(types) - {"rigid"}:
        assert f"`{name}`" in GUIDE or f'`type = "{name}"`' in GUIDE


def test_the_solver_settings_shown_are_the_defaults():
    (piece,) = [piece for piece in PIECES if piece.startswith("[solver]")]
    assert loads(FIRST + piece).solver == SolverSettings()


def test_the_report_shown_is_what_these_mistakes_get():
    wrong = FIRST.replace("mass", "mas").replace('["O", "A"]', '["O", "B"]')
    with pytest.raises(SceneError) as caught:
        loads(wrong, name="pendulum.toml")
    assert textwrap.indent(str(caught.value), "    ") in GUIDE


def test_the_warning_shown_is_what_this_place_gets():
    beside = """
        name = "swing"
        dimension = 2
        gravity = [0, -9.81]

        [bodies.arm]
        position = [0.5, 0]
        mass = 1.0
        inertia = 0.1
        points = { tip = [0.5, 0] }

        [joints]
        pin = { type = "revolute", bodies = ["ground", "arm"], position = [1.02, 0] }
        """
    (sentence,) = loads(textwrap.dedent(beside).lstrip(), name="swing.toml").sentences()
    assert textwrap.indent(sentence, "    ") in GUIDE


def test_the_python_example_runs(monkeypatch):
    monkeypatch.chdir(ROOT)
    (code,) = re.findall(r"^```python\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE)
    names = {}
    exec(code, names)
    assert names["scene"].parameters["length"].value == 2.0


def test_every_function_and_reserved_name_is_mentioned():
    functions = GUIDE.partition("| functions | `")[2].partition("`")[0]
    assert functions.split() == list(FUNCTIONS)
    for name, meaning in RESERVED.items():
        if not meaning.startswith(("the function", "the language")):
            assert f"`{name}`" in GUIDE


def test_the_imu_shown_begins_with_the_numbers_beside_it():
    (piece,) = [piece for piece in PIECES if "[sensors]" in piece]
    shown = re.findall(r"`imu\.(\w+)` = (-?[\d.]+) ", GUIDE)
    assert [word for word, _ in shown] == ["fx", "fy", "w"]
    found = simulate(loads(FIRST + piece), stop_time=0.1)
    for word, number in shown:
        assert found[f"imu.{word}"][0] == pytest.approx(float(number), abs=1e-9)
    assert found["fold.angular_velocity"] == pytest.approx(3.0, abs=1e-9)
