"""An output that is no finite number is 0, alone, and said to be: never NaN, never in silence."""

from __future__ import annotations

from fmu_src import status
from tests.fmu_instance import PENDULUM, instance, text_fmu

TEXT = PENDULUM.format(length=1.0, mass=1.0, push="push").replace(
    "[experiment]", 'root = { value = "sqrt(0.05 - t)" }\n[experiment]'
)


def test_one_output_that_is_not_finite_leaves_the_others_as_they_are():
    with instance(text_fmu(TEXT)) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
        clock, reach, root = (fmu.references[name] for name in ("clock", "reach", "root"))
        place = fmu.references["A.y"]
        code = fmu.references["solver.status"]
        values = fmu.fmu.getReal([clock, root, reach, place, code])
        assert values[:3] == [0.1, 0.0, 1.0]
        assert values[3] < 0.0
        assert values[4] == status.NOT_FINITE
        assert any("root is not finite" in text for _, _, text in fmu.log)


def test_the_status_lasts_until_the_next_step():
    with instance(text_fmu(TEXT)) as fmu:
        fmu.initialise()
        fmu.step(0.0, 0.1)
        assert fmu.get("root") == 0.0
        assert fmu.get("solver.status") == status.NOT_FINITE
        assert fmu.step(0.1, 0.1)
        assert fmu.get("solver.status") == 0.0
