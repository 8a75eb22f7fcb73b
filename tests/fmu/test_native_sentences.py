"""What a native FMU says is what the FMU with Python says, word by word."""

from __future__ import annotations

import contextlib
import math

import pytest
from fmpy.fmi1 import FMICallException

from tests.fmu.test_state_machine import CALLS, SCENE, STATES
from tests.fmu_instance import Instance, instance, scene_fmu, text_fmu

OWN = {"set a state of other bytes"}
"""Of these a native FMU knows more, or less: it keeps its states in another form."""


def said_at(fmu: Instance, call) -> list[str]:
    first = len(fmu.log)
    with contextlib.suppress(FMICallException):
        call(fmu)
    return [text for level, _, text in fmu.log[first:] if level > 0]


@pytest.mark.parametrize("name", [name for name in CALLS if name not in OWN])
def test_a_refused_call_is_told_in_the_same_words(name):
    call, _ = CALLS[name]
    with instance(text_fmu(SCENE)) as python, instance(text_fmu(SCENE, native=True)) as native:
        for state in STATES:
            for fmu in (python, native):
                fmu.fmu.reset()
                state(fmu)
            expected = said_at(python, call)
            assert said_at(native, call) == expected, state


VALUES = {
    "four_bar": {
        "solver__order": [3.0, -2.0, 1e9],
        "solver__start": [
            "drawing",
            "nonsense",
            "it's",
            'a "word"',
            "50 %",
            "Grün\n\t\\",
            "",
        ],
        "solver__step_size": [0.0, -1.0, math.inf, math.nan, 1e300],
        "drive": [math.nan, 1e308, 5.0],
    },
    "pendulum": {"solver__tolerance": [1.0, -1.0, 1e-300], "solver__assemble": [False, True]},
}


@pytest.mark.parametrize("scene", VALUES)
def test_a_refused_value_is_told_in_the_same_words(scene):
    """A native FMU answers at the call; the other one lets no step pass until it is set well."""
    with instance(scene_fmu(scene)) as python, instance(scene_fmu(scene, native=True)) as native:
        told = 0
        for name, values in VALUES[scene].items():
            for value in values:
                expected = said_at(python, lambda fmu: fmu.set(**{name: value}))  # noqa: B023
                assert said_at(native, lambda fmu: fmu.set(**{name: value})) == expected  # noqa: B023
                told += len(expected)
        assert told > 2


IMPOSSIBLE = """
name = "impossible"
dimension = 2
gravity = [0, -9.81]
[parameters]
length = { value = 1.0 }
stiffness = { value = 5.0, variability = "tunable" }
[points]
O = { position = [0, 0], fixed = true }
A = { position = [1, 0], mass = "length" }
B = { position = [2, 0], mass = "length" }
[joints]
rod = { type = "distance", points = ["O", "A"], length = "length" }
bar = { type = "distance", points = ["A", "B"], length = "length" }
[forces]
rope = { type = "spring", points = ["O", "B"], stiffness = "stiffness", free_length = 0.5 }
"""


@pytest.mark.parametrize("values", [{"length": -1.0}, {"length": 2.0}, {"stiffness": -3.0}])
def test_a_start_that_cannot_be_is_told_in_one_line_with_each_remedy_once(values):
    fmus = (instance(text_fmu(IMPOSSIBLE, native=native)) for native in (False, True))
    with next(fmus) as python, next(fmus) as native:
        first, second = (said_at(fmu, lambda f: f.initialise(**values)) for fmu in (python, native))
        assert first == second
        assert first


def test_warnings_of_a_run_are_told_in_the_same_words():
    """An input beyond its limits is clipped, once with a word; a discarded step has its reason."""
    scene = SCENE.replace("push = { start = 0.0", 'push = { max = 2.0, limit = "clip", start = 0.0')
    with instance(text_fmu(scene)) as python, instance(text_fmu(scene, native=True)) as native:
        for fmu in (python, native):
            fmu.initialise(push=5.0)
            fmu.run(0.0, 0.1, 2)
            fmu.set(push=-4.0)
            assert not fmu.step(0.2, 0.1)
        told = [[line for line in fmu.log if line[0] > 0] for fmu in (python, native)]
        assert told[0] == told[1]
        assert len(told[0]) == 2
