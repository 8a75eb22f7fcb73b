"""What the repository promises of itself and no reviewer sees: no traces of one machine."""

from __future__ import annotations

import re
import sys
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[2]
CODE = (
    *("holonom", "solver", "fmu_src", "build_fmu", "viewer", "build_kernel"),
    *("benchmarks", "examples"),
)
TEXT = (*CODE, "docs", "scenes", "tests")
MACHINE_PATH = re.compile(r"(?<![\w.])/(?:home|root|Users|work|tmp)/\w|[A-Z]:\\\\?Users", re.ASCII)


def files(folders: tuple[str, ...], *suffixes: str) -> list[Path]:
    """Files below folders of the repository, without what is built."""
    found = [path for folder in folders for path in sorted((ROOT / folder).rglob("*"))]
    return [path for path in found if path.suffix in suffixes and "_kernel" not in path.parts]


def relative(path: Path) -> str:
    """Name of a file in a test's title."""
    return path.relative_to(ROOT).as_posix()


def test_no_text_names_a_folder_of_one_machine():
    suffixes = (".py", ".c", ".h", ".md", ".toml", ".json", ".txt")
    texts = [*files(TEXT, *suffixes), *ROOT.glob("*.md"), *ROOT.glob("*.toml"), ROOT / "Makefile"]
    found = {
        f"{relative(path)}:{number}: {line.strip()}"
        for path in texts
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)
        if MACHINE_PATH.search(line)
    }
    assert not found


def test_no_line_of_c_is_longer_than_100_columns():
    # Of Python ruff asks the same; what the build writes is not committed.
    found = [
        f"{relative(path)}:{number}"
        for path in files((*CODE, "tests"), ".c", ".h")
        if not path.stem.endswith("_tables")
        for number, line in enumerate(path.read_text("utf-8").splitlines(), start=1)
        if len(line) > 100
    ]
    assert not found


def test_nothing_is_left_to_do_in_the_code():
    marker = re.compile(r"\b(?:TODO|FIXME|XXX)\b")
    texts = [
        path for path in files(CODE, ".py", ".c", ".h") if marker.search(path.read_text("utf-8"))
    ]
    assert not texts


def test_what_pages_and_messages_tell_to_install_is_an_extra():
    """Of `holonom[hdf5]` pip would only warn that there is no such extra, and install nothing."""
    pages = [ROOT / "README.md", *ROOT.glob("docs/*.md"), *ROOT.glob("build_fmu/**/*.py")]
    told = {
        name
        for page in pages
        for names in re.findall(r"holonom\[([\w,]+)\]", page.read_text(encoding="utf-8"))
        for name in names.split(",")
    }
    text = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    assert told <= set(tomllib.loads(text)["project"]["optional-dependencies"])
    assert told >= {"hdf5", "dask", "pandas", "xarray", "pytest"}
