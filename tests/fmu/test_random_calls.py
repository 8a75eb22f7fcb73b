"""Any sequence of states saved, restored, serialised and freed leaves what plain steps leave.

One instance is thrown back and forth between saved states; another one, which never sees one, is
given the steps and values that led to the present state, from its beginning. Both are FMUs in fmpy
and must agree bit for bit.
"""

from __future__ import annotations

import contextlib
import math
from typing import ClassVar

from hypothesis import HealthCheck, Phase, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from tests.fmu_instance import Instance, instance, text_fmu

SCENE = """
name = "random_calls"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = 1.0
stiffness = { value = 20.0, variability = "tunable", min = 0.0 }
[inputs]
push = { start = 0.0 }
lift = { start = 0.0, interpolation = "ramp" }
[points]
O = { position = [0, 0] }
A = { position = ["length", 0], mass = 1.0 }
B = { position = [3, 0], mass = 0.5 }
P = { position = [3, 1], fixed = true }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
wind = { type = "force", point = "A", value = ["sqrt(push + 4)", 0] }
rope = { type = "spring", points = ["B", "P"], stiffness = "stiffness", free_length = 0.5 }
drag = { type = "damper", points = ["B", "P"], damping = 0.3 }
[drivers]
hand = { type = "position", point = "O", value = ["0", "0.1*lift"] }
"""

Op = tuple
STEPS = st.sampled_from([0.1, 0.05, 0.01, 0.013, 1e-4, 0.25])
VALUES = {
    "push": st.sampled_from([0.0, 1.5, -3.0, 7.25]),
    "lift": st.sampled_from([0.0, 0.1, -0.2]),
    "stiffness": st.sampled_from([20.0, 35.5, 0.0]),
}


class Calls(RuleBasedStateMachine):
    """One instance with saved states, one without."""

    stack: ClassVar[contextlib.ExitStack] = contextlib.ExitStack()
    made: ClassVar[list[Instance]] = []

    def __init__(self) -> None:
        super().__init__()
        if not self.made:
            self.made.extend(self.stack.enter_context(instance(text_fmu(SCENE))) for _ in range(3))
        self.tried, self.plain, self.spare = self.made
        for each in self.made:
            each.fmu.reset()
            each.initialise()
        self.done: list[Op] = []
        self.repeated: list[Op] = []
        self.time = 0.0
        self.saved: list[tuple[object, list[Op], float]] = []
        self.bytes: list[tuple[bytes, list[Op], float]] = []

    @rule(h=STEPS)
    def step(self, h):
        if self.tried.step(self.time, h):  # a ramp within 0.1 ms can be more than a step can solve
            self.done.append(("step", self.time, h))
            self.time += h

    @rule(data=st.data(), name=st.sampled_from(sorted(VALUES)))
    def set(self, data, name):
        value = data.draw(VALUES[name])
        self.tried.set(**{name: value})
        self.done.append(("set", name, value))

    @rule(h=st.sampled_from([0.0, -0.1, math.nan]))
    def refused_step(self, h):
        assert not self.tried.step(self.time, h)

    @rule()
    def refused_value(self):
        before = self.tried.get("push")
        state = self.tried.fmu.getFMUState()
        self.tried.set(push=math.nan)
        assert not self.tried.step(self.time, 0.1)
        assert self.tried.get("push") == before
        self.tried.fmu.setFMUState(state)
        self.tried.fmu.freeFMUState(state)

    @rule()
    def failed_step(self):
        state = self.tried.fmu.getFMUState()
        self.tried.set(push=-9.0)
        assert not self.tried.step(self.time, 0.1)
        self.tried.fmu.setFMUState(state)
        self.tried.fmu.freeFMUState(state)

    @rule()
    def save(self):
        self.saved.append((self.tried.fmu.getFMUState(), list(self.done), self.time))

    @rule()
    def serialise(self):
        state = self.tried.fmu.getFMUState()
        self.bytes.append((self.tried.fmu.serializeFMUState(state), list(self.done), self.time))
        self.tried.fmu.freeFMUState(state)

    @precondition(lambda self: self.saved)
    @rule(data=st.data())
    def restore(self, data):
        state, done, time = data.draw(st.sampled_from(self.saved), "state")
        self.tried.fmu.setFMUState(state)
        self.done, self.time = list(done), time

    @precondition(lambda self: self.saved)
    @rule(data=st.data())
    def free(self, data):
        place = data.draw(st.integers(0, len(self.saved) - 1))
        self.tried.fmu.freeFMUState(self.saved.pop(place)[0])

    @precondition(lambda self: self.bytes)
    @rule(data=st.data(), elsewhere=st.booleans())
    def deserialise(self, data, elsewhere):
        text, done, time = data.draw(st.sampled_from(self.bytes), "bytes")
        if elsewhere:
            self.tried, self.spare = self.spare, self.tried
            self.saved.clear()  # a state belongs to the instance that gave it; bytes do not
        state = self.tried.fmu.deserializeFMUState(text)
        self.tried.fmu.setFMUState(state)
        self.tried.fmu.freeFMUState(state)
        self.done, self.time = list(done), time

    @invariant()
    def both_agree(self):
        self._repeat()
        assert self.tried.outputs()[:-1] == self.plain.outputs()[:-1]  # all but solver.status
        for name in VALUES:
            assert self.tried.get(name) == self.plain.get(name)

    def _repeat(self) -> None:
        """Bring the plain instance where the other one is, from its beginning if need be."""
        if self.done[: len(self.repeated)] != self.repeated:
            self.plain.fmu.reset()
            self.plain.initialise()
            self.repeated = []
        for kind, *operands in self.done[len(self.repeated) :]:
            if kind == "step":
                assert self.plain.step(*operands)
            else:
                self.plain.set(**{operands[0]: operands[1]})
        self.repeated = list(self.done)


TestCalls = Calls.TestCase
TestCalls.settings = settings(
    max_examples=60,
    stateful_step_count=40,
    deadline=None,
    derandomize=True,
    phases=[Phase.generate],  # to shrink what is found would take minutes
    suppress_health_check=list(HealthCheck),
)
