"""Fixtures for tests of FMUs, which pytest finds once this package is installed.

`built_fmu` builds the FMU of a scene, once for the same values: `built_fmu("a.toml", mass=2)`.
`fmu_path` is each file that is named by `pytest --fmu FILE`, which may have wildcards.
"""

from __future__ import annotations

import glob
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Option --fmu."""
    parser.getgroup("holonom").addoption(
        "--fmu",
        action="append",
        default=[],
        metavar="FILE",
        help="an FMU, or several by wildcards, for tests that take fmu_path",
    )


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """One test for each file of --fmu."""
    patterns = metafunc.config.getoption("--fmu")
    if patterns and "fmu_path" in metafunc.fixturenames:
        found = [Path(name) for each in patterns for name in sorted(glob.glob(each)) or [each]]
        metafunc.parametrize("fmu_path", found, ids=[path.name for path in found])


@pytest.fixture
def fmu_path() -> Path:
    """File of --fmu; without one the test is skipped."""
    pytest.skip("give --fmu FILE")


@pytest.fixture(scope="session")
def built_fmu(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Function from a scene file, values by name and `parameters=` (or a file) to the FMU."""
    from build_fmu import build
    from build_fmu.study.settings import entries_of

    made: dict[str, Path] = {}

    def built(scene: str | Path, parameters: Any = None, **values: Any) -> Path:
        key = repr((str(scene), parameters, values))
        if key not in made:
            given = entries_of(parameters) | entries_of(values)  # the latter have precedence
            made[key] = build(scene, tmp_path_factory.mktemp("fmu"), parameters=given)
        return made[key]

    return built
