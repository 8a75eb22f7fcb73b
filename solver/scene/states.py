"""Sampled states of a scene, which stand between the ticks of their clocks; controllers of them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from solver.scene import fields as kind
from solver.scene.expression import Number, operate, select, symbol
from solver.scene.fields import Part
from solver.scene.mistakes import Path
from solver.scene.parameters import TEXT, UNIT
from solver.scene.quantities import Offer
from solver.scene.rules import LOAD, POSITIVE, PROPERTY

if TYPE_CHECKING:
    from solver.scene.references import Reader

_SAMPLE_TIME = kind.Quantity("s", "time between ticks", POSITIVE, PROPERTY, 0.01)
_OFFSET = kind.Quantity("s", "time of a tick: they are at offset + k*sample_time", place=PROPERTY)


@dataclass(frozen=True, slots=True)
class Sampled:
    """A number that takes its next value at the ticks of its clock."""

    next: Number
    """Of the motion, time, inputs and states as they are just before the tick."""
    start: Number
    unit: str
    text: str
    listed: bool = True
    """Whether it is a variable of the model."""


@dataclass(frozen=True, slots=True, kw_only=True)
class State(Part):
    """A number that an expression sets anew at each tick of its clock."""

    type = "sampled"
    is_usual = True

    update: Annotated[Number, kind.Quantity("", "value from a tick on", None, LOAD, "count + 1")]
    sample_time: Annotated[Number, _SAMPLE_TIME]
    start: Annotated[Number, kind.Quantity("", "value before the first tick", place=PROPERTY)] = 0.0
    offset: Annotated[Number, _OFFSET] = 0.0
    unit: Annotated[str, UNIT] = ""
    description: Annotated[str, TEXT] = ""

    def sampled(self, name: str) -> Mapping[str, Sampled]:
        """Return the numbers that it consists of, by their names."""
        return {name: Sampled(self.update, self.start, self.unit, self.description)}


_VALUE = Offer("value", "", "output of the controller {name}", "state")
_INTEGRAL = Offer("integral", "", "integral part of the controller {name}", "state")


@dataclass(frozen=True, slots=True, kw_only=True)
class Pid(Part):
    """A sampled controller: value = kp error + integral - derivative, within min and max.

    At each tick the integral grows by sample_time (ki error + (value - value without limits) /
    tracking_time), after the value is calculated (back-calculation against wind-up; Åström and
    Hägglund, PID Controllers, 1995, 3.5). The derivative is that of the measurement, over a first
    order lag where `filter` is given.
    """

    type = "pid"
    offers = (_VALUE, _INTEGRAL)

    error: Annotated[Number, kind.Quantity("", "set point less measurement", None, LOAD, "1 - A.x")]
    measurement: Annotated[
        Number | None, kind.Quantity("", "what kd acts on, -error unless given", None, LOAD)
    ] = None
    kp: Annotated[Number, kind.Quantity("", "proportional gain", place=PROPERTY)] = 0.0
    ki: Annotated[Number, kind.Quantity("", "integral gain, per second", place=PROPERTY)] = 0.0
    kd: Annotated[Number, kind.Quantity("", "derivative gain, times second", place=PROPERTY)] = 0.0
    filter: Annotated[
        Number | None,
        kind.Quantity("1/s", "bandwidth of the derivative", POSITIVE, PROPERTY),
    ] = None
    min: Annotated[Number | None, kind.Quantity("", "least value", place=PROPERTY)] = None
    max: Annotated[Number | None, kind.Quantity("", "largest value", place=PROPERTY)] = None
    tracking_time: Annotated[
        Number | None, kind.Quantity("s", "of the integral at a limit", POSITIVE, PROPERTY)
    ] = None
    """None: at a limit the integral stands."""
    sample_time: Annotated[Number, _SAMPLE_TIME]
    offset: Annotated[Number, _OFFSET] = 0.0

    def check(self, reader: "Reader", path: Path, given: Any) -> None:
        """Check that it has a gain, and a limit where the integral is to follow one."""
        if all(getattr(given, x) is None for x in ("kp", "ki", "kd")):
            reader.draft.error(path, "a controller without kp, ki and kd does nothing", "give one")
        if given.tracking_time is not None and given.min is None and given.max is None:
            message = "has no effect without min or max"
            reader.draft.error((*path, "tracking_time"), message, "give one, or leave it out")

    def sampled(self, name: str) -> Mapping[str, Sampled]:
        """Return the numbers that it consists of, by their names."""
        integral, before, slope, begun = (
            symbol(f"{name}.{x}") for x in ("integral", "measurement", "derivative", "begun")
        )
        measurement = -1.0 * self.error if self.measurement is None else self.measurement
        change = select(begun, self.kd * (measurement - before), 0.0)
        if self.filter is None:
            derivative = change / self.sample_time
        else:
            derivative = (slope + self.filter * change) / (1.0 + self.filter * self.sample_time)
        free = self.kp * self.error + integral - derivative
        value = self._within(free)
        if self.tracking_time is None:
            is_free = operate("eq", value, free) if value is not free else 1.0
            grown = select(is_free, self.ki * self.error, 0.0)
        else:
            grown = self.ki * self.error + (value - free) / self.tracking_time
        texts = (offer.text.format(name=name) for offer in self.offers)
        return {
            f"{name}.value": Sampled(value, 0.0, "", next(texts)),
            f"{name}.integral": Sampled(integral + self.sample_time * grown, 0.0, "", next(texts)),
            f"{name}.measurement": Sampled(measurement, 0.0, "", "", listed=False),
            f"{name}.derivative": Sampled(derivative, 0.0, "", "", listed=False),
            f"{name}.begun": Sampled(1.0, 0.0, "", "", listed=False),
        }

    def _within(self, value: Number) -> Number:
        value = value if self.min is None else operate("max", value, self.min)
        return value if self.max is None else operate("min", value, self.max)


STATES: dict[str, type[Part]] = {state.type: state for state in (State, Pid)}
"""Types of states."""


def sampled_states(states: Mapping[str, Any]) -> Iterator[tuple[str, str, Any, Sampled]]:
    """Yield name, name of the part, part, and number of each sampled number of a scene."""
    for owner, state in states.items():
        for name, found in state.sampled(owner).items():
            yield name, owner, state, found
