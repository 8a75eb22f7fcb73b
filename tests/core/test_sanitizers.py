"""The kernel under gcc's sanitizers, briefly; `make sanitize` runs all scenes and settings."""

from __future__ import annotations

import re

import pytest

from tests.sanitize import can_sanitize, copy_with_sanitizers, run_in

pytestmark = pytest.mark.skipif(not can_sanitize(), reason="gcc has no sanitizers here")

SOME = 97
"""Every 97th of some 1,350 cases, each with another of the 45 settings."""


def test_no_run_reads_or_writes_beyond_its_arrays_or_is_undefined(tmp_path):
    copy_with_sanitizers(tmp_path, "-O0")
    run = run_in(tmp_path, SOME)
    assert run.returncode == 0, run.stderr[-3000:]
    ran, ended = map(int, re.findall(r"\d+", run.stdout.splitlines()[-1]))
    assert ran > 10
    assert ended < ran / 2
