"""One mechanism in motion: parameters in, steps, named values out."""

from __future__ import annotations

import ctypes
import math
from array import array
from collections.abc import Callable, Sequence

from .assembly_checks import (
    broken_rules,
    contradicted_rows,
    equilibrium_problems,
    formulation_problems,
    rules_of_laws,
)
from .errors import SENTENCE, AssemblyError, OptionError, Status, StepError, at_the_start
from .kernel import Kernel
from .model import Model, Variable
from .options import DEFAULTS, decode, encode
from .remarks import Remarks
from .state import ASSEMBLED, CONFIGURED, MOVING, State
from .value_checks import check_settable, clipped

ROUNDING, STEP_SLACK = 8, 1e-6
"""A step begins at the present time, up to so many last digits of it and this part of a step."""

Value = float | str | bool


class Integrator:
    """A model with its state.

    Parameters
    ----------
    model : Model
        What to move.
    log : callable, optional
        Receives one sentence whenever something happens that a user should know; without it such a
        sentence is a RuntimeWarning.

    Raises
    ------
    KernelMissingError
        When no compiled kernel fits this platform, or it belongs to another version.
    """

    def __init__(self, model: Model, *, log: Callable[[str], None] | None = None) -> None:
        self.model, self._log = model, log
        self.engine = Kernel(model)
        self.state = State(model, self.engine.state)
        self._base = model.offsets["measured"]
        self._rules_of_laws = rules_of_laws(model)
        self.reset()

    def reset(self) -> None:
        """Return to the condition after construction."""
        ctypes.memset(self.state.block, 0, ctypes.sizeof(self.state.block))
        numbers = memoryview(self.model.numbers).cast("B")
        memoryview(self.engine.numbers).cast("B")[: len(numbers)] = numbers
        for variable in self.model.variables:
            if variable.kind in ("parameter", "input"):
                self._vector(variable)[variable.place] = variable.start  # type: ignore[assignment]
        for name, default in DEFAULTS.items():
            self._set_option(name, self.model.settings.get(name, default))
        start, stop, *_ = self.model.experiment
        self.state.head["time"], self.state.head["horizon"] = start, stop - start
        self.phase, self.message = CONFIGURED, SENTENCE[Status.OK]
        self._measured = False
        self._remarks = Remarks(self.model, self._log)

    # ------------------------------------------------------------------------------- values

    def _vector(self, variable: Variable) -> memoryview[float]:
        return self.state.vectors[f"{variable.kind}s"]

    def _set_option(self, name: str, value: object) -> None:
        place, number = encode(name, value)
        self.state.head[place] = number

    @property
    def time(self) -> float:
        """Present time [s]."""
        return self.state.head["time"]

    @property
    def status(self) -> Status:
        """Status of the last `advance`."""
        return Status(int(self.state.head["status"]))

    def get(self, indices: Sequence[int]) -> list[Value]:
        """Return the values of variables, by their index in ``model.variables``.

        Raises
        ------
        AssemblyError
            When an output is asked for and the mechanism cannot be assembled.
        StepError
            When a value is not finite.
        """
        values, numbers, base = [], self.engine.numbers, self._base
        for index in indices:
            variable = self.model.variables[index]
            kind, place = variable.kind, variable.place
            if kind in ("parameter", "input"):
                values.append(self._vector(variable)[place])
                continue
            if kind == "option":
                values.append(decode(variable.name.removeprefix("solver."), self.state.head))
                continue
            if not self._measured:
                self._measure()
            value = numbers[base + place] if kind == "measured" else numbers[place]
            if not math.isfinite(value):
                message = f"{variable.name} is not finite at t = {self.time:g} s"
                raise StepError(message)
            values.append(value)
        return values

    def __getitem__(self, name: str) -> Value:
        """Return the value of a variable by its name."""
        return self.get([self.model.index(name)])[0]

    def _measure(self) -> None:
        if self.phase == CONFIGURED:
            self.initialise()
        self.engine.measure()
        self._measured = True

    def set(self, indices: Sequence[int], values: Sequence[Value]) -> None:
        """Set parameters, inputs and settings; all of them or, on an error, none.

        Raises
        ------
        OptionError
            Naming the variable, the value and the rule that it breaks.
        """
        changes, cut = [], []
        for index, value in zip(indices, values, strict=True):
            variable = self.model.variables[index]
            check_settable(variable, value, moving=self.phase == MOVING)
            value, sentence = clipped(variable, value)
            changes.append((variable, value))
            cut.append((f"input {variable.name}", sentence))
        inputs, parameters = (list(self.state.vectors[name]) for name in ("inputs", "parameters"))
        for variable, value in changes:
            if variable.kind != "option":
                target = inputs if variable.kind == "input" else parameters
                target[variable.place] = float(value)
        # An input that arrives after the start is one for the step to come, not for the start.
        arriving = all(variable.kind == "input" for variable, _ in changes)
        if self.phase == MOVING or (self.phase == ASSEMBLED and arriving):
            self._turn(inputs, parameters)
        else:
            self.state.vectors["inputs"][:] = array("d", inputs)
            self.state.vectors["parameters"][:] = array("d", parameters)
            self.phase = CONFIGURED
        for variable, value in changes:
            if variable.kind == "option":
                self._set_option(variable.name.removeprefix("solver."), value)
        self._measured = False
        for about, sentence in cut:
            self._remarks.say(about, sentence)

    def _turn(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters in motion, unless a law would break its rule."""
        if not (self._rules_of_laws or self.model.sizes["variable_potential"]):
            self.engine.set_inputs(inputs, parameters)
            return
        blocks = (self.state.block, self.engine.numbers)
        before = [bytes(block) for block in blocks]
        self.engine.set_inputs(inputs, parameters)
        problems = broken_rules(self._rules_of_laws, self.engine.numbers)
        if not math.isfinite(self.state.head["work"]):
            problems.append("with these values a spring or potential has no finite energy")
        if problems:
            for block, kept in zip(blocks, before, strict=True):
                ctypes.memmove(block, kept, len(kept))
            raise OptionError("\n".join(problems))

    def __setitem__(self, name: str, value: Value) -> None:
        """Set a variable by its name."""
        self.set([self.model.index(name)], [value])

    # ------------------------------------------------------------------------------- motion

    def initialise(self, start_time: float | None = None) -> None:
        """Assemble the mechanism with the present parameters, at `start_time` [s].

        Raises
        ------
        AssemblyError
            One sentence for each rule that the parameters break.
        """
        if start_time is not None:
            self.state.head["time"] = start_time
        self._assemble()
        problems = contradicted_rows(self.model, self.engine)
        if problems:
            self.phase = CONFIGURED
            raise AssemblyError("\n".join(problems))

    def _evaluate(self) -> None:
        """Evaluate all numbers that depend on parameters, inputs and the time."""
        numbers, offsets = self.engine.numbers, self.model.offsets
        for name, section in (("input", "inputs"), ("parameter", "parameters")):
            for place, value in enumerate(self.state.vectors[section]):
                numbers[offsets[name] + place] = value
        numbers[offsets["time"]] = self.state.head["time"]
        self.engine.evaluate(0)
        self.engine.evaluate(1)

    def _assemble(self) -> None:
        """Evaluate the numbers, check them, and take the initial configuration."""
        self._evaluate()
        problems = broken_rules(self.model.rules, self.engine.numbers)
        problems += formulation_problems(self.model, str(decode("formulation", self.state.head)))
        problems += equilibrium_problems(self.model, self.state.head["equilibrium"])
        if problems:
            raise AssemblyError("\n".join(problems))
        status = Status(self.engine.initialise())
        if status is not Status.OK:
            sentence = at_the_start(status, bool(self.state.head["equilibrium"]))
            message = f"the mechanism cannot be assembled: {sentence}"
            raise AssemblyError(message)
        self.phase = ASSEMBLED
        self._measured = False

    def begin(self) -> None:
        """End the start: what is set from now on is for the step to come, as after a step.

        Else a tunable parameter that is set before the first step starts the mechanism anew.
        """
        if self.phase == ASSEMBLED:
            self.phase = MOVING

    def advance(self, t: float, step: float) -> None:
        """Advance from time `t`, which must be the present time, by `step`; both in s.

        Raises
        ------
        StepError
            When the step cannot be solved; time, h, reason and remedy in one sentence. The state
            is as before.
        """
        head = self.state.head
        finite = math.isfinite(t + step)
        slack = ROUNDING * math.ulp(t) + STEP_SLACK * abs(step) if finite else 0.0
        if not abs(t - head["time"]) <= slack:
            message = f"step from t = {t!r} s asked for, but the mechanism is at {head['time']!r} s"
            raise StepError(message)
        if not step > 0.0:
            self._fail(t, step, Status.BAD_STEP)
        if self.phase == CONFIGURED:
            self.initialise()
        # A last digit of t that differs from the own time must not add up over many steps.
        status = Status(self.engine.advance((t - head["time"]) + step))
        self._measured = False
        if status is not Status.OK:
            self._fail(t, step, status)
        head["time"] = t + step
        self.phase = MOVING
        self.message = SENTENCE[Status.OK]
        self._remarks.look(self.state, self.engine.numbers)

    def _fail(self, t: float, step: float, status: Status) -> None:
        self.state.head["status"] = float(status)
        self._measured = False
        head = self.state.head
        h = min(step, head["longest_step" if head["tolerance"] > 0.0 else "step_size"])
        self.message = f"step from t = {t:g} s with h = {h:g} s: {SENTENCE[status]}"
        raise StepError(self.message, status)

    # --------------------------------------------------------------------------- save, restore

    def save(self) -> bytes:
        """Return the whole state: motion, multipliers, ledger, inputs, parameters, settings."""
        return self.state.to_bytes(self.phase)

    def restore(self, data: bytes) -> None:
        """Return to a state that `save` gave, bit for bit.

        Raises
        ------
        OptionError
            When it is a state of another model, or damaged; the present one is then kept.
        """
        phase = self.state.phase_of(data)
        self.state.fill(data)
        if phase != CONFIGURED:
            # Numbers are no part of the state: those of parameters follow from it, nothing else is
            # asked again.
            self._evaluate()
        self.phase = phase
        self._measured = False
