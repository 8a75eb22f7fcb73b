"""A browser of this machine, and pages to look at; tests are skipped where there is none."""

from __future__ import annotations

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
    """Function that starts the browser with arguments; all are closed at the end."""
    api = pytest.importorskip("playwright.sync_api", reason="needs the extra 'browser'")
    path = os.environ.get("HOLONOM_BROWSER") or next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        pytest.skip("no chromium on this machine; HOLONOM_BROWSER names one")
    with api.sync_playwright() as playwright:
        begun = {}

        def launch(arguments=WITH_WEBGL):
            if arguments not in begun:
                known = playwright.chromium.launch(executable_path=path, args=[*arguments])
                begun[arguments] = known
            return begun[arguments]

        yield launch
        for browser in begun.values():
            browser.close()


@pytest.fixture
def look(launch):
    """Function that opens a page, without a network, and waits until it is drawn."""
    contexts = []

    def look(path: Path, *, hash: str = "still", arguments=WITH_WEBGL, clock=False, **options):
        settings = {"viewport": {"width": 1200, "height": 800}, "reduced_motion": "reduce"}
        context = launch(arguments).new_context(offline=True, **(settings | options))
        contexts.append(context)
        page = context.new_page()
        page.said, page.asked = [], []
        page.on("console", lambda message: page.said.append(message.text))
        page.on("pageerror", lambda error: page.said.append(str(error)))
        page.on("request", lambda request: page.asked.append(request.url))
        if clock:
            page.clock.install(time=0)
        page.goto(f"{path.as_uri()}#{hash}")
        end = time.monotonic() + 60.0  # wait_for_function needs eval, which the page forbids
        while not page.evaluate("!!(window.holonom && (holonom.first || holonom.error))"):
            assert time.monotonic() < end, ("the page is not ready", page.said)
            page.wait_for_timeout(50)
        if clock:
            page.clock.pause_at(3600)  # from now on it goes on when it is told
        return page

    yield look
    for context in contexts:
        context.close()


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
