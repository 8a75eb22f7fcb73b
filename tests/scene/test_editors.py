"""What helps to write a scene: its schema, a scene to begin with, a check at each save."""

from __future__ import annotations

import contextlib
import json
import os
from pathlib import Path
from types import SimpleNamespace

import pytest

from build_fmu.commands import watch
from solver.scene import json_schema, load, loads
from solver.scene.fields import Quantity
from tests.support.fmus.commands import run

ROOT = Path(__file__).parents[2]
SCENES = sorted([*ROOT.glob("scenes/*.toml"), *ROOT.glob("examples/*.toml")])
GOOD = (ROOT / "scenes" / "double_pendulum.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_every_scene_begins_with_its_schema_which_lies_there(scene):
    word, file = scene.read_text(encoding="utf-8").splitlines()[0].split()
    assert word == "#:schema"
    assert json.loads((scene.parent / file).read_text(encoding="utf-8")) == json_schema()


def test_every_field_of_the_schema_has_a_description():
    schema = json_schema()
    parts = {"": schema, **schema["$defs"]}
    silent = [
        f"{part}.{name}"
        for part, about in parts.items()
        for name, field in about["properties"].items()
        if field.get("description", "") in ("", Quantity().form()["description"])
    ]
    assert silent == []
    assert all(part["description"] for part in parts.values())


def test_the_command_schema_writes_the_schema(capsys, tmp_path):
    code, out, _ = run(capsys, "schema")
    assert (code, json.loads(out)) == (0, json_schema())
    file = tmp_path / "a.json"
    assert run(capsys, "schema", "-o", file) == (0, f"{file}: the schema of scenes\n", "")
    assert file.read_text(encoding="utf-8") == out


# ---------------------------------------------------------------------------------------- init


def test_init_writes_a_scene_like_another_with_its_comments_and_the_schema(capsys, tmp_path):
    code, out, err = run(capsys, "init", tmp_path / "press", "--like", "slider_crank")
    assert (code, err) == (0, "")
    assert "press.toml: a scene like slider_crank; try: holonom check" in out
    text = (tmp_path / "press.toml").read_text(encoding="utf-8")
    assert text.startswith("#:schema ./scene.schema.json\n# Slider-crank whose crank")
    assert json.loads((tmp_path / "scene.schema.json").read_text("utf-8")) == json_schema()
    scene, like = load(tmp_path / "press.toml"), load(ROOT / "scenes" / "slider_crank.toml")
    assert scene.name == "press"
    assert (scene.bodies, scene.joints) == (like.bodies, like.joints)


def test_init_keeps_a_schema_that_is_there(capsys, tmp_path):
    (tmp_path / "scene.schema.json").write_text("mine")
    assert run(capsys, "init", tmp_path / "a")[0] == 0
    assert (tmp_path / "scene.schema.json").read_text() == "mine"


def test_init_refuses_a_file_that_is_there_and_changes_nothing(capsys, tmp_path):
    (tmp_path / "a.toml").write_text("mine")
    code, out, err = run(capsys, "init", tmp_path / "a")
    assert (code, out) == (2, "")
    assert "a.toml: there is such a file already; choose another name or remove it" in err
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a.toml", "mine")]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("a", "--like", "slidercrank"), "did you mean 'slider_crank'?"),
        (("a", "--like", "zebra"), "scenes are andrews, "),
        (("a", "--like", "zebra"), " cam_and_follower, "),  # a profile is no file
        (("a", "--like", "die_in_a_bowl"), "there is no such scene"),  # it needs two meshes
        (("2 arms",), "'2 arms' cannot be the name of a scene; write letters"),
    ],
)
def test_init_refuses_a_wrong_name_with_those_there_are(
    capsys, monkeypatch, tmp_path, arguments, sentence
):
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, "init", *arguments)
    assert (code, out) == (2, "")
    assert sentence in err
    assert ("spring_pendulum" in err) == ("--like" in arguments)
    assert list(tmp_path.iterdir()) == []


# --------------------------------------------------------------------------------------- watch


def check(file: Path) -> str:
    return watch.checked(str(file), lambda _: watch.parts_and_model(str(file), {}))


def test_a_check_finds_mistakes_and_says_where_they_are(tmp_path):
    file = tmp_path / "a.toml"
    file.write_text(GOOD, encoding="utf-8")
    assert check(file) == f"{file}: fine"
    file.write_text(GOOD.replace("mass =", "mas ="), encoding="utf-8")
    assert f"{file}:" in check(file)
    assert "did you mean 'mass'?" in check(file)


def test_a_mechanism_that_cannot_be_closed_is_not_fine(tmp_path):
    """Each part is in order; together two rods are too short."""
    file = tmp_path / "a.toml"
    text = """
name = "a"
dimension = 2
solver = { assemble = true }
[points]
A = { position = [0, 0], fixed = true }
B = { position = [2, 0], fixed = true }
C = { position = [1, 0.1], mass = 1 }
[joints]
left = { type = "distance", points = ["A", "C"], length = 0.4 }
right = { type = "distance", points = ["B", "C"], length = 0.4 }
"""
    assert loads(text).warnings == ()
    file.write_text(text, encoding="utf-8")
    assert "fine" not in check(file)
    assert "left" in check(file)


def test_warnings_of_a_scene_are_told_at_each_check(tmp_path):
    file = tmp_path / "a.toml"
    text = GOOD.replace("[parameters]", "[parameters]\nspare = 1.0")
    assert text != GOOD
    file.write_text(text, encoding="utf-8")
    for _ in range(2):
        assert "parameters.spare: nothing depends on it" in check(file)


def test_watch_ends_with_ctrl_c_and_0(capsys, monkeypatch, tmp_path):
    file = tmp_path / "a.toml"
    file.write_text(GOOD, encoding="utf-8")

    def interrupt(_seconds):
        raise KeyboardInterrupt

    monkeypatch.setattr(watch.time, "sleep", interrupt)
    assert run(capsys, "watch", file) == (0, f"{file}: fine\n", "")


def test_what_is_no_scene_cannot_be_watched(capsys, tmp_path):
    code, _, err = run(capsys, "watch", tmp_path / "a.toml")
    assert (code, err) == (2, f"holonom: {tmp_path / 'a.toml'}: no such file\n")


def test_each_save_is_noticed_once_and_a_file_that_is_away_is_waited_for(tmp_path):
    file = tmp_path / "a.toml"
    files = watch.WatchedFiles(str(file))
    assert not files.are_new()
    file.write_text("a")
    assert (files.are_new(), files.are_new()) == (True, False)
    os.utime(file, ns=(1, 1))
    assert (files.are_new(), files.are_new()) == (True, False)
    file.unlink()
    assert not files.are_new()
    file.write_text("a")
    os.utime(file, ns=(1, 1))
    assert not files.are_new()  # it is what it was


@pytest.mark.parametrize("text", ['profile = { file = "data/road.csv" }', "file = 'data/road.csv'"])
@pytest.mark.parametrize("rest", ["", "\n[not toml"])
def test_files_that_a_scene_names_are_watched_too(tmp_path, text, rest):
    file, road = tmp_path / "a.toml", tmp_path / "data" / "road.csv"
    file.write_text(text + rest)
    files = watch.WatchedFiles(str(file))
    assert (files.are_new(), files.are_new()) == (True, False)
    road.parent.mkdir()
    road.write_text("0,0\n1,0\n")
    assert (files.are_new(), files.are_new()) == (True, False)
    road.write_text("0,0\n1,0.5\n")
    assert (files.are_new(), files.are_new()) == (True, False)


def test_a_watched_page_is_renewed_at_each_save_that_is_in_order(monkeypatch, tmp_path):
    """Wrong scenes are said on the page, which goes on with the last one that was in order."""
    from build_fmu.commands import view

    file = tmp_path / "a.toml"
    shown, ended = [], []

    class Page:
        session = SimpleNamespace(say=lambda text: shown.append(text.splitlines()[0]))

        def show(self, session, page):
            shown.append((session, page))

    @contextlib.contextmanager
    def session_of(_target, _entries, warnings):
        watch.parts_and_model(str(file), {})
        number = len(shown)
        yield number, [*warnings]
        ended.append(number)

    @contextlib.contextmanager
    def server_of(session, page, _arguments):
        shown.append((session, page))
        yield Page()
        ended.append("served")

    monkeypatch.setattr(view, "live_session", session_of)
    monkeypatch.setattr(view, "server_of", server_of)
    page = watch.WatchedPage(SimpleNamespace(scene=str(file)))
    wrong = GOOD.replace("mass =", "mas =")
    spare = GOOD.replace("[parameters]", "[parameters]\nspare = 1.0")
    for text in (wrong, GOOD, wrong, spare):
        file.write_text(text, encoding="utf-8")
        watch.checked(str(file), page.renew)
    page.close()
    first, said, (_, warnings) = shown
    assert first == (0, [])
    assert "unknown field" in said
    assert "nothing depends on it" in warnings[0]
    assert ended == [0, "served", 2]
