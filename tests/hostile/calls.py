"""Calls of FMI in any order, with any values: refused or taken, and never a wrong number after it.

An instance gets legal and illegal calls, a twin the legal ones alone. After an illegal call the
first one is brought back by a saved state or a reset; then all outputs agree bit for bit. It also
goes back to states saved long before, or goes on as another instance that is given its bytes; the
twin never sees a state, and repeats the calls that led there from the beginning.
A refused call to an FMU without Python (``native_calls``) changes nothing, so that nothing is
brought back after it; but a step that cannot be is an error, after which no step is taken.
Not tried: what ends pythonfmu's library itself (docs/fmu.md, section 5).
"""

from __future__ import annotations

import functools
import logging
import math
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import fmpy
from fmpy.fmi1 import FMICallException

import solver
from build_fmu import build
from build_fmu.fmpy_slaves import FMU2Run, FMU3Run
from build_fmu.instance import Log

SCENE = """
name = "random_calls"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = { value = 1.0, min = 0.01 }
stiffness = { value = 20.0, variability = "tunable", min = 0.0 }
[inputs]
push = { start = 0.0, min = -50, max = 50 }
pull = { start = 0.0, min = -5, max = 5, limit = "clip" }
lift = { start = 0.0, interpolation = "ramp" }
[points]
O = { position = [0, 0] }
A = { position = ["length", 0], mass = 1.0 }
B = { position = [3, 0], mass = 0.5 }
P = { position = [3, 1], fixed = true }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
wind = { type = "force", point = "A", value = ["sqrt(push + 100)", "pull"] }
rope = { type = "spring", points = ["B", "P"], stiffness = "stiffness", free_length = 0.5 }
drag = { type = "damper", points = ["B", "P"], damping = 0.3 }
[drivers]
hand = { type = "position", point = "O", value = ["0", "0.1*lift"] }
"""
KINDS = ("Real", "Integer", "Boolean", "String")
TIMES = (0.0, 1.0, -1.0, math.nan, math.inf, -math.inf, 1e300, 5e-324)
REALS = (*TIMES, 1e308, -1e308)
TEXTS = ("", "nonsense", "x" * 10000, "%s%n%d", "é", "midpoint-al\n")
STEPS = (0.01, 0.05, 0.003, 1e-6, 0.1)
FATAL = 4

Call = tuple[str, tuple[object, ...]]


class FatalError(Exception):
    """An FMI function answered fmi2Fatal; the text says which."""


def prepare(folder: Path) -> None:
    """Build and unpack an FMU."""
    fmpy.extract(str(build(solver.loads(SCENE), folder / "calls.fmu")), str(folder / "unpacked"))


@functools.cache
def _instances(folder: Path) -> tuple[Unit, Unit, Unit]:
    logging.getLogger("holonom").disabled = True
    return Unit(folder / "unpacked"), Unit(folder / "unpacked"), Unit(folder / "unpacked")


class Fmi3(FMU3Run):
    """A slave of FMI 3.0, called as one of FMI 2.0."""

    getInteger, setInteger = FMU3Run.getInt32, FMU3Run.setInt32  # noqa: N815
    experiment: tuple[float | None, ...] = None, 0.0, None

    def setupExperiment(self, *experiment: float | None) -> None:  # noqa: N802
        """Remember tolerance, start and stop for the call that takes them in FMI 3.0."""
        self.experiment = experiment

    def enterInitializationMode(self) -> None:  # noqa: N802
        """Enter it with what was set up."""
        super(FMU3Run, self).enterInitializationMode(*self.experiment)

    def reset(self) -> None:
        """Forget it."""
        super().reset()
        self.experiment = Fmi3.experiment

    def cancelStep(self) -> None:  # noqa: N802
        """Refuse what FMI 3.0 has not."""
        raise FMICallException(function="cancelStep", status=3)


class Unit:
    """An instance, whose calls answer with their result, or None where they are refused."""

    def __init__(self, folder: Path) -> None:
        description = fmpy.read_model_description(str(folder))
        variables = description.modelVariables
        self.is_native = not any(folder.glob("resources/holonom_*"))
        self.references = {v.name: v.valueReference for v in variables}
        self.outputs = [
            v.valueReference
            for v in variables
            if v.causality == "output" and v.name != "solver.status"
        ]
        assert description.coSimulation
        name = description.coSimulation.modelIdentifier
        kind = Fmi3 if description.fmiVersion == "3.0" else FMU2Run
        self.fmu: Any = kind(
            guid=description.guid, unzipDirectory=str(folder), modelIdentifier=name
        )
        self.fmu.make(Log())

    def call(self, name: str, *arguments: object) -> object:
        """Result of a function; True where it has none."""
        try:
            result = getattr(self.fmu, name)(*arguments)
        except FMICallException as error:
            if error.status == FATAL:
                text = f"{name}{arguments} is fatal"
                raise FatalError(text[:200]) from None
            return None
        return True if result in (None, 0) else result

    def set(self, name: str, value: float, kind: str = "Real") -> object:
        """Set one variable."""
        return self.call(f"set{kind}", [self.references[name]], [value])


class Sequence:
    """Calls of one case; the phase is 0 instantiated, 1 initializing, 2 stepping, 3 terminated."""

    def __init__(self, chance: random.Random, tried: Unit, plain: Unit, spare: Unit) -> None:
        self.chance, self.tried, self.plain, self.spare = chance, tried, plain, spare
        self.saved: list[tuple[object, list[Call], float]] = []
        self.start()

    def start(self) -> None:
        """Reset both."""
        self.forget()
        self.done: list[Call] = []
        self.both("reset")
        self.phase, self.time = 0, 0.0

    def both(self, name: str, *arguments: object) -> object:
        """Call a function of both, which must answer alike."""
        answers = [unit.call(name, *arguments) for unit in (self.tried, self.plain)]
        assert answers[0] == answers[1], f"{name}{arguments} answers {answers}"
        self.done.append((name, arguments))
        return answers[0]

    def forget(self) -> None:
        """Free the saved states."""
        for state, *_ in self.saved:
            self.tried.fmu.freeFMUState(state)
        self.saved = []

    def set_both(self, name: str, value: float, kind: str = "Real") -> None:
        """Set a variable of both."""
        self.both(f"set{kind}", [self.tried.references[name]], [value])

    def legal(self) -> None:
        """One call that is allowed now."""
        (self._before, self._initialising, self._stepping, self._after)[self.phase]()

    def _before(self) -> None:
        chance = self.chance
        kind = chance.randrange(4)
        if kind == 0:
            self.both("setupExperiment", None, 0.0, 1e9)
        elif kind == 1:
            self.set_both("length", chance.uniform(0.5, 2.0))
        elif kind == 2:
            self.set_both("solver.order", chance.choice([2.0, 4.0]))
        else:
            self.both("enterInitializationMode")
            self.phase = 1

    def _initialising(self) -> None:
        chance = self.chance
        kind = chance.randrange(3)
        if kind == 0:
            self.set_both("push", chance.uniform(-5.0, 5.0))
        elif kind == 1:
            self.set_both("solver.assemble", chance.choice([False, True]), "Boolean")
        else:
            self.both("exitInitializationMode")
            self.phase = 2

    def _stepping(self) -> None:
        chance = self.chance
        kind = chance.randrange(15)
        ranges = {"stiffness": 50.0, "push": 5.0, "pull": 9.0, "lift": 0.1}
        if kind < 4:
            name = list(ranges)[kind]
            low = 0.0 if name == "stiffness" else -ranges[name]
            self.set_both(name, chance.uniform(low, ranges[name]))
        elif kind == 4:
            self._there_and_back()
        elif kind == 5 and chance.random() < 0.1:
            self.both("terminate")
            self.phase = 3
        elif kind == 6:
            self.saved.append((self.tried.fmu.getFMUState(), [*self.done], self.time))
        elif kind == 7 and self.saved:
            self._long_back()
        elif kind == 8:
            self._elsewhere()
        else:
            step = chance.choice(STEPS)
            if self.both("doStep", self.time, step):
                self.time += step

    def _after(self) -> None:
        if self.chance.random() < 0.3:
            self.start()

    def _there_and_back(self) -> None:
        fmu = self.tried.fmu
        state = fmu.getFMUState()
        for _ in range(self.chance.randrange(3)):
            self.tried.call("doStep", self.time, 0.01)
        if self.chance.random() < 0.5:
            data = fmu.serializeFMUState(state)
            fmu.freeFMUState(state)
            state = fmu.deserializeFMUState(data)
        fmu.setFMUState(state)
        fmu.freeFMUState(state)

    def _long_back(self) -> None:
        state, done, self.time = self.chance.choice(self.saved)
        self.tried.fmu.setFMUState(state)
        self.done = [*done]
        for name, arguments in done:
            self.plain.call(name, *arguments)

    def _elsewhere(self) -> None:
        state = self.tried.fmu.getFMUState()
        data = self.tried.fmu.serializeFMUState(state)
        self.tried.fmu.freeFMUState(state)
        self.forget()  # a state belongs to the instance that gave it; bytes do not
        self.tried, self.spare = self.spare, self.tried
        for call in (("reset",), ("setupExperiment", None, 0.0, 1e9)):
            self.tried.call(*call)
        self.tried.call("enterInitializationMode")
        self.tried.call("exitInitializationMode")
        state = self.tried.fmu.deserializeFMUState(data)
        self.tried.fmu.setFMUState(state)
        self.tried.fmu.freeFMUState(state)

    def illegal(self) -> None:
        """One call that is refused, or whose effect a saved state takes back."""
        calls: list[Callable[[], object]] = [
            self._bad_step,
            self._bad_order,
            self._bad_read,
            self._bad_value,
            self._bad_state,
        ]
        state = self.tried.fmu.getFMUState() if self.phase else None
        is_changed = self.chance.choice(calls)() or not self.tried.is_native
        if self.phase == 2 and self.chance.random() < 0.5:
            is_changed = self.tried.call("doStep", self.time, 0.01) or is_changed
        if state is None:
            if is_changed:
                self.start()
            return
        if is_changed:
            self.tried.fmu.setFMUState(state)
        self.tried.fmu.freeFMUState(state)

    def _bad_step(self) -> bool:
        """Try a step that cannot be; whether it has ended the run."""
        chance = self.chance
        time, step = chance.choice([self.time, *TIMES]), chance.choice([0.0, -0.1, *TIMES, 1e10])
        near = abs(time - self.time) <= 1e-5 * (1.0 + abs(time))  # taken up to round-off of a step
        if near and 0.0 < step < 1e9 and self.phase == 2:
            step = -step
        assert not self.tried.call("doStep", time, step), f"doStep({time}, {step}) was taken"
        if self.phase != 2 or not self.tried.is_native:
            return False
        if step < 1e9:  # a longer one may be discarded, for its many internal steps
            taken = self.tried.call("doStep", self.time, 0.01)
            assert not taken, "a step was taken after an error"
        return True

    def _bad_order(self) -> object:
        chance = self.chance
        early = {1: "exitInitializationMode", 0: "enterInitializationMode", 2: "terminate"}
        names = [name for phase, name in early.items() if phase != self.phase]
        name = chance.choice([*names, "setupExperiment", "cancelStep"])
        times = [chance.choice([None, *TIMES]) for _ in range(3)]
        if name == "setupExperiment":
            times[1] = times[1] or 0.0
        return self.tried.call(name, *(times if name == "setupExperiment" else ()))

    def _bad_read(self) -> None:
        chance, kind = self.chance, self.chance.choice(KINDS)
        references = [chance.choice(self._references()) for _ in range(chance.randrange(4))]
        values = self.tried.call(f"get{kind}", references)
        if kind == "Real" and isinstance(values, list):
            assert all(map(math.isfinite, values)), f"getReal({references}) gave {values}"

    def _bad_value(self) -> object:
        chance, kind = self.chance, self.chance.choice(KINDS)
        references = [chance.choice(self._references()) for _ in range(chance.randrange(1, 4))]
        values = {"Real": REALS, "Integer": (0, -1, 2**31 - 1), "Boolean": (False, True)}
        given = [chance.choice(values.get(kind, TEXTS)) for _ in references]
        return self.tried.call(f"set{kind}", references, given)

    def _references(self) -> list[int]:
        known = list(self.tried.references.values())
        return [*known, *known, len(known), 10**6, 2**31, 2**32 - 1]

    def _bad_state(self) -> None:
        chance, fmu = self.chance, self.tried.fmu
        good = fmu.getFMUState()
        data = bytearray(fmu.serializeFMUState(good))
        fmu.freeFMUState(good)
        place = chance.randrange(len(data))
        if chance.random() < 0.5:
            data[place] ^= 1 << chance.randrange(8)
        else:
            data[place : place + chance.randrange(1, 99)] = chance.randbytes(chance.randrange(9))
        try:
            state = fmu.deserializeFMUState(bytes(data))
            fmu.setFMUState(state)
            fmu.freeFMUState(state)
        except FMICallException:
            if self.tried.is_native:
                return
        assert not self.tried.call("doStep", self.time, 0.01), "a damaged state was taken"

    def compare(self) -> None:
        """Read all outputs of both, which must agree."""
        if self.phase == 0:
            return
        values = [unit.call("getReal", unit.outputs) for unit in (self.tried, self.plain)]
        assert values[0] == values[1], f"outputs differ in phase {self.phase} at t = {self.time}"


def case(seed: str, number: int, folder: Path) -> str | None:
    """Make some calls."""
    chance = random.Random(f"{seed}/{number}")
    try:
        sequence = Sequence(chance, *_instances(folder))
        for _ in range(chance.randrange(10, 50)):
            (sequence.illegal if chance.random() < 0.4 else sequence.legal)()
            if chance.random() < 0.3:
                sequence.compare()
        sequence.compare()
        sequence.forget()
    except FatalError as error:
        _instances.cache_clear()
        return str(error)
    except AssertionError as error:
        return str(error)[:300]
    return None
