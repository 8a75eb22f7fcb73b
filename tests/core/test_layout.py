"""The declaration of a model and a state, the headers made of it, and the kernel compiled so."""

from __future__ import annotations

import gc
import re
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from build_kernel.model_tables import declared, headers, write_headers
from solver.options import OPTIONS
from solver.runtime import Integrator, kernel
from solver.runtime.layout import ABI, CONTACT_MODES, HEAD, SIZES
from solver.scene.quantities import CONTACT
from tests.support.kernel.twins import PENDULUM, model_of

SOLVER = Path(__file__).parents[2] / "solver"


def test_the_headers_of_the_kernel_are_made_of_the_present_declaration():
    for name, text in headers(SOLVER).items():
        assert (SOLVER / "kernel" / name).read_text("utf-8") == text, name


def test_a_field_has_its_length_and_its_comment_in_c():
    text = headers(SOLVER)["model_tables.h"]
    assert "\n    int32_t n_free; /* moving nodes that are unknown */\n" in text
    assert "\n    const int32_t *row_form; /* n_form_rows */\n" in text
    assert "\n    double *q; /* n: coordinates [m] */\n" in text
    assert "\n    S_HALVES, /* see predict.h */\n" in text
    assert "\n    HOLONOM_BAD_STEP = 6, /* step length is not a finite positive number */\n" in text


def test_one_line_of_the_layout_lets_time_integrate_another_vector(tmp_path):
    for name in ("options.py", "runtime/layout.py", "runtime/errors.py", "kernel/scratch.py"):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        text = (SOLVER / name).read_text("utf-8")
        path.write_text(text.replace("MOTION = {\n", 'MOTION = {\n    "z": "n_inputs",  # [1]\n'))
    made = headers(tmp_path)
    assert "    double *z; /* n_inputs: [1] */\n" in made["model_tables.h"]
    assert "    double *z_low; /* n_inputs */\n" in made["model_tables.h"]
    order = re.findall(r"x->(\w+) = block", made["section_tables.h"])
    assert order[:7] == ["head", "z", "q", "v", "z_low", "q_low", "v_low"]
    assert "n_motion = (int64_t)m->n_inputs + n + n;" in made["section_tables.h"]


def test_names_of_one_line_share_its_comment_and_a_comment_goes_on_below(tmp_path):
    path = tmp_path / "fields.py"
    path.write_text(
        'A = (\n    "a", "b",  # one\n    # line more\n    "c",\n)\nB = {"a": "c"}  # two\n'
    )
    values, notes = declared(path)
    assert values["A"] == ("a", "b", "c")
    assert notes == {("A", "a"): "one line more", ("A", "b"): "one line more", ("B", "a"): "two"}


def test_the_settings_lie_side_by_side_in_the_head_of_a_state():
    first, end = HEAD.index("step_size"), HEAD.index("horizon")
    assert {option.stored_as for option in OPTIONS.values()} == {*HEAD[first:end]}
    assert len(OPTIONS) == end - first
    assert SIZES[0] == "dim"


def test_a_kernel_of_another_version_is_not_taken(monkeypatch):
    monkeypatch.setattr(kernel, "ABI", ABI + 1)
    with pytest.raises(kernel.KernelMissingError, match="another version"):
        kernel.load_library(2)


def test_a_kernel_for_the_plane_is_not_taken_for_space():
    with pytest.raises(kernel.KernelMissingError, match="another version"):
        kernel.load_library(3, kernel.library_path(2))


def test_a_missing_kernel_is_reported_with_platform_and_remedy(monkeypatch, tmp_path):
    monkeypatch.setattr(kernel, "library_path", lambda _: str(tmp_path / "libholonom_planar.so"))
    kernel.shared_library.cache_clear()
    with pytest.raises(kernel.KernelMissingError) as missing:
        Integrator(model_of(PENDULUM))
    kernel.shared_library.cache_clear()
    said = str(missing.value)
    assert said.startswith(f"no kernel for this platform, {sysconfig.get_platform()} ({tmp_path}")
    assert said.endswith("; compile it: python -m build_kernel")


def test_headers_are_written_by_several_threads_at_a_time():
    def work(*_: object) -> None:
        """Let another thread run during a collection, as a callback of Hypothesis does."""
        for _ in range(20):
            pass

    usual, interval = gc.get_threshold(), sys.getswitchinterval()
    try:
        gc.callbacks.append(work)
        gc.set_threshold(20)
        sys.setswitchinterval(1e-6)
        for _ in range(8):
            with ThreadPoolExecutor(2) as pool:
                list(pool.map(write_headers, 2 * [SOLVER]))
    finally:
        gc.set_threshold(*usual)
        gc.callbacks.remove(work)
        sys.setswitchinterval(interval)


def test_modes_of_contacts_have_the_numbers_that_their_output_tells():
    (text,) = (offer.text for offer in CONTACT if offer.word == "mode")
    told = [f"{number} while .* {mode}" for number, mode in enumerate(CONTACT_MODES)]
    assert re.search(".*, ".join(told), text)
