"""A live page in a browser: it moves, sliders act, failures are said, and no number is NaN."""

from __future__ import annotations

import contextlib
import threading
import time

import pytest

import viewer.live
from build_fmu.commands.view import live_session
from tests.viewer.conftest import axe_findings, opened, scene, until
from viewer.live_server import Server

FINITE = (
    "holonom.run.values.every(x => x.subarray(0, holonom.run.n).every(Number.isFinite))"
    " && holonom.stage.shown[0].positions.every(p => Number.isFinite(p.x + p.y + p.z))"
    " && !document.body.innerText.includes('NaN')"
)
SAID = "document.getElementById('said').innerText"


@contextlib.contextmanager
def live(launch, name, *, webgl=False):
    """Serve a scene and open its page: both, until the page is closed and the server has ended."""
    with contextlib.ExitStack() as ends:
        ends.callback(setattr, viewer.live, "GRACE", viewer.live.GRACE)
        server = ends.enter_context(Server(*ends.enter_context(live_session(scene(name), {}, []))))
        thread = threading.Thread(target=server.run, daemon=True)
        thread.start()
        ends.callback(wait_for, lambda: not thread.is_alive())  # the page was closed
        page = ends.enter_context(opened(launch(webgl)))
        page.goto(server.address)
        until(page, "window.holonom && holonom.first && holonom.run.n === 1")
        yield page, server
        assert page.said == []
        viewer.live.GRACE = 0.0  # nobody loads the page again


@pytest.fixture(scope="module")
def _crank(launch):
    with live(launch, "slider_crank") as known:
        yield known


@pytest.fixture
def crank(_crank):
    """Page and server of a slider-crank, at its start."""
    page, server = _crank
    page.evaluate("holonom.play(false); holonom.pace(0.01)")
    page.click("#original")
    wait_for(lambda: not server.session.playing and server.session.values == {})
    until(page, f"holonom.time === 0 && holonom.run.n === 1 && !{SAID}")
    return page, server


def wait_for(holds):
    end = time.monotonic() + 60.0
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.02)


def enter(page, name, value):
    """Write a value into the field of a parameter."""
    page.get_by_label(f"{name} as a number").fill(value)
    page.keyboard.press("Enter")


def test_a_live_page_moves_steps_and_pauses(crank):
    page, server = crank
    assert page.evaluate("holonom.time") == 0.0
    page.click("#step")
    until(page, "holonom.time === 0.001")
    page.locator("#stage").focus()
    page.keyboard.press("ArrowRight")
    until(page, "holonom.time === 0.002")
    page.click("#play")
    until(page, "holonom.run.n > 20")
    page.click("#play")
    wait_for(lambda: not server.session.playing)
    until(page, f"holonom.time === {server.session.time!r}")
    page.click("#restart")
    until(page, "holonom.time === 0 && holonom.run.n === 1")
    assert page.evaluate(FINITE)
    assert all(url.startswith((server.address.split("?")[0], "data:")) for url in page.asked)


def test_sliders_act_and_the_values_of_the_file_come_back(crank):
    page, server = crank
    page.click("#play")
    until(page, "holonom.run.n > 20")
    enter(page, "crank_length", "0.12")
    wait_for(lambda: server.session.values == {"crank_length": 0.12})
    until(page, "holonom.run.n > 5 && holonom.playing")
    assert page.evaluate(FINITE)
    slider = page.get_by_label("rod_length", exact=True)
    slider.focus()
    page.keyboard.press("PageUp")
    wait_for(lambda: server.session.values.get("rod_length", 0.3) != 0.3)
    assert page.evaluate(FINITE)
    page.click("#original")
    wait_for(lambda: server.session.values == {})
    until(
        page, "document.querySelector('[aria-label=\"crank_length as a number\"]').value === '0.15'"
    )
    until(page, "holonom.run.n > 5")
    assert page.evaluate(FINITE)


def test_what_is_tunable_acts_while_it_moves(launch):
    with live(launch, "differential", webgl=True) as (page, server):
        page.click("#play")
        until(page, "holonom.run.n > 10")
        slider = page.get_by_label("torque", exact=True)
        slider.focus()
        page.keyboard.press("End")
        wait_for(lambda: server.session.values == {"torque": 120.0})
        reached = page.evaluate("holonom.time")
        until(page, f"holonom.time > {reached} + 0.1")
        assert page.evaluate("holonom.run.t[0]") == 0.0
        assert page.evaluate(FINITE)


def test_a_step_that_fails_is_said_and_other_values_help(crank):
    page, _ = crank
    enter(page, "rod_length", "0.01")  # it does not reach from the crank to the slider
    page.click("#step")
    until(page, SAID)
    assert "Newton's iteration did not converge" in page.evaluate(SAID)
    assert not page.evaluate("holonom.playing")
    enter(page, "rod_length", "0")  # it cannot even begin
    until(page, f"{SAID}.includes('cannot be assembled')")
    page.click("#original")
    until(page, f"!{SAID}")
    page.click("#step")
    until(page, "holonom.time === 0.001")
    assert page.evaluate(FINITE)


def test_a_mechanism_that_is_slower_than_the_clock_says_how_slow(crank, monkeypatch):
    page, server = crank
    page.evaluate("holonom.pace(100)")
    source = server.session._source
    step = source.step

    def slow(*arguments):
        time.sleep(0.06)
        return step(*arguments)

    monkeypatch.setattr(source, "step", slow)
    page.click("#play")
    until(page, "/slower than the clock: [0-9.e-]+ % of this speed/.test(document.body.innerText)")


def test_a_page_shows_another_session_in_its_place(launch):
    with live(launch, "double_pendulum") as (page, server):
        server.session.say("a.toml:3: error: unknown field\n    3 | x = 1")
        until(page, f"{SAID}.includes('3 | x = 1')")
        with live_session(scene("four_bar"), {}, ["a warning"]) as (session, text):
            server.show(session, text)
            wait_for(lambda: session._pages)  # it has been loaded anew
            until(page, "window.holonom && holonom.first && holonom.run.n === 1")
            assert page.title() == "four_bar"
            assert "a warning" in page.inner_text("#messages")
            page.click("#step")
            until(page, "holonom.time > 0")
            assert page.evaluate(FINITE)
            page.close()
            wait_for(lambda: session.ended)


def test_a_live_page_fits_a_phone_and_axe_finds_nothing_serious(crank):
    page, _ = crank
    enter(page, "rod_length", "0")
    until(page, SAID)
    assert axe_findings(page) == {"light": [], "dark": []}
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
