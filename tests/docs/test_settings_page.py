"""The page of settings has the table of `solver.options`, and a scene has its defaults."""

from pathlib import Path

import solver
from solver.options import OPTIONS, Option

ROOT = Path(__file__).resolve().parents[2]


def row(option: Option) -> str:
    """One line of the page's table."""
    default = f"{option.default:g}" if type(option.default) is float else str(option.default)
    words = (f"`{option.name}`", option.meaning, option.rule, f"`{default.lower()}`")
    return f"| {' | '.join(words)} |"


def test_the_page_has_the_table_of_settings():
    """To renew it: the lines that `row` gives, into docs/solver_settings.md."""
    page = (ROOT / "docs" / "solver_settings.md").read_text(encoding="utf-8")
    head = ["| option | meaning | what it must be | default |", "|---|---|---|---|"]
    assert "\n".join([*head, *map(row, OPTIONS.values())]) in page


def test_a_scene_without_settings_has_the_defaults():
    scene = solver.load(ROOT / "scenes" / "pendulum.toml")
    text = scene.source.text.partition("[solver]")[0]
    settings = solver.loads(text).solver
    assert {name: getattr(settings, name) for name in OPTIONS} == {
        name: option.default for name, option in OPTIONS.items()
    }
