"""What a browser shows of a page: where things are drawn, what keys do, what faults say."""

from __future__ import annotations

import base64
import io
import math
import re
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest

import solver
from build_fmu.command_line import main
from build_fmu.export import build_archive
from tests.viewer.conftest import ROOT, WITHOUT_WEBGL, axe_findings, scene
from viewer.report import ReportRun, page_text

PENDULUM_POINTS = ("A.x", "A.y", "B.x", "B.y")


def picture(page) -> np.ndarray:
    """Pixels of the stage, from the function that saves it."""
    image = pytest.importorskip("PIL.Image", reason="needs the extra 'browser'")
    data = base64.b64decode(page.evaluate("holonom.picture().split(',')[1]"))
    return np.asarray(image.open(io.BytesIO(data)).convert("RGB")).astype(int)


def filled(page) -> float:
    """Part of the stage that has another colour than its ground."""
    pixels = picture(page)
    return float((abs(pixels - pixels[0, 0]).max(axis=2) > 24).mean())


def value(page, text: str):
    return page.evaluate(text)


def test_a_page_makes_one_request_and_says_nothing_to_the_console(pendulum, look):
    page = look(pendulum[1])
    assert page.said == []
    assert [url.split(":")[0] for url in page.asked if not url.startswith("data:")] == ["file"]


@pytest.mark.parametrize("time", [0.0, 3.36, 9.98])
def test_points_are_drawn_where_they_are(pendulum, look, time):
    trajectory, path = pendulum
    page = look(path)
    page.evaluate("t => holonom.seek(t)", time)
    drawn = page.evaluate("holonom.stage.shown[0].positions.slice(1).flatMap(p => [p.x, p.y])")
    exact = [np.interp(time, trajectory.t, trajectory[name]) for name in PENDULUM_POINTS]
    assert drawn == pytest.approx(exact, abs=2e-3)
    a, b = np.reshape(drawn, (2, 2))
    assert np.linalg.norm(a) == pytest.approx(1.0, abs=2e-4)
    assert np.linalg.norm(a - b) == pytest.approx(1.0, abs=2e-4)


def test_a_body_without_a_shape_is_as_large_as_what_holds_it(look, tmp_path):
    """Of a top that stands on its tip only the mass centre, 1 m above, says how tall it is."""
    path = solver.simulate(scene("sleeping_top"), stop_time=1.0).report(tmp_path / "page.html")
    assert value(look(path), "holonom.stage.size") == pytest.approx(1.0, rel=0.01)


def test_the_same_time_gives_the_same_pixels_and_another_time_others(pendulum, look):
    page = look(pendulum[1])
    page.evaluate("holonom.seek(1)")
    first = picture(page)
    page.evaluate("holonom.seek(2); holonom.seek(1)")
    assert (picture(page) == first).all()
    page.evaluate("holonom.seek(1.4)")
    assert (abs(picture(page) - first).max(axis=2) > 40).mean() > 0.002


def test_keys_move_the_time(pendulum, look):
    page = look(pendulum[1])
    page.locator("#stage").focus()
    page.keyboard.press("Home")
    assert value(page, "holonom.time") == 0.0
    page.keyboard.press("ArrowRight")
    assert value(page, "holonom.time") == pytest.approx(0.02)
    page.keyboard.press("End")
    assert value(page, "holonom.time") == pytest.approx(10.0)
    page.keyboard.press("ArrowLeft")
    assert value(page, "holonom.time") == pytest.approx(9.98)
    page.keyboard.press("d")
    assert value(page, "document.documentElement.dataset.theme") == "dark"


def test_tab_goes_through_all_that_can_be_used_and_shows_where_it_is(pendulum, look):
    page = look(pendulum[1])
    seen = []
    for _ in range(60):
        page.keyboard.press("Tab")
        seen.append(page.evaluate("document.activeElement.id || document.activeElement.tagName"))
        if seen[-1] == "BODY":
            break
        outline = page.evaluate("(e => getComputedStyle(e).outlineStyle)(document.activeElement)")
        assert outline != "none", seen
    assert seen[0] == "A"  # past all that is above the animation
    assert {"theme", "stage", "play", "time", "speed", "loop", "shot", "find", "csv"} < {*seen}


def test_a_page_plays_as_fast_as_the_clock_and_stops(pendulum, look):
    page = look(pendulum[1], clock=True)
    page.locator("#stage").focus()
    page.keyboard.press("Home")
    page.keyboard.press("Space")
    page.clock.run_for(1500)
    assert value(page, "holonom.time") == pytest.approx(1.5, abs=0.02)
    page.select_option("#speed", "0.1")
    page.clock.run_for(1000)
    page.keyboard.press("Space")
    reached = value(page, "holonom.time")
    assert reached == pytest.approx(1.6, abs=0.02)
    page.clock.run_for(200)
    assert value(page, "holonom.time") == reached


def test_a_page_plays_by_itself_but_not_for_those_who_want_less_motion(pendulum, look):
    moving = look(pendulum[1], hash="", reduced_motion="no-preference")
    assert value(moving, "holonom.playing")
    assert not value(look(pendulum[1], hash=""), "holonom.playing")


def test_a_loop_stays_in_its_range(pendulum, look):
    page = look(pendulum[1], clock=True)
    page.evaluate("holonom.loop(2, 2.4); holonom.play(true)")
    page.clock.run_for(900)  # twice around, and a quarter
    assert value(page, "holonom.time") == pytest.approx(2.1, abs=0.03)


def test_a_click_on_a_plot_seeks(pendulum, look):
    page = look(pendulum[1])
    box = page.locator(".u-over").first.bounding_box()
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 20)
    assert value(page, "holonom.time") == pytest.approx(5.0, abs=0.2)


def test_a_variable_becomes_a_plot_and_a_plot_goes(pendulum, look):
    page = look(pendulum[1])
    count = "holonom.charts.list.length"
    before = value(page, count)
    page.fill("#find", "A.vx")
    page.keyboard.press("Enter")
    assert value(page, count) == before + 1
    page.locator(".chart .close").first.click()
    assert value(page, count) == before


def test_the_numbers_of_a_plot_are_saved_as_csv(pendulum, look):
    trajectory, path = pendulum
    page = look(path, accept_downloads=True)
    with page.expect_download() as saved:
        page.click("#csv")
    lines = Path(saved.value.path()).read_text().splitlines()
    assert lines[0].split(",")[0] == "time"
    assert set(lines[0].split(",")[1:]) == set(trajectory.names)
    assert len(lines) == len(trajectory.t) + 1
    with page.expect_download() as saved:
        page.click("#shot")
    assert Path(saved.value.path()).read_bytes().startswith(b"\x89PNG")


def test_the_stacked_energies_close(look, tmp_path):
    path = solver.simulate(scene("quarter_car"), stop_time=1.0).report(tmp_path / "page.html")
    page = look(path)
    top, line = page.evaluate(
        "(() => { const x = holonom.charts.list.find(i => i.spec.stack).traces;"
        " return x.slice(-2).map(y => [...y.values]); })()"
    )
    assert np.allclose(top, line, atol=1e-5 * max(map(abs, line)))


def test_reactions_are_arrows(look, tmp_path):
    path = solver.simulate(scene("bricard"), stop_time=1.0).report(tmp_path / "page.html")
    page = look(path)
    page.evaluate("holonom.seek(0.5)")
    without = picture(page)
    page.locator("#stage").focus()
    page.keyboard.press("f")
    reddish = picture(page)
    new = abs(reddish - without).max(axis=2) > 60
    assert new.mean() > 0.001
    assert (reddish[new][:, 0] > reddish[new][:, 1] + 60).mean() > 0.5


def test_without_webgl_the_mechanism_is_painted(platform, look):
    page = look(platform, arguments=WITHOUT_WEBGL)
    assert value(page, "holonom.stage.painted")
    assert page.said == []
    assert filled(page) > 0.03


def test_a_damaged_block_names_itself(pendulum, look, tmp_path):
    text = pendulum[1].read_text(encoding="utf-8")
    bad = tmp_path / "bad.html"
    bad.write_text(re.sub(r'(id="block1">.{40}).{4}', r"\1AAAA", text), encoding="utf-8")
    assert "block1, the poses, is damaged" in look(bad).inner_text(".broken")
    bad.write_text(re.sub(r'(id="block2">.{40}).*?<', r"\1<", text), encoding="utf-8")
    assert "block2, the values, is damaged" in look(bad).inner_text(".broken")


def test_a_page_fits_a_phone(platform, look):
    options = {"viewport": {"width": 390, "height": 800}, "is_mobile": True, "has_touch": True}
    page = look(platform, **options)
    assert value(page, "document.documentElement.scrollWidth") <= 390


@pytest.fixture(scope="module")
def fmu_page(tmp_path_factory):
    """The page inside an FMU, unpacked with the picture that it shows."""
    folder = tmp_path_factory.mktemp("fmu")
    with zipfile.ZipFile(build_archive(scene("double_wishbone"), folder / "a.fmu", None)) as fmu:
        fmu.extract("model.png", folder)
        return Path(fmu.extract("documentation/index.html", folder))


def test_the_page_of_an_fmu_fits_a_phone_shows_its_picture_and_asks_for_no_more(fmu_page, launch):
    with launch().new_page(viewport={"width": 390, "height": 800}) as page:
        asked = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto(fmu_page.as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        assert page.evaluate("document.images[0].naturalWidth") > 0
        assert asked == [fmu_page.as_uri(), (fmu_page.parents[1] / "model.png").as_uri()]
        assert axe_findings(page) == {"light": [], "dark": []}


def test_a_print_has_the_picture_and_the_plots(platform, look):
    page = look(platform)
    page.emulate_media(media="print")
    assert page.locator("#canvas").is_visible()
    assert page.locator(".chart canvas").first.is_visible()
    assert not page.locator("#play").is_visible()
    assert len(page.pdf(format="A4", landscape=True, print_background=True)) > 20_000


def test_a_run_of_a_sweep_is_chosen_and_another_is_its_ghost(look, tmp_path):
    path, results = tmp_path / "sweep.html", str(tmp_path / "sweep.csv")
    grid = ["--grid", "length=0.5:1.5:3", "--engine", "serial", "--output", "B.x", "-o", results]
    command = ["sweep", scene("double_pendulum"), *grid, "--stop", "1", "--report", str(path)]
    assert main(command) == 0
    page = look(path)
    reach = (
        "Math.hypot(holonom.stage.shown[0].positions[1].x, holonom.stage.shown[0].positions[1].y)"
    )
    for row, length in enumerate((0.5, 1.0, 1.5)):
        page.locator("tr[data-run]").nth(row).click()
        assert value(page, reach) == pytest.approx(length, abs=1e-3)
        assert page.locator("tr.on").get_attribute("data-run") == str(row)
    page.evaluate("holonom.choose(0, 2)")
    assert value(page, "holonom.stage.shown.length") == 2


def test_two_runs_stand_side_by_side(look, tmp_path):
    runs = [solver.simulate(scene("four_bar"), stop_time=1.0, formulation=f) for f in
            ("conserving-al", "midpoint-al")]  # fmt: skip
    from viewer.drawing import drawing

    model = runs[0].model
    drawn = drawing(model.scene)
    parts = [ReportRun(drawn, r.t, dict(r), label=f"run {k}") for k, r in enumerate(runs)]
    path = tmp_path / "page.html"
    text = page_text(parts, "two", "", model.variables, [], [], compare=True)
    path.write_text(text, encoding="utf-8")
    page = look(path)
    assert value(page, "holonom.stage.shown[1].group.position.x") > 1.0
    assert page.locator("#tags span").all_inner_texts() == ["run 0", "run 1"]
    energies = page.locator("figure.chart", has_text="kinetic · run 1").first.locator(".chips i")
    colours = energies.evaluate_all("chips => chips.map(x => x.style.backgroundColor)")
    assert len(set(colours)) == len(colours) == 6


def test_names_of_a_scene_are_harmless(look, tmp_path):
    trajectory = solver.simulate(scene("double_pendulum"), stop_time=0.5)
    from viewer.drawing import drawing

    drawn = drawing(trajectory.model.scene)
    evil = (
        "</script><script>window.evil = 1</script>&amp;<img src=x onerror='window.evil=1'>@@DATA@@"
    )
    for joint in drawn["joints"]:
        joint["name"] = evil
    run = ReportRun(drawn, trajectory.t, dict(trajectory), label=evil, reason=evil)
    path = tmp_path / "page.html"
    text = page_text([run, run], evil, evil, trajectory.model.variables, [], [evil])
    path.write_text(text, encoding="utf-8")
    page = look(path)
    assert page.said == []
    assert value(page, "window.evil === undefined")
    assert page.inner_text("h1") == evil
    assert page.title() == evil


def test_a_large_page_keeps_its_budget_and_plays(look, tmp_path):
    n, count = 10_000, 100
    t = np.linspace(0.0, 100.0, n)
    rng = np.random.default_rng(3)
    names = ["x", "y", "z", "qw", "qx", "qy", "qz"]
    frames, columns = [{"name": "ground", "kind": "ground", "variables": []}], {}
    solids = []
    for k in range(count):
        phase, rate = rng.uniform(0, 6), rng.uniform(0.5, 3.0)
        half = 0.5 * rate * t
        motion = [np.sin(rate * t + phase), np.cos(rate * t), k + 0.1 * np.sin(2 * t + phase)]
        motion += [np.cos(half), np.sin(half), 0 * t, 0 * t]
        own = [f"b{k}.{name}" for name in names]
        columns |= dict(zip(own, motion, strict=True))
        frames.append({"name": f"b{k}", "kind": "body", "variables": own})
        solids.append({"owner": f"b{k}", "kind": "body", "frame": k + 1, "at": [0, 0, 0],
                       "turn": [1, 0, 0, 0], "shape": "box", "size": [1, 0.3, 0.2]})  # fmt: skip
    drawn = {"dimension": 3, "up": [0, 0, 1], "frames": frames, "solids": solids, "links": [],
             "joints": [], "contacts": [], "view": {}}  # fmt: skip
    from solver.runtime import Variable

    known = [Variable(n, "Real", "output", "continuous", "m") for n in columns]
    path = tmp_path / "large.html"
    path.write_text(page_text([ReportRun(drawn, t, columns)], "large", "", known, [], []))
    assert path.stat().st_size < 10_000_000
    page = look(path, clock=True)
    page.evaluate("holonom.play(true)")
    page.clock.run_for(500)
    assert value(page, "holonom.time / holonom.speed") == pytest.approx(0.5, abs=0.02)


def test_axe_finds_nothing_serious(platform, look):
    assert axe_findings(look(platform)) == {"light": [], "dark": []}


@pytest.mark.long
@pytest.mark.parametrize("path", sorted((ROOT / "scenes").glob("*.toml")), ids=lambda p: p.stem)
def test_every_scene_fills_the_stage(path, look, tmp_path):
    trajectory = solver.simulate(path)
    begin = time.perf_counter()
    page = look(trajectory.report(tmp_path / "page.html"))
    assert time.perf_counter() - begin < 60.0
    assert page.said == []
    page.evaluate("holonom.seek(0.3 * (holonom.run.t[holonom.run.n - 1]))")
    assert filled(page) > 0.015  # thin pendulums 0.019; most scenes 0.03 and more
    assert math.isfinite(value(page, "holonom.stage.extent"))
