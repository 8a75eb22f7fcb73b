"""The bundle that is committed is the one that its sources give, byte for byte."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

HOME = Path(__file__).parents[2] / "viewer"


def test_the_bundle_is_that_of_the_sources(tmp_path):
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("no npm on this machine, which bundles the sources")
    shutil.copytree(HOME, tmp_path / "viewer", ignore=shutil.ignore_patterns("node_modules"))
    copy = tmp_path / "viewer"
    if (HOME / "node_modules" / ".package-lock.json").is_file():
        (copy / "node_modules").symlink_to(HOME / "node_modules")
    else:
        brought = subprocess.run(
            [npm, "ci", "--silent"], cwd=copy, capture_output=True, check=False
        )
        if brought.returncode:
            pytest.skip("npm cannot bring three, uplot and esbuild: no network")
    shutil.rmtree(copy / "bundle")
    subprocess.run([npm, "run", "--silent", "build"], cwd=copy, capture_output=True, check=True)
    for path in sorted((HOME / "bundle").iterdir()):
        same = (copy / "bundle" / path.name).read_bytes() == path.read_bytes()
        assert same, f"{path.name} is not that of its sources; remedy: make viewer"


def test_the_bundle_has_the_licences_of_what_is_in_it():
    for name in ("three", "uplot"):
        assert "Permission is hereby granted" in (HOME / "bundle" / f"LICENSE.{name}").read_text()


def test_the_bundle_is_small():
    import zlib

    packed = sum(len(zlib.compress(p.read_bytes())) for p in (HOME / "bundle").iterdir())
    assert packed < 400_000
