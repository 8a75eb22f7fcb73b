"""A browser of this machine, and pages to look at; tests are skipped where there is none."""

from __future__ import annotations

import contextlib
import os
import shutil
import time
from pathlib import Path

import pytest

import solver

ROOT = Path(__file__).resolve().parents[2]
NAMES = ("chromium", "chromium-browser", "google-chrome")
WITH_WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
WITHOUT_WEBGL = ("--disable-gpu", "--disable-3d-apis", "--disable-software-rasterizer")


AXE = ROOT / "viewer" / "node_modules" / "axe-core" / "axe.min.js"


def scene(name: str) -> str:
    return str(ROOT / "scenes" / f"{name}.toml")


def axe_findings(page) -> dict[str, list]:
    """What axe-core finds serious on a page of ours, light and dark."""
    if not AXE.is_file():
        pytest.skip("no axe-core: make viewer brings it")
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = {}
    for theme in ("light", "dark"):
        page.emulate_media(color_scheme=theme)
        page.evaluate(
            "dark => window.holonom && holonom.dark !== dark && holonom.flip()", theme == "dark"
        )
        violations = page.evaluate("axe.run().then(r => r.violations)")
        serious = [x for x in violations if x["impact"] in ("serious", "critical")]
        found[theme] = [(x["id"], [n["html"][:100] for n in x["nodes"]][:3]) for x in serious]
    return found


@pytest.fixture(scope="session")
def launch():
    """Function that starts the browser, with WebGL or, four times as fast without a GPU, without.

    Both are closed at the end.
    """
    api = pytest.importorskip("playwright.sync_api", reason="needs the extra 'browser'")
    path = os.environ.get("HOLONOM_BROWSER") or next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.skip("no chromium on this machine; HOLONOM_BROWSER names one")
    with api.sync_playwright() as playwright:
        begun = {}

        def launch(webgl=False):
            if webgl not in begun:
                arguments = [*(WITH_WEBGL if webgl else WITHOUT_WEBGL)]
                begun[webgl] = playwright.chromium.launch(executable_path=path, args=arguments)
            return begun[webgl]

        yield launch
        for browser in begun.values():
            browser.close()


@contextlib.contextmanager
def opened(browser, **options):
    """Page in a context of its own, with what it says and asks for; it is small, to be fast."""
    settings = {"viewport": {"width": 640, "height": 400}, "reduced_motion": "reduce"}
    with browser.new_context(**(settings | options)) as context:
        page = context.new_page()
        page.said, page.asked = [], []
        page.on("console", lambda message: page.said.append(message.text))
        page.on("pageerror", lambda error: page.said.append(str(error)))
        page.on("request", lambda request: page.asked.append(request.url))
        yield page


def until(page, condition: str) -> None:
    """Wait for a condition; `wait_for_function` needs eval, which our pages forbid."""
    end = time.monotonic() + 60.0
    while not page.evaluate(f"!!({condition})"):
        assert time.monotonic() < end, (condition, page.said)
        page.wait_for_timeout(20)


@contextlib.contextmanager
def looking(launch):
    """Function that opens a page of a file, without a network, and waits until it is drawn."""
    with contextlib.ExitStack() as ends:

        def look(path: Path, *, hash: str = "", webgl=False, clock=False, **options):
            page = ends.enter_context(opened(launch(webgl), offline=True, **options))
            if clock:
                page.clock.install(time=0)
            page.goto(f"{path.as_uri()}#{hash}")
            until(page, "window.holonom && (holonom.first || holonom.error)")
            if clock:
                page.clock.pause_at(3600)  # from now on it goes on when it is told
            return page

        yield look


@pytest.fixture
def look(launch):
    """Function that opens a page, which is closed after the test."""
    with looking(launch) as look:
        yield look


@pytest.fixture(scope="module")
def keep(launch):
    """Function that opens a page, which several tests look at."""
    with looking(launch) as look:
        yield look


@pytest.fixture(scope="session")
def pendulum(tmp_path_factory):
    """A run of the double pendulum, and its page."""
    trajectory = solver.simulate(scene("double_pendulum"), stop_time=10.0, step_size=0.02)
    return trajectory, trajectory.report(tmp_path_factory.mktemp("pages") / "pendulum.html")


@pytest.fixture(scope="session")
def platform(tmp_path_factory):
    """The page of a mechanism in space."""
    trajectory = solver.simulate(scene("stewart"), inputs={"leg1": lambda t: 0.1 * t / 5.0})
    return trajectory.report(tmp_path_factory.mktemp("pages") / "platform.html")
