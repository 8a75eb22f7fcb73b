"""The documentation site: every page is reached, and its generated pages hold every scene."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from build_fmu.errors import EXIT_CODES
from viewer.picture import canvases

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
GENERATED = re.compile(r"(^|/)generated/")
PAGES = {path for path in DOCS.rglob("*.md") if not GENERATED.search(path.as_posix())}


def entries(page: Path) -> list[str]:
    """What the toctrees of a page name."""
    blocks = re.findall(r"^```\{toctree\}\n(.*?)^```", page.read_text("utf-8"), re.M | re.S)
    lines = "\n".join(blocks).splitlines()
    return [line.strip() for line in lines if line.strip() and not line.startswith(":")]


@pytest.fixture
def _generators(monkeypatch):
    monkeypatch.syspath_prepend(str(DOCS))
    yield
    for name in [name for name in sys.modules if name.partition(".")[0] == "generators"]:
        del sys.modules[name]


def test_every_page_is_reached_from_the_first():
    reached, new = set(), [DOCS / "index.md"]
    while new:
        page = new.pop()
        reached.add(page)
        named = ((page.parent / f"{name}.md").resolve() for name in entries(page))
        new += [path for path in named if path in PAGES - reached]
    assert sorted(PAGES - reached) == []


def test_every_entry_of_a_toctree_is_a_page():
    named = {page.parent / f"{name}.md" for page in PAGES for name in entries(page)}
    assert {path.resolve() for path in named if not GENERATED.search(path.as_posix())} <= PAGES


def test_every_link_between_pages_leads_to_a_file():
    links = [
        (page, link)
        for page in PAGES
        for link in re.findall(r"\]\(([^)#\s]+?)(?:#[^)]*)?\)", page.read_text("utf-8"))
        if re.match(r"[\w./-]+\.\w+$", link) and not GENERATED.search(link)
    ]
    assert len(links) > 100
    assert [(p.name, x) for p, x in links if not (p.parent / x).is_file()] == []


@pytest.mark.usefixtures("_generators")
def test_every_scene_is_in_the_gallery():
    from generators import gallery  # pyright: ignore[reportMissingImports]

    shown = [path for paths in gallery.groups().values() for path in paths]
    assert sorted(shown) == sorted((ROOT / "scenes").glob("*.toml"))


@pytest.mark.usefixtures("_generators")
def test_every_command_and_exit_code_is_on_the_page_of_commands(tmp_path):
    from generators import commands  # pyright: ignore[reportMissingImports]

    commands.write(tmp_path)
    text = (tmp_path / "commands.md").read_text("utf-8")
    names = {path.stem for path in (ROOT / "build_fmu" / "commands").glob("[a-z]*.py")}
    assert set(re.findall(r"^## holonom (\w+)$", text, re.M)) == names
    assert all(f"| {code} | {meaning} |" in text for code, meaning in EXIT_CODES.items())
    assert "| `--fmi {2,3}` | version of the standard; 3 needs --native (default: 2) |" in text
    assert "(default: 1e-09)" in text


@pytest.mark.usefixtures("_generators")
def test_the_picture_of_the_readme_is_small_and_shows_a_run_of_today():
    images = pytest.importorskip("PIL.Image")
    from generators import moving  # pyright: ignore[reportMissingImports]

    assert f"](docs/{moving.README.name})" in (ROOT / "README.md").read_text("utf-8")
    assert moving.README.stat().st_size <= 300_000
    drawn = [canvas.rgb() for canvas in canvases(moving.turn())]
    with images.open(moving.README) as picture:
        assert picture.n_frames == len(drawn)
        for k in range(0, len(drawn), 10):
            picture.seek(k)
            seen = np.asarray(picture.convert("RGB"), float)
            # Colours are rounded; another frame is off by 1.2.
            assert np.abs(seen - drawn[k]).mean() < 0.3


@pytest.mark.usefixtures("_generators")
def test_the_scene_format_has_every_type_and_field(tmp_path):
    from generators import scene_format  # pyright: ignore[reportMissingImports]

    from solver.scene import json_schema

    scene_format.write(tmp_path)
    text = (tmp_path / "scene_format.md").read_text("utf-8")
    for part in json_schema()["$defs"].values():
        for name in part["properties"]:
            assert name == "type" or f"| `{name}` |" in text
        assert f"### `{part['properties'].get('type', {}).get('const')}`" in text or (
            "const" not in part["properties"].get("type", {})
        )
