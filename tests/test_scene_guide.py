"""The guide to scenes says what happens: its examples are read, its report is the real one."""

import re
import sys
import textwrap
from pathlib import Path

import pytest

from solver.scene import SceneError, SolverSettings, loads
from solver.scene.names import RESERVED
from solver.scene.operations import FUNCTIONS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]
GUIDE = (ROOT / "docs" / "scene.md").read_text(encoding="utf-8")
FIRST, *PIECES = re.findall(r"^```toml\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE)


def test_the_first_scene_is_complete():
    assert loads(FIRST).name == "pendulum"


@pytest.mark.parametrize("piece", PIECES, ids=lambda piece: piece.splitlines()[0])
def test_every_example_fits_the_first_scene(piece):
    tables = [name for name in tomllib.loads(piece) if name in tomllib.loads(FIRST)]
    assert not tables
    loads(FIRST + piece)


def test_the_solver_settings_shown_are_the_defaults():
    (piece,) = [piece for piece in PIECES if piece.startswith("[solver]")]
    assert loads(FIRST + piece).solver == SolverSettings()


def test_the_report_shown_is_what_these_mistakes_get():
    wrong = FIRST.replace("mass", "mas").replace('["O", "A"]', '["O", "B"]')
    with pytest.raises(SceneError) as caught:
        loads(wrong, name="pendulum.toml")
    assert textwrap.indent(str(caught.value), "    ") in GUIDE


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
