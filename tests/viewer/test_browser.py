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
from solver.runtime import Variable
from tests.viewer.conftest import ROOT, axe_findings, opened, scene, until
from viewer.drawing import drawing
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


@pytest.fixture(scope="module")
def _swinging(pendulum, keep):
    return keep(pendulum[1], webgl=True, accept_downloads=True)


@pytest.fixture
def swinging(_swinging):
    """The page of the pendulum at its start, as it opens; it asks for nothing, and says nothing."""
    page = _swinging
    page.evaluate("holonom.play(false); holonom.loop(); holonom.seek(0); holonom.pace(1)")
    yield page
    assert page.said == []
    assert [url.split(":")[0] for url in page.asked if not url.startswith("data:")] == ["file"]


@pytest.fixture(scope="module")
def _clocked(pendulum, keep):
    return keep(pendulum[1], clock=True, viewport={"width": 320, "height": 200})


@pytest.fixture
def clocked(_clocked):
    """The same, with a clock that goes on when it is told."""
    _clocked.evaluate("holonom.play(false); holonom.loop(); holonom.seek(0); holonom.pace(1)")
    return _clocked


@pytest.fixture(scope="module")
def standing(platform, keep):
    """The page of a mechanism in space."""
    return keep(platform)


@pytest.mark.parametrize("time", [0.0, 3.36, 9.98])
def test_points_are_drawn_where_they_are(pendulum, swinging, time):
    trajectory, _ = pendulum
    swinging.evaluate("t => holonom.seek(t)", time)
    drawn = swinging.evaluate("holonom.stage.shown[0].positions.slice(1).flatMap(p => [p.x, p.y])")
    exact = [np.interp(time, trajectory.t, trajectory[name]) for name in PENDULUM_POINTS]
    assert drawn == pytest.approx(exact, abs=2e-3)
    a, b = np.reshape(drawn, (2, 2))
    assert np.linalg.norm(a) == pytest.approx(1.0, abs=2e-4)
    assert np.linalg.norm(a - b) == pytest.approx(1.0, abs=2e-4)


def test_a_path_bends_between_rows(look, tmp_path):
    run = solver.simulate(scene("double_pendulum"), stop_time=2.0, step_size=0.1)
    points = value(
        look(run.report(tmp_path / "page.html")), "holonom.stage.lines[0].userData.points"
    )
    x, y, _ = np.reshape(points, (-1, 3)).T
    assert len(x) > 4 * len(run.t)
    assert np.hypot(x, y) == pytest.approx(1.0, abs=0.01)  # chords from row to row are off by 0.05


def test_a_body_without_a_shape_is_as_large_as_what_holds_it(look, tmp_path):
    """Of a top that stands on its tip only the mass centre, 1 m above, says how tall it is."""
    text = Path(scene("sleeping_top")).read_text().partition("[looks]")[0]
    run = solver.simulate(solver.loads(text), stop_time=1.0)
    path = run.report(tmp_path / "page.html")
    assert value(look(path), "holonom.stage.size") == pytest.approx(1.0, rel=0.01)


def test_the_same_time_gives_the_same_pixels_and_another_time_others(swinging):
    swinging.evaluate("holonom.seek(1)")
    first = picture(swinging)
    swinging.evaluate("holonom.seek(2); holonom.seek(1)")
    assert (picture(swinging) == first).all()
    swinging.evaluate("holonom.seek(1.4)")
    assert (abs(picture(swinging) - first).max(axis=2) > 40).mean() > 0.002


def test_one_sees_round_bodies_turn(look, tmp_path):
    run = solver.simulate(scene("gear_pair_with_backlash"), stop_time=0.1)
    page = look(run.report(tmp_path / "page.html"), webgl=True)
    first = picture(page)
    page.evaluate("holonom.seek(0.05)")  # by half a radian
    assert (abs(picture(page) - first).max(axis=2) > 24).mean() > 0.02


def test_a_floor_lies_below_and_a_wall_stands_beside(look, tmp_path):
    """In the plane, a surface is long along itself, not into the picture."""
    run = solver.simulate(scene("pile_of_discs"), stop_time=0.1)
    spans = value(look(run.report(tmp_path / "page.html")), f"({SPANS})(holonom.stage)")
    assert sorted(x > 1.0 for x, _ in spans) == [False, False, True]  # two walls, a floor
    assert all((x > 1.0) != (y > 1.0) for x, y in spans)


SPANS = """stage => stage.shown[0].items.filter(x => x.surface).map(x => {
    const e = x.matrix(stage.camera.matrix.clone()).elements;
    return [0, 1].map(k => Math.hypot(e[k], e[4 + k], e[8 + k]) / stage.size);
})"""
"""How far surfaces go to the right and up, over the size of the mechanism."""


@pytest.mark.parametrize("name", ["crossed_sticks", "ratchet", "pendulum_with_stop"])
def test_all_of_a_mechanism_is_in_the_picture(name, look, tmp_path):
    """Sticks, teeth of a wheel and the arc of a stop are no points of the scene, but are seen."""
    page = look(solver.simulate(scene(name), stop_time=0.2).report(tmp_path / "page.html"))
    assert value(page, f"({OUTSIDE})(holonom.stage)") == []
    page.set_viewport_size({"width": 360, "height": 400})
    until(page, "holonom.stage.width < 360")
    assert value(page, f"({OUTSIDE})(holonom.stage)") == []  # also when the window becomes narrow


OUTSIDE = """stage => {
    const out = stage.camera.position.clone(), places = solid => solid.points || solid.corners ||
        (solid.shape === 'capsule' ? [solid.from, solid.to] : []);
    stage.camera.updateMatrixWorld(); stage.dirty = true; stage.render();
    return stage.shown[0].drawing.solids.flatMap(solid => places(solid).map(place => {
        const at = place.map((x, k) => x + (solid.at[k] || 0));
        return stage.screen({ frame: solid.frame, at }, out);
    })).filter(([x, y]) => x < 0 || x > stage.width || y < 0 || y > stage.height);
}"""
"""Places of capsules and curves that lie beyond the stage."""


def test_keys_move_the_time(swinging):
    swinging.locator("#stage").focus()
    swinging.keyboard.press("Home")
    assert value(swinging, "holonom.time") == 0.0
    swinging.keyboard.press("ArrowRight")
    assert value(swinging, "holonom.time") == pytest.approx(0.02)
    swinging.keyboard.press("End")
    assert value(swinging, "holonom.time") == pytest.approx(10.0)
    swinging.keyboard.press("ArrowLeft")
    assert value(swinging, "holonom.time") == pytest.approx(9.98)
    for theme in ("dark", "light"):
        swinging.keyboard.press("d")
        assert value(swinging, "document.documentElement.dataset.theme") == theme


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


def test_a_page_plays_as_fast_as_the_clock_and_stops(clocked):
    clocked.locator("#stage").focus()
    clocked.keyboard.press("Home")
    clocked.keyboard.press("Space")
    clocked.clock.run_for(1500)
    assert value(clocked, "holonom.time") == pytest.approx(1.5, abs=0.02)
    clocked.select_option("#speed", "0.1")
    clocked.clock.run_for(1000)
    clocked.locator("#stage").focus()
    clocked.keyboard.press("Space")
    reached = value(clocked, "holonom.time")
    assert reached == pytest.approx(1.6, abs=0.02)
    clocked.clock.run_for(200)
    assert value(clocked, "holonom.time") == reached


def test_a_loop_stays_in_its_range(clocked):
    clocked.evaluate("holonom.loop(2, 2.4); holonom.play(true)")
    clocked.clock.run_for(900)  # twice around, and a quarter
    assert value(clocked, "holonom.time") == pytest.approx(2.1, abs=0.03)


def test_a_page_plays_by_itself_but_not_for_those_who_want_less_motion(pendulum, standing, look):
    assert value(look(pendulum[1], reduced_motion="no-preference"), "holonom.playing")
    assert not value(standing, "holonom.playing")


def test_a_click_on_a_plot_seeks(swinging):
    over = swinging.locator(".u-over").first
    box = over.bounding_box()
    over.click(position={"x": box["width"] / 2, "y": 20})
    assert value(swinging, "holonom.time") == pytest.approx(5.0, abs=0.2)


def test_a_variable_becomes_a_plot_and_a_plot_goes(swinging):
    count = "holonom.charts.list.length"
    before = value(swinging, count)
    swinging.fill("#find", "A.vx")
    swinging.keyboard.press("Enter")
    assert value(swinging, count) == before + 1
    swinging.locator(".chart .close").first.click()
    assert value(swinging, count) == before


def test_numbers_of_axes_are_those_of_their_lines(swinging):
    """2.5 ms is not 0.003 s."""
    axis = "holonom.charts.list[0].plot.axes[0]"
    swinging.evaluate("holonom.charts.list[0].plot.setScale('x', { min: 0, max: 0.0123 })")
    swinging.wait_for_timeout(50)
    splits, texts = value(swinging, f"[{axis}._splits, {axis}._values]")
    assert len(splits) > 2
    assert [float(x) for x in texts] == pytest.approx(splits, abs=1e-9)
    swinging.evaluate("holonom.charts.list[0].plot.setScale('x', { min: 0, max: 10 })")


def test_the_numbers_of_a_plot_are_saved_as_csv(pendulum, swinging):
    trajectory, _ = pendulum
    with swinging.expect_download() as saved:
        swinging.click("#csv")
    lines = Path(saved.value.path()).read_text().splitlines()
    assert lines[0].split(",")[0] == "time"
    assert set(lines[0].split(",")[1:]) == set(trajectory.names)
    assert len(lines) == len(trajectory.t) + 1
    with swinging.expect_download() as saved:
        swinging.click("#shot")
    assert Path(saved.value.path()).read_bytes().startswith(b"\x89PNG")


def test_the_stacked_energies_close(look, tmp_path):
    """The top of the stack is the dashed line, and numbers beside the names sum up to it."""
    path = solver.simulate(scene("quarter_car"), stop_time=1.0).report(tmp_path / "page.html")
    page = look(path)
    stack = "holonom.charts.list.find(i => i.spec.stack).traces"
    top, line = page.evaluate(f"{stack}.slice(-2).map(y => [...y.values])")
    assert np.allclose(top, line, atol=1e-5 * max(map(abs, line)))
    *parts, whole = page.evaluate(f"{stack}.map(y => y.read(0.5))")
    assert sum(parts) == pytest.approx(whole, rel=1e-5)
    assert min(top) < 1.2 * page.evaluate("holonom.run.columns.get('energy.kinetic')[0]")


def test_round_off_of_a_constant_is_no_curve(look, tmp_path):
    """Of a platform that stands still potential energy is all, and its ticks are far apart."""
    page = look(solver.simulate(scene("stewart"), stop_time=1.0).report(tmp_path / "page.html"))
    stack = "holonom.charts.list.find(i => i.spec.stack)"
    (kinetic, potential), low, high = page.evaluate(
        f"(({{ traces, plot }}) => [traces.slice(0, 2).map(x => x.read(0.5)), plot.scales.y.min,"
        f" plot.scales.y.max])({stack})"
    )
    assert kinetic < 1e-12 * potential
    assert low == 0.0
    assert potential < high < 2.0 * potential


def test_reactions_are_arrows(look, tmp_path):
    path = solver.simulate(scene("bricard"), stop_time=1.0).report(tmp_path / "page.html")
    page = look(path, webgl=True)
    page.evaluate("holonom.seek(0.5)")
    without = picture(page)
    page.locator("#stage").focus()
    page.keyboard.press("f")
    reddish = picture(page)
    new = abs(reddish - without).max(axis=2) > 60
    assert new.mean() > 0.001
    assert (reddish[new][:, 0] > reddish[new][:, 1] + 60).mean() > 0.5


def test_without_webgl_the_mechanism_is_painted(standing):
    assert value(standing, "holonom.stage.painted")
    assert standing.said == []
    assert filled(standing) > 0.03


def test_a_damaged_block_names_itself(pendulum, look, tmp_path):
    text = pendulum[1].read_text(encoding="utf-8")
    bad = tmp_path / "bad.html"
    bad.write_text(re.sub(r'(id="block1">.{40}).{4}', r"\1AAAA", text), encoding="utf-8")
    assert "block1, the poses, is damaged" in look(bad).inner_text(".broken")
    bad.write_text(re.sub(r'(id="block2">.{40}).*?<', r"\1<", text), encoding="utf-8")
    assert "block2, the values, is damaged" in look(bad).inner_text(".broken")
    bad.write_text(re.sub(r'(id="data">.{40}).{4}', r"\1AAAA", text), encoding="utf-8")
    assert "data, what the runs are of, is damaged" in look(bad).inner_text(".broken")


def test_a_page_whose_end_is_missing_says_so(pendulum, launch, tmp_path):
    """Its scripts are last: what is cut off of a page is always a part of them."""
    text = pendulum[1].read_text(encoding="utf-8")
    bad = tmp_path / "bad.html"
    for part in (0.02, 0.5, 0.99):
        bad.write_text(text[: int(part * len(text))], encoding="utf-8")
        with opened(launch(), offline=True) as page:
            page.goto(bad.as_uri())
            page.get_by_text("its end is missing").wait_for(state="visible")


def test_axes_have_two_numbers_at_least(look, tmp_path):
    path = solver.simulate(scene("slider_crank")).report(tmp_path / "page.html")
    page = look(path, viewport={"width": 1200, "height": 800})  # whose plots are low
    shown = value(page, "holonom.charts.list.map(x => x.plot.axes[1]._splits.length)")
    assert len(shown) >= 4
    assert min(shown) >= 2


def test_a_page_fits_a_phone(platform, look):
    options = {"viewport": {"width": 390, "height": 400}, "is_mobile": True, "has_touch": True}
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


def test_a_print_has_the_picture_and_the_plots_and_stretches_neither(standing):
    standing.emulate_media(media="print")
    assert standing.locator("#canvas").is_visible()
    assert standing.locator(".chart canvas").first.is_visible()
    assert not standing.locator("#play").is_visible()
    assert value(standing, "getComputedStyle(canvas).objectFit") == "contain"
    drawn = "(c => [c.width / c.height, c.clientWidth / c.clientHeight])"
    pixels, shown = value(standing, f"{drawn}(document.querySelector('.chart canvas'))")
    assert shown == pytest.approx(pixels, rel=0.05)
    assert len(standing.pdf(format="A4", landscape=True, print_background=True)) > 20_000
    standing.emulate_media(media="screen")


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


def compared(name, path, **runs):
    """Page of runs of a scene, by their labels, the second one beside the first."""
    known = {label: solver.simulate(scene(name), **run) for label, run in runs.items()}
    first = next(iter(known.values()))
    drawn = drawing(first.model.scene)
    parts = [ReportRun(drawn, run.t, dict(run), label=label) for label, run in known.items()]
    text = page_text(parts, name, "", first.model.variables, [], [], compare=True)
    path.write_text(text, encoding="utf-8")
    return path


def test_two_runs_stand_side_by_side(look, tmp_path):
    runs = {
        name: {"stop_time": 1.0, "formulation": f"{name}-al"} for name in ("conserving", "midpoint")
    }
    page = look(compared("four_bar", tmp_path / "page.html", **runs))
    beside = value(page, "holonom.stage.shown[1].group.position.x")
    assert beside > 1.0
    paths = value(page, "holonom.stage.lines.map(x => x.userData.points.slice(0, 3))")
    half = len(paths) // 2  # those of the first run, then those of the other
    assert np.subtract(paths[half:], paths[:half]) == pytest.approx(
        np.tile([beside, 0.0, 0.0], (half, 1)), abs=1e-3
    )
    assert page.locator("#tags span").all_inner_texts() == [*runs]
    energies = page.locator("figure.chart", has_text="Energy").first.locator(".chips i")
    colours = energies.evaluate_all("chips => chips.map(x => x.style.borderTopColor)")
    assert len(set(colours)) == len(colours) == 6
    stacks = page.locator("figure.chart:visible", has_text="Where the energy went")
    assert [run in text for run, text in zip(runs, stacks.all_inner_texts(), strict=True)] == [
        True
    ] * 2
    page.evaluate("holonom.choose(1, -1)")
    assert stacks.count() == 1


def test_runs_that_travel_stand_beside_their_way(look, tmp_path):
    """Thirty metres along the road, both cars are in the picture."""
    runs = {
        "soft": {"stop_time": 1.5},
        "stiff": {"stop_time": 1.5, "parameters": {"stiffness": 3e4}},
    }
    page = look(compared("quarter_car", tmp_path / "page.html", **runs))
    page.evaluate("holonom.seek(1.2); holonom.stage.render()")
    places = page.evaluate(
        "holonom.stage.shown.map(m => { const p = m.middle().add(m.group.position)"
        ".project(holonom.stage.camera); return [p.x, p.y]; })"
    )
    assert np.abs(places).max() < 1.0
    assert abs(places[0][1] - places[1][1]) > 0.5


def test_names_of_a_scene_are_harmless(look, tmp_path):
    trajectory = solver.simulate(scene("double_pendulum"), stop_time=0.5)
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
    assert page.inner_text("h1") == page.inner_text("#why") == evil
    assert page.title() == evil


def test_a_large_page_keeps_its_budget_and_plays(look, tmp_path):
    n, count = 10_000, 100
    t = np.linspace(0.0, 100.0, n)
    rng = np.random.default_rng(3)
    names = ["x", "y", "z", "qw", "qx", "qy", "qz"]
    frames, columns = [{"name": "ground", "kind": "ground", "variables": []}], {}
    solids = []
    for k in range(count):
        phase, rate = rng.uniform(0, 6), rng.uniform(15.0, 90.0)  # too fast to leave out rows
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
    known = [Variable(n, "Real", "output", "continuous", "m") for n in columns]
    path = tmp_path / "large.html"
    path.write_text(page_text([ReportRun(drawn, t, columns)], "large", "", known, [], []))
    assert path.stat().st_size < 10_000_000
    page = look(path, webgl=True, clock=True, viewport={"width": 320, "height": 200})
    assert value(page, "holonom.run.n") == n
    page.evaluate("holonom.play(true)")
    page.clock.run_for(500)
    assert value(page, "holonom.time / holonom.speed") == pytest.approx(0.5, abs=0.02)


def test_axe_finds_nothing_serious(standing):
    assert axe_findings(standing) == {"light": [], "dark": []}


@pytest.mark.long
@pytest.mark.parametrize("path", sorted((ROOT / "scenes").glob("*.toml")), ids=lambda p: p.stem)
def test_every_scene_fills_the_stage(path, look, tmp_path):
    trajectory = solver.simulate(path)
    begin = time.perf_counter()
    page = look(
        trajectory.report(tmp_path / "page.html"),
        webgl=True,
        viewport={"width": 1200, "height": 800},
    )
    assert time.perf_counter() - begin < 60.0
    assert page.said == []
    page.evaluate("holonom.seek(0.3 * (holonom.run.t[holonom.run.n - 1]))")
    assert filled(page) > 0.015  # thin pendulums 0.019; most scenes 0.03 and more
    assert math.isfinite(value(page, "holonom.stage.extent"))
