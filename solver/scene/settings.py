"""Settings of the solver and of the default run: choices, ranges and how the steps relate."""

from dataclasses import dataclass, field, make_dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.options import OPTIONS, USUAL_STEP, Option, tolerance_of
from solver.scene import fields as kind
from solver.scene.fields import BROKEN, Part, fields_of
from solver.scene.rules import POSITIVE, Rule

if TYPE_CHECKING:
    from solver.scene.references import Reader

_TOLERANCE = Rule(
    OPTIONS["tolerance"].holds,
    f"0 or from {OPTIONS['tolerance'].least:g} to {OPTIONS['tolerance'].high:g}",
    "write for instance tolerance = 1e-6, the error of the run relative to size and speed; no run "
    f"comes closer than round-off, some {OPTIONS['tolerance'].least:g}",
)
ROWS, MOST_INTERNAL_STEPS = 100, 10
"""Communication steps of a default run, and the most internal steps in one of them."""


def _kind(option: Option) -> kind.Kind:
    """Kind of the field of a setting; its numbers contain no symbols."""
    text = option.meaning
    if option.words or option.allowed:
        words = option.words or tuple(map(int, option.allowed))
        help = f"use {option.rule}" if option.allowed else ""
        return kind.Choice(text=text, words=words, help=help)
    if option.is_switch:
        return kind.Plain(text=text, type=bool)
    rule = (
        _TOLERANCE
        if option.name == "tolerance"
        else Rule(option.holds, option.limits, option.below)
    )
    if option.whole:
        return kind.Plain(text=text, type=int, rule=rule)
    return kind.setting(option.unit, text, rule, float(option.default))


if TYPE_CHECKING:

    @dataclass(frozen=True)
    class SolverSettings(Part):
        """The settings of `solver.options`."""

        def __init__(self, **settings: Any) -> None: ...
        def __getattr__(self, name: str) -> Any: ...

else:
    SolverSettings = make_dataclass(
        "SolverSettings",
        [
            (name, Annotated[type(o.default), _kind(o)], field(default=o.default))
            for name, o in OPTIONS.items()
        ],
        bases=(Part,),
        frozen=True,
        kw_only=True,
    )
    SolverSettings.__module__ = __name__
    SolverSettings.__doc__ = "The method and its settings; each is a parameter of the FMU."


@dataclass(frozen=True, slots=True, kw_only=True)
class Experiment(Part):
    """Default run of the FMU."""

    start_time: Annotated[float, kind.setting("s")] = 0.0
    stop_time: Annotated[
        float, kind.setting("s", "one second after the start unless given", required=False)
    ] = 1.0
    step_size: Annotated[
        float,
        kind.setting(
            "s", "of the FMU; 1 to 10 of the solver's by default", POSITIVE, required=False
        ),
    ] = 0.1
    tolerance: Annotated[
        float | None, kind.setting(text="that the FMU suggests to importers", rule=_TOLERANCE)
    ] = None


def _names(example: list[str]) -> kind.ListOf:
    text = "names, or patterns such as 'tip.*', of those that are ports; all unless given"
    return kind.ListOf(text=text, item=kind.NAME, example=example)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ports(Part):
    """Variables that an importer of the FMU sees as its ports; it can read the others, too."""

    outputs: Annotated[tuple[str, ...] | None, _names(["tip.*", "energy.error"])] = None
    inputs: Annotated[tuple[str, ...] | None, _names(["push"])] = None
    parameters: Annotated[tuple[str, ...] | None, _names(["length"])] = None


def read_ports(reader: "Reader") -> Ports:
    """Read the table [fmu]. Which variables there are is known when the FMU is built."""
    given = reader.draft.part(("fmu",), Ports, reader.draft.table("fmu"))
    chosen = {name: getattr(given, name) for name in fields_of(Ports)}
    return Ports(
        **{name: x if x is None or x is BROKEN else tuple(x) for name, x in chosen.items()}
    )


def read_settings(reader: "Reader") -> tuple[SolverSettings, Experiment]:
    """Read the tables [solver] and [experiment]."""
    solver, run = (
        reader.draft.part((name,), part, reader.draft.table(name))
        for name, part in (("solver", SolverSettings), ("experiment", Experiment))
    )

    def seconds(part: type[Part], table: str, name: str, default: float) -> float:
        given, own = solver if part is SolverSettings else run, fields_of(part)[name].kind
        return reader.constant((table, name), getattr(given, name), default, own.rule, own.unit)

    outer = seconds(Experiment, "experiment", "step_size", 0.0)
    inner = seconds(SolverSettings, "solver", "step_size", 0.0)
    if 0.0 < outer < inner:
        message = f"must be at most the communication step {outer:g} s, got {inner:g} s"
        reader.draft.error(("solver", "step_size"), message)
    solver.step_size = None
    settings = reader.fields(SolverSettings, ("solver",), solver) | {"step_size": inner}
    start = seconds(Experiment, "experiment", "start_time", 0.0)
    stop = seconds(Experiment, "experiment", "stop_time", start + 1.0)
    if not stop > start:
        message = f"must be > start_time = {start:g} s, got {stop:g}"
        reader.draft.error(("experiment", "stop_time"), message)
    tolerance = reader.constant(("experiment", "tolerance"), run.tolerance, 0.0, _TOLERANCE)
    chosen = SolverSettings(**settings)
    if tolerance and tolerance > (own := tolerance_of(chosen.__dict__)):
        message = "has no effect on steps of fixed length, which this scene has"
        if own:
            message = f"has no effect: the steps of this scene are for {own:g}, which is tighter"
        help = f"write tolerance = {tolerance:g} in [solver], which chooses order and steps"
        reader.draft.warn(("experiment", "tolerance"), message, help)
    # Whole internal steps, so that the communication step does not change the motion.
    counts, whole = range(1, MOST_INTERNAL_STEPS + 1), (stop - start) * (1.0 + 1e-9)
    usual = inner or USUAL_STEP
    steps = max((k for k in counts if ROWS * k * usual <= whole), default=1)
    step = outer or steps * usual
    experiment = Experiment(
        start_time=start, stop_time=stop, step_size=step, tolerance=tolerance or None
    )
    return chosen, experiment
