"""Lines of a scene file: every path of the data has the line where it stands."""

import json
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.scene.mistakes import location_of, path_of
from solver.scene.positions import lines_of, lines_of_json
from tests.support.mechanisms.nested_data import paths_of
from tests.support.mechanisms.scene_files import ALL

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]


TRICKY = """# = [ { "
name = "a # b = {" # c
a.b.c = 1
a . "b.c" = 'its'
[points]
A = { position = [0, # x ]
  [1,
  2],
 ], "q r" = 'x"' , n = { m = 1.0 } }

[ bodies . crank ]
text = \"\"\"a
"b" ] ""\"\"\"
after = '''
''' # three
next = 1979-05-27T07:32:00Z
neg = [-1_000, 0x1F, 1e-3,
  true]
[[arr]]
x = 1
[[arr]]
x = "\\"]"
[arr.sub]
y = 3
[[arr.deep]]
z = []
[[arr.deep]]
z = {}
"""


def test_every_path_of_a_toml_text_has_its_line():
    lines = lines_of(TRICKY, "toml")
    data = tomllib.loads(TRICKY)
    assert set(lines) == {path for path, _ in paths_of(data)}
    text = TRICKY.split("\n")
    for path, line in lines.items():
        if isinstance(path[-1], str):
            assert path[-1] in text[line - 1]
    assert lines["points", "A", "position", 1, 1] == 8
    assert lines["bodies", "crank", "after"] == 14
    assert lines["arr", 1, "deep", 1, "z"] == 28


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_every_path_of_a_scene_has_its_line(path):
    text = path.read_text(encoding="utf-8")
    assert set(lines_of(text, "toml")) == {place for place, _ in paths_of(tomllib.loads(text))}


keys = st.text(st.characters(min_codepoint=32, max_codepoint=0x24F, exclude_categories=["C"]))
trees = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False) | keys,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(keys, inner, max_size=3),
    max_leaves=12,
)


@given(st.dictionaries(keys, trees, max_size=4), st.sampled_from([None, 0, 2]))
def test_every_path_of_a_json_text_has_its_line(data, indent):
    text = json.dumps(data, indent=indent)
    lines, repeated = lines_of_json(text)
    assert set(lines) == {path for path, _ in paths_of(data)}
    assert not repeated
    shown = text.split("\n")
    for path, line in lines.items():
        if isinstance(path[-1], str):
            assert json.dumps(path[-1]) in shown[line - 1]


def test_locations_read_back_as_paths():
    for path in [("points", "A", "position", 0), ("points", "my point", "mass"), ("name",), ()]:
        assert path_of(location_of(path)) == path
