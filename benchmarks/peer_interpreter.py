"""The interpreter that has other codes, and programs run by it in processes of their own."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

VARIABLE = "EXUDYN_PYTHON"
"""Names the interpreter; without it, it is this one."""


def run_there(
    arguments: Sequence[str],
    text: str,
    *,
    patience: float | None = None,
    environment: Mapping[str, str] | None = None,
) -> subprocess.CompletedProcess[str]:
    """Run Python with arguments and a text on its standard input; it may fail.

    Raises
    ------
    subprocess.TimeoutExpired
        After `patience` seconds.
    """
    return subprocess.run(
        [os.environ.get(VARIABLE, sys.executable), *arguments],
        input=text,
        capture_output=True,
        text=True,
        check=False,
        timeout=patience,
        cwd=Path(__file__).resolve().parents[1],
        # Exudyn's compiled module without range checks is the faster one.
        env={**os.environ, **(environment or {}), "EXUDYN_MODULE": "fast"},
    )
