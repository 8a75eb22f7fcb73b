"""docs/truth.md is what the corpus says."""

from __future__ import annotations

from tests.truth.page import OF_KINDS, PAGE, THEMES, written
from tests.truth.random_record import fails
from tests.truth.random_systems import KINDS
from tests.truth.systems import SYSTEMS
from tests.truth.test_cases import FAILS


def test_the_page_is_that_of_the_corpus() -> None:
    remedy = "python -m tests.truth.page writes it anew"
    assert PAGE.read_text(encoding="utf-8") == written(), remedy


def test_each_mark_has_a_theme() -> None:
    marks = [*(system.fails for system in SYSTEMS), *FAILS.values(), *fails().values()]
    assert {issue for mark in marks for issue in mark.values()} <= THEMES.keys()


def test_the_page_tells_of_each_kind_of_random_systems() -> None:
    assert tuple(OF_KINDS) == KINDS
