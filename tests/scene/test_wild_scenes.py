"""Random damage to scenes: whatever is written is read or reported, never a traceback."""

import json
import sys

from hypothesis import given
from hypothesis import strategies as st

from solver.scene import SceneError, loads
from tests.nested_data import paths_of
from tests.scene_files import ALL

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TEXTS = [path.read_text(encoding="utf-8") for path in ALL]


def report_of(text, **options):
    """Report of the mistakes in a text; None where there are none."""
    try:
        loads(text, **options)
    except SceneError as error:
        return str(error)
    return None


wild = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.sampled_from(["A", "length", "t", "ground", "1/0", "sin(", "", "x.y.z", "distance(A, O)"]),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["type", "points", "value", "A", "x y"]), inner)
    ),
    max_leaves=5,
)


def replaced(data, path, value):
    """Copy nested data with one value changed."""
    if not path:
        return value
    copied = dict(data) if isinstance(data, dict) else list(data)
    copied[path[0]] = replaced(data[path[0]], path[1:], value)
    return copied


@given(st.data())
def test_whatever_is_written_is_read_or_reported(choice):
    """No mistake, however odd, ends in anything but a scene or a report."""
    data = tomllib.loads(choice.draw(st.sampled_from(TEXTS)))
    for _ in range(choice.draw(st.integers(1, 3))):
        path = choice.draw(st.sampled_from([place for place, _ in paths_of(data)]))
        data = replaced(data, path, choice.draw(wild))
    report = report_of(json.dumps(data), format="json", name="wild.json")
    assert report is None or report.startswith("wild.json:")


@given(st.data())
def test_a_damaged_toml_text_is_read_or_reported(choice):
    text = choice.draw(st.sampled_from(TEXTS))
    start = choice.draw(st.integers(0, len(text)))
    end = choice.draw(st.integers(start, min(start + 12, len(text))))
    damaged = text[:start] + choice.draw(st.text("[]{}=\"'#.,\n aA0", max_size=3)) + text[end:]
    report = report_of(damaged)
    assert report is None or report.startswith("scene.toml:")
