"""Every mistake has its report: a file of bad scenes, each with the expected text beside it."""

from pathlib import Path

import pytest

from solver.mechanics import assemble
from solver.scene import SceneError, load, loads

FOLDER = Path(__file__).parents[1] / "bad_scenes"
NAMES = sorted(path.stem for path in FOLDER.glob("*.toml"))


@pytest.fixture(autouse=True)
def _within_the_folder(monkeypatch):
    monkeypatch.chdir(FOLDER)  # a report names the file as the user did


@pytest.mark.parametrize("name", NAMES)
def test_a_bad_scene_is_reported_as_expected(name):
    with pytest.raises(SceneError) as caught:
        assemble(load(f"{name}.toml"))
    assert str(caught.value) + "\n" == Path(f"{name}.txt").read_text(encoding="utf-8")


def test_every_report_belongs_to_a_scene_and_there_are_many():
    assert sorted(path.stem for path in FOLDER.glob("*.txt")) == NAMES
    assert len(NAMES) >= 140


def test_all_mistakes_of_a_file_are_reported_in_one_run():
    with pytest.raises(SceneError) as caught:
        load("several_mistakes.toml")
    problems = caught.value.problems
    lines = [problem.line for problem in problems]
    assert lines == sorted(lines)
    assert set(lines) == {4, 7, 8, 11, 12, 13, 16, 17, 20, 23, 26}


def test_correcting_one_mistake_leaves_exactly_the_others():
    """No report hides another: each correction removes its own lines and adds none."""
    text = Path("several_mistakes.toml").read_text(encoding="utf-8")

    def reported(text: str) -> set[tuple[str, str]]:
        with pytest.raises(SceneError) as caught:
            loads(text)
        return {(problem.location, problem.message) for problem in caught.value.problems}

    before = reported(text)
    for wrong, right in [
        ("gravity = [0, 0, -9.81]", "gravity = [0, -9.81]"),
        ("minimum", "min"),
        ('"lenght"', '"length"'),
        ("fixed = 1", "fixed = true"),
        ("order = 3", "order = 2"),
        ("stop_time = -1.0", "stop_time = 1.0"),
        ('"1 +"', '"1 + 1"'),
    ]:
        after = reported(text.replace(wrong, right))
        assert after < before
        assert len(after) == len(before) - 1
