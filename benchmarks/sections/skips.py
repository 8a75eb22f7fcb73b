"""What each skip saves: kernels compiled without it, and scenes drawn so that it does not apply.

The kernel asks `hm_skips` wherever a step leaves out what a scene does not need; compiled with
-DHOLONOM_WITHOUT=<sum of bits> it does that work after all (`solver/kernel/internal.h`,
`docs/skips.md`). What is decided when a model is assembled is compared by pairs of scenes that move
alike.
"""

from __future__ import annotations

import ctypes
import tempfile
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import solver
from benchmarks.measuring.effort import Effort
from benchmarks.measuring.stepping import Repeated, in_equal_steps
from benchmarks.measuring.timing import Entry, Times, interleave
from benchmarks.pages.report import Section, Table, Value
from benchmarks.problems.mechanisms import (
    Content,
    chains_beside,
    four_bar,
    hanging_chain,
    scene,
    waving_chain,
)
from build_kernel.compiler import (
    DIMENSIONS,
    SOURCES,
    CompilerError,
    Kind,
    any_compiler,
    compile_library,
)
from scenes.generate import rigid_chain
from solver.options import step_of
from solver.runtime import Integrator, Model
from solver.runtime.kernel import load_library
from tests.support.kernel.kernel_calls import kernel_of

ROOT = Path(__file__).resolve().parents[2]
STEP = 1e-3
STEPS_TIMES_PARTS = 20_000

SKIPS = {
    "stiffness": 1,
    "factorisation": 2,
    "outer iteration": 4,
    "old guess": 8,
    "second link": 16,
    "measured forms": 32,
    "low penalty": 64,
    "islands": 128,
    "fresh factors": 256,
    "far contacts": 512,
}
"""Bits of `enum skip`, by their names in `docs/skips.md`."""
ALL = sum(SKIPS.values())

SOLVE, NOISE = ("µs per inner step", ".2f"), ("noise", ".2f")
METHOD = (
    "The same kernel compiled again without one skip each (docs/skips.md): CPU time of an inner "
    "step over that with all of them, and Newton iterations. Pairs of half steps, 1 ms a pair, "
    "after 20 pairs; Andrews' squeezer and the heavy top with their scenes' steps. What is decided "
    "at assembly is compared by two scenes that move alike."
)

# ---------------------------------------------------------------------------------- kernels


@cache
def variant(without: int, dimension: int) -> ctypes.CDLL:
    """Kernel of a dimension compiled without the skips of these bits, loaded; once a process.

    Raises
    ------
    CompilerError
        When there is no compiler, or it refuses; the text has the reason.
    """
    compiler = any_compiler()
    # A library that is loaded cannot be deleted on every system.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        target = Path(folder, f"without{without}.library")
        skipped = f"-DHOLONOM_WITHOUT={without}"
        compile_library(compiler, ROOT / SOURCES, Kind(dimension), target, skipped)
        return load_library(dimension, str(target))


def variants(bits: Iterable[int]) -> dict[tuple[int, int], ctypes.CDLL]:
    """Kernels by bits and dimension without the skips of these bits, two compiled at a time."""
    wanted = [(without, dimension) for without in bits for dimension in DIMENSIONS]
    with ThreadPoolExecutor(2) as pool:
        libraries = pool.map(lambda each: variant(*each), wanted)
        return dict(zip(wanted, libraries, strict=True))


def bound(model: Model, library: ctypes.CDLL) -> Integrator:
    """Integrator of a model on a kernel of one's own, ready for the first step."""
    integrator = Integrator(model, library=library)
    integrator.initialise()
    return integrator


# ------------------------------------------------------------------------------- mechanisms


def mechanisms(largest: int) -> dict[str, tuple[Model, int]]:
    """Models and numbers of parts, by name; chains of no more parts than `largest`."""
    found = {
        "double pendulum": (model_of(hanging_chain(2)), 2),
        "four-bar (A02), N = 2": (model_of(four_bar()), 5),
    }
    for name, parts in (("andrews", 7), ("heavy_top", 1)):
        found[name] = (solver.assemble(in_equal_steps(ROOT / "scenes" / f"{name}.toml")), parts)
    for n in (10, 100, 1000):
        if n <= largest and n > 10:
            found[f"spatial point chain, N = {n}"] = (model_of(waving_chain(n, 3)), n)
        if n <= min(largest, 100):
            drawn = solver.loads(rigid_chain(n), name="rigid_chain.toml", format="toml")
            found[f"spatial rigid chain, N = {n}"] = (solver.assemble(drawn), 5 * n)
    n = min(largest, 20)
    for name, angle in (("rest", 0.0), ("swing a little", 1e-3)):
        content = chains_beside(10, n, [1.5, *[angle] * 9])
        found[f"ten chains of {n}, nine {name}"] = (model_of(content), 10 * n)
    return found


def model_of(content: Content) -> Model:
    """Model of a content with steps of 1 ms."""
    return solver.assemble(scene(content, step_size=STEP))


def _repeated(integrator: Integrator, parts: int, effort: Effort) -> Repeated:
    count = effort.count(max(5, STEPS_TIMES_PARTS // parts), least=2)
    return Repeated(integrator, step_of(integrator.model.settings), count)


# ---------------------------------------------------------------------------------- sections


def measure(effort: Effort) -> Section:
    tables, remarks = _pairs(effort), []
    try:
        tables = [*_ablation(effort), *tables]
    except CompilerError as error:
        remarks.append(f"No kernels without skips: {error}")
    tables.append(_factors(effort))
    title = "What a scene does not need"
    return Section(name="skips", title=title, method=METHOD, tables=tables, remarks=remarks)


def _ablation(effort: Effort) -> list[Table]:
    """Times and iterations of every mechanism without each skip.

    Raises
    ------
    CompilerError
        When the kernels cannot be compiled.
    """
    columns = {"none": 0} | SKIPS | {"all": ALL}
    libraries = variants(columns.values())
    ratios: list[Mapping[str, Value]] = []
    iterations: list[Mapping[str, Value]] = []
    for name, (model, parts) in mechanisms(effort.largest).items():
        cases = {
            key: _repeated(bound(model, libraries[without, model.sizes["dim"]]), parts, effort)
            for key, without in columns.items()
        }
        able = {key: case.entry for key, case in cases.items() if not case.failure}
        times = interleave(able, effort)
        least = max(times["none"].minimum, 1e-9)
        start = {"mechanism": name, "solve": 1e6 * least / cases["none"].solves}
        ratio = {key: times[key].minimum / least for key in able if key != "none"}
        ratios.append(start | ratio | {"noise": times["none"].noise})
        iterations.append({"mechanism": name} | {key: cases[key].newton_per_solve for key in able})
    skips = {key: (key, ".2f") for key in columns if key != "none"}
    first, every = {"mechanism": "mechanism"}, {"none": ("all skips", ".2f")}
    return [
        Table(
            title="Time without a skip over time with all",
            columns=first | {"solve": SOLVE} | skips | {"noise": NOISE},
            rows=ratios,
        ),
        Table(
            title="Newton iterations per inner step without a skip",
            columns=first | every | skips,
            rows=iterations,
        ),
    ]


def _pairs(effort: Effort) -> list[Table]:
    rows: list[Mapping[str, Value]] = []
    for name, (cheap, dear, parts) in pairs(min(100, effort.largest)).items():
        cases = {"with": _repeated(_start(cheap), parts, effort)}
        cases["without"] = _repeated(_start(dear), parts, effort)
        rows.append(_pair(name, {key: c.entry for key, c in cases.items()}, cases["with"], effort))
    rows.append(_measuring(effort))
    columns = {
        "what": "what",
        "solve": SOLVE,
        "without": ("without the skip, µs", ".2f"),
        "ratio": ("ratio", ".2f"),
        "noise": NOISE,
    }
    return [Table(title="Decided at assembly or on request", columns=columns, rows=rows)]


def _start(model: Model) -> Integrator:
    return bound(model, load_library(model.sizes["dim"]))


def _pair(
    name: str, entries: Mapping[str, Entry], case: Repeated, effort: Effort
) -> dict[str, Value]:
    times: dict[str, Times] = interleave(entries, effort)
    least, more = (times[key].minimum for key in ("with", "without"))
    each = 1e6 / case.solves
    return {
        "what": name,
        "solve": each * least,
        "without": each * more,
        "ratio": more / max(least, 1e-9),
        "noise": times["with"].noise,
    }


def pairs(n: int) -> dict[str, tuple[Model, Model, int]]:
    """Two models that move alike, the second unable to skip something, and their parts."""
    rods, formulas = hanging_chain(2), hanging_chain(2)
    formulas["constraints"] = {
        "rod1": {"value": "P1.x**2 + P1.y**2 - 1"},
        "rod2": {"value": "(P2.x - P1.x)**2 + (P2.y - P1.y)**2 - 1"},
    }
    del formulas["joints"]
    load = {"type": "force", "point": "P2"}
    constant = rods | {"forces": {"load": load | {"value": [0.5, 0.0]}}}
    timed = rods | {"forces": {"load": load | {"value": ["0.5 + 0*t", 0.0]}}}
    return {
        f"third coordinate: point chain in the plane and in space, N = {n}": (
            model_of(waving_chain(n, 2)),
            model_of(waving_chain(n, 3)),
            n,
        ),
        "composites: double pendulum on rods and on formulas": (
            model_of(rods),
            model_of(formulas),
            2,
        ),
        "tape: a load on the double pendulum, constant and of time": (
            model_of(constant),
            model_of(timed),
            2,
        ),
    }


def _measuring(effort: Effort) -> dict[str, Value]:
    """Steps one by one, with and without measuring after each."""
    n = min(100, effort.largest)
    integrator = _start(model_of(waving_chain(n, 3)))
    case = _repeated(integrator, n, effort)

    def steps(after: Callable[[], object]) -> Callable[[], None]:
        def run() -> None:
            for _ in range(case.count):
                integrator.advance(integrator.time, STEP)
                after()

        return run

    prepare = case.entry.prepare
    entries = {
        "with": Entry(steps(lambda: None), prepare),
        "without": Entry(steps(kernel_of(integrator).measure), prepare),
    }
    return _pair(f"measurements: spatial point chain, N = {n}", entries, case, effort)


def _factors(effort: Effort) -> Table:
    """What the elimination order leaves of a dense matrix: a count, the same on every machine."""
    rows: list[Mapping[str, Value]] = []
    for name, (model, _) in mechanisms(effort.largest).items():
        unknowns = model.sizes["dim"] * model.sizes["n_free"] + model.sizes["n_rows"]
        entries = model.tables["lu_ptr"][-1]
        lean = model.sizes["n_lean_values"]
        rows.append({"mechanism": name, "unknowns": unknowns, "entries": entries,
                     "lean": float(lean) if lean else None, "dense": unknowns**2})  # fmt: skip
    columns = {
        "mechanism": "mechanism",
        "unknowns": ("unknowns", ".0f"),
        "entries": ("entries of the factors", ".0f"),
        "lean": ("of lean factors", ".0f"),
        "dense": ("of a dense matrix", ".0f"),
    }
    return Table(title="Entries that are stored", columns=columns, rows=rows)
