"""What comments and pages refer to is there: sections, equations, pages, files and tests."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CODE = (
    *("solver", "fmu_src", "build_fmu", "viewer", "build_kernel", "holonom"),
    *("benchmarks", "examples"),
)
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
SOURCES = sorted(
    path
    for folder in (*CODE, "scenes", "tests")
    for path in (ROOT / folder).rglob("*")
    if path.suffix in (".py", ".c", ".h", ".toml") and path != Path(__file__)
)

NUMBERS = r"(\d+(?:\.\d+)?(?:(?:, | and | to )\d+(?:\.\d+)?)*)"
SECTION = re.compile(rf"\btheory {NUMBERS}")
EQUATION = re.compile(rf"\b[Ee]qs?\.? \(?{NUMBERS}")
PAPER_SECTION = re.compile(rf"\bpaper, sections? {NUMBERS}")
ELSEWHERE = re.compile(r"\b(?:numerics|design)(?:\.md)?,? (?:section )?\d")
"""A citation of a text that is not in the repository."""
FOLDERS = "|".join((*CODE, "docs", "scenes", "tests"))
FILE = re.compile(rf"`((?:{FOLDERS})/[\w./-]*)`")
PAGE = re.compile(r"\bdocs/[\w/]+\.md\b")
TEST = re.compile(r"`(test_\w+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCED = re.compile(r"^```.*?^```", re.DOTALL | re.MULTILINE)

PAPER_EQUATIONS = {str(number) for number in range(1, 29)}
PAPER_SECTIONS = {"1", "2", "2.1", "2.2", "3", "3.1", "3.2"}
"""Of García Orden and Ortega, 2006, as far as code and pages use it."""


def text_of(path: Path) -> str:
    """Text of a file with each comment or paragraph in one line."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"\s*\n[ \t]*(?:#+|\*|//)?[ \t]*(?=\S)", " ", text)


def cited(pattern: re.Pattern[str]) -> dict[str, set[str]]:
    """Numbers that a pattern finds in code and pages, each with the files that have it."""
    found: dict[str, set[str]] = {}
    for path in (*SOURCES, *PAGES):
        for numbers in pattern.findall(text_of(path)):
            for number in re.findall(r"\d+(?:\.\d+)?", numbers):
                found.setdefault(number, set()).add(name_of(path))
    return found


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def headings(page: Path) -> list[str]:
    """Texts of the headings of a page."""
    text = FENCED.sub("", page.read_text(encoding="utf-8"))
    return re.findall(r"^#+ (.*?)\s*$", text, re.MULTILINE)


def anchors(page: Path) -> set[str]:
    """Names by which links reach the headings of a page, as GitHub makes them."""
    plain = (re.sub(r"[^\w\- ]", "", heading.lower()) for heading in headings(page))
    return {heading.replace(" ", "-") for heading in plain}


def theory_sections() -> list[str]:
    """Numbers of all sections of the theory."""
    pages = (ROOT / "docs" / "theory").glob("*.md")
    return [
        number
        for page in pages
        for heading in headings(page)
        for number in re.findall(r"^(\d+(?:\.\d+)?)\.? ", heading)
    ]


def test_every_section_of_the_theory_that_is_cited_exists_once():
    sections = theory_sections()
    assert len(sections) == len(set(sections))
    known = cited(SECTION)
    assert len(known) > 5
    assert not {number: files for number, files in known.items() if number not in sections}


def test_no_citation_names_a_text_that_is_not_here():
    strangers = {name_of(path) for path in (*SOURCES, *PAGES) if ELSEWHERE.search(text_of(path))}
    assert not strangers


@pytest.mark.parametrize(
    ("pattern", "existing"),
    [(EQUATION, PAPER_EQUATIONS), (PAPER_SECTION, PAPER_SECTIONS)],
    ids=["equations", "sections"],
)
def test_what_is_cited_of_the_paper_is_in_the_paper(pattern, existing):
    known = cited(pattern)
    assert known
    assert not {number: files for number, files in known.items() if number not in existing}


WRITTEN = "generated/"
"""Pages that `make docs` writes; it checks the links to them."""


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_link_of_a_page_leads_somewhere(page):
    for target in LINK.findall(FENCED.sub("", page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target) or WRITTEN in target:
            continue
        file, _, anchor = target.partition("#")
        there = (page.parent / file).resolve() if file else page
        assert there.exists(), target
        assert not anchor or anchor in anchors(there), target


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_files_and_tests_that_a_page_names_exist(page):
    text = page.read_text(encoding="utf-8")
    assert not [
        name
        for name in FILE.findall(text)
        if not (name.startswith(f"docs/{WRITTEN}") or (ROOT / name).exists())
    ]
    tests = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("*.py"))
    assert not [name for name in TEST.findall(text) if f"def {name}(" not in tests]


def test_pages_that_comments_name_exist():
    named = {page: name_of(path) for path in SOURCES for page in PAGE.findall(text_of(path))}
    assert named
    assert not {page: file for page, file in named.items() if not (ROOT / page).is_file()}


def test_the_patterns_find_citations_across_lines_and_in_lists(tmp_path):
    source = tmp_path / "a.c"
    source.write_text("/* exact (theory\n   2.5, 5.1); see (paper, eqs 15\n * and 26) */\n")
    assert SECTION.findall(text_of(source)) == ["2.5, 5.1"]
    assert EQUATION.findall(text_of(source)) == ["15 and 26"]
