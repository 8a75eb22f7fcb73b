"""The kernel's laws of contact, compiled for a caller that lays its arrays out itself.

Contact i has the rows ``first[i]`` (normal) and ``first[i] + 1 ..`` (slips); rates are
gamma+ = gamma- + W p.
"""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from build_kernel.compiler import FLAGS, includes, system_compiler, zig_compiler
from tests.support.mechanisms.problems import Array

SHIM = Path(__file__).parent / "contact_laws.c"
KERNEL = Path(__file__).parents[3] / "solver" / "kernel"
STRICT = ["-Werror", "-Wshadow", "-Wcast-qual", "-Wconversion", "-Wno-sign-conversion"]
RETREATED, SLOW_STOPPED, ENDED, PLASTIC = 1, 2, 4, 8
"""Ways out of a jam."""
LEAST_WORK, MOST_WORK = range(2)

HAS_COMPILER = bool(system_compiler() or zig_compiler())


class CContacts(ctypes.Structure):
    """What ``contact_problem`` is in C."""

    _fields_ = [
        *((name, ctypes.c_int32) for name in ("contacts", "rows")),
        *(
            (name, ctypes.c_void_p)
            for name in (
                *("first", "tangents", "coefficient", "slides", "way"),
                *("W", "b", "p", "rate", "scratch"),
            )
        ),
        ("least_size", ctypes.c_double),
        ("several", ctypes.c_int32),
    ]


class CImpact(ctypes.Structure):
    """What ``hm_impact`` is in C."""

    _fields_ = [
        *((name, ctypes.c_int32) for name in ("contacts", "rows")),
        *(
            (name, ctypes.c_void_p)
            for name in ("first", "tangents", "coefficient", "restitution", "W", "before")
        ),
        ("forces", ctypes.c_int32),
        *(
            (name, ctypes.c_void_p)
            for name in (
                *("force", "force_begin", "force_end", "force_continues"),
                *("impulse", "after", "compression", "expansion"),
            )
        ),
        *((name, ctypes.c_double) for name in ("friction", "plastic")),
        *((name, ctypes.c_int32) for name in ("jam", "several", "pieces", "newton")),
        ("scratch", ctypes.c_void_p),
    ]


@dataclass(frozen=True)
class Impact:
    """What an impact has done."""

    failed: int
    impulse: Array
    after: Array
    compression: Array
    expansion: Array
    friction: float
    """What friction takes, J."""
    plastic: float
    """What the last way out of a jam takes, J."""
    loss: float
    """-p (gamma- + gamma+)/2, J."""
    jam: int
    several: int
    pieces: int
    newton: int


class Laws:
    """The laws as this machine's compiler makes them, without a warning."""

    def __init__(self, folder: Path) -> None:
        target = folder / "contact_laws.so"
        compiler = system_compiler() or zig_compiler() or ["cc"]
        options = [*FLAGS, *STRICT, "-DDIM=3", *includes(KERNEL)]
        subprocess.run(
            [
                *compiler,
                *options,
                "-o",
                str(target),
                str(SHIM),
                str(KERNEL / "math" / "exponential.c"),
                "-lm",
            ],
            check=True,
        )
        self.library = ctypes.CDLL(str(target))
        self.library.impact_scratch.restype = ctypes.c_int64
        self.library.contact_scratch.restype = ctypes.c_int64

    def impact(
        self,
        W: Array,
        before: Array,
        tangents: Sequence[int],
        coefficient: Sequence[float] | Array,
        restitution: Sequence[float] | Array,
    ) -> Impact:
        """Return the impact of contacts with these rows, rates before and numbers."""
        count, n = len(tangents), len(before)
        first = np.concatenate([[0], np.cumsum(np.add(tangents, 1))[:-1]])
        scratch = np.full(self.library.impact_scratch(n), np.nan)
        numbers = {
            "first": np.array(first, np.int32),
            "tangents": np.array(tangents, np.int32),
            "coefficient": np.array(coefficient, float),
            "restitution": np.array(restitution, float),
            "W": np.array(W, float),
            "before": np.array(before, float),
            "impulse": np.full(n, np.nan),
            "after": np.full(n, np.nan),
            "compression": np.full(count, np.nan),
            "expansion": np.full(count, np.nan),
            "scratch": scratch,
        }
        x = CImpact(
            contacts=count, rows=n, **{name: value.ctypes.data for name, value in numbers.items()}
        )
        failed = self.library.solve_impact(ctypes.byref(x))
        p, after = numbers["impulse"], numbers["after"]
        return Impact(
            failed=failed,
            impulse=p,
            after=after,
            compression=numbers["compression"],
            expansion=numbers["expansion"],
            friction=x.friction,
            plastic=x.plastic,
            loss=float(-p @ (np.asarray(before) + after) / 2),
            **{name: getattr(x, name) for name in ("jam", "several", "pieces", "newton")},
        )

    def contacts(
        self,
        W: Array,
        b: Array,
        tangents: Sequence[int],
        coefficient: Sequence[float] | Array,
        slides: Sequence[int] | None = None,
        way: Array | None = None,
        wanted: int = LEAST_WORK,
        shares: bool = True,
    ) -> tuple[int, Array, Array, int]:
        """Return failure, p, rates and whether there are several solutions."""
        count, n = len(tangents), len(b)
        first = np.concatenate([[0], np.cumsum(np.add(tangents, 1))[:-1]])
        numbers = {
            "first": np.array(first, np.int32),
            "tangents": np.array(tangents, np.int32),
            "coefficient": np.array(coefficient, float),
            "slides": np.array([0] * count if slides is None else slides, np.int32),
            "way": np.zeros(n) if way is None else np.array(way, float),
            "W": np.array(W, float),
            "b": np.array(b, float),
            "p": np.full(n, np.nan),
            "rate": np.full(n, np.nan),
            "scratch": np.full(self.library.contact_scratch(n), np.nan),
        }
        x = CContacts(
            contacts=count, rows=n, **{name: value.ctypes.data for name, value in numbers.items()}
        )
        failed = self.library.solve_contacts(ctypes.byref(x), wanted, int(shares))
        return failed, numbers["p"], numbers["rate"], x.several
