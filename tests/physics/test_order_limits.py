"""Where steps follow neither the tolerance nor the order that is set, somebody hears of it."""

from __future__ import annotations

import logging
import warnings

import pytest

import solver
from build_fmu.command_line import main
from fmu_src.status import LOGGER
from tests.support.fmus.fmu_instance import instance, text_fmu

PART = """
[points.{name}]
position = [{x}, 0]
mass = 1.0
velocity = [0, 1]
[points.{name}0]
position = [{x}, -1]
fixed = true
[forces.spring_{name}]
type = "spring"
points = ["{name}0", "{name}"]
stiffness = 20.0
free_length = 1.1
[forces.damper_{name}]
type = "damper"
points = ["{name}0", "{name}"]
damping = {damping}
"""
HEAD = """
name = "parts"
dimension = 2
[experiment]
stop_time = 0.2
step_size = 0.1
[solver]
{setting}
"""


LIMITED = 'tolerance = 1e-7\ncontact_mode = "stepped"'
"""With `TOUCHES`, a setting that takes equal steps."""

TOUCHES = """
[contacts]
wall = { type = "plane", point = "A", axis = [0, -1], position = [0, 9] }
"""


def text(setting: str, parts: int = 2, damping: float = 0.3, more: str = "") -> str:
    if setting == LIMITED:
        more = TOUCHES
    shown = [PART.format(name="AB"[i], x=3.0 * i, damping=damping) for i in range(parts)]
    return "".join([HEAD.format(setting=setting), *shown, more])


def said(setting: str, **options) -> list[str]:
    """Sentences of three steps."""
    model = solver.assemble(solver.loads(text(setting, **options)))
    sentences: list[str] = []
    run = solver.Integrator(model, log=sentences.append)
    for _ in range(3):
        run.advance(run.time, 0.1)
    return sentences


def test_a_tolerance_that_chooses_no_steps_says_so_once():
    (sentence,) = said(LIMITED)
    assert sentence.startswith("the tolerance is 1e-07, but steps in which contacts change")
    assert "equal steps of at most solver.step_size = 0.01 s" in sentence


@pytest.mark.parametrize(
    ("setting", "options"),
    [
        ("", {}),
        ("order = 2", {}),
        ("order = 2\ntolerance = 1e-5", {}),
        ("order = 4", {"damping": 0.0}),
        ("order = 4", {"parts": 1}),
        ("order = 4", {}),
        ("order = 8", {}),
        ("tolerance = 1e-5", {}),
        ("tolerance = 1e-5", {"damping": 0.0}),
        ("tolerance = 1e-5", {"parts": 1}),
        ("tolerance = 0.1", {"parts": 1}),
    ],
    ids=str,
)
def test_where_nothing_is_limited_nothing_is_said(setting, options):
    assert not said(setting, **options)


def test_without_a_log_it_is_a_warning():
    scene = solver.loads(text(LIMITED))
    with pytest.warns(
        RuntimeWarning, match="the tolerance is 1e-07, but steps in which contacts change"
    ) as told:
        solver.simulate(scene)
    assert told[0].filename == __file__  # at the line that asked for the run
    run = solver.Integrator(solver.assemble(scene))
    with pytest.warns(RuntimeWarning, match="are equal steps"):
        run.advance(0.0, 0.1)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run.advance(run.time, 0.1)


def test_a_step_too_long_for_its_order_is_no_warning_but_said_in_a_log():
    # Half a period of the spring in a step: weights tell nothing of it, and it is of order 2.
    model = solver.assemble(solver.loads(text("order = 4", parts=1)))
    sentences: list[str] = []
    for log in (None, sentences.append):
        run = solver.Integrator(model, log=log)
        run["solver.step_size"] = 1.0
        run.advance(0.0, 2.0)
        assert run["solver.order_in_use"] == 2.0
    assert len(sentences) == 1


def test_an_fmu_says_it_with_its_log_off_to_the_logger_of_python(caplog):
    with instance(text_fmu(text(LIMITED)), logging=False) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
    (record,) = [each for each in caplog.records if each.name == LOGGER]
    assert record.levelno == logging.WARNING
    assert record.getMessage().startswith("FMU parts: the tolerance is 1e-07, but steps")


def test_who_builds_it_on_the_command_line_reads_it(capsys, tmp_path):
    scene = tmp_path / "parts.toml"
    scene.write_text(text(LIMITED))
    assert main(["build", str(scene), "-o", str(tmp_path / "parts.fmu")]) == 0
    assert (
        "parts: the tolerance is 1e-07, but steps in which contacts change"
        in capsys.readouterr().err
    )
