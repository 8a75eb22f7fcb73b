"""The functions below an instance, one at a time: ``solver/kernel/holonom.h`` through ctypes."""

from __future__ import annotations

import ctypes
from array import array
from collections.abc import Sequence
from typing import Any

from solver.runtime import Integrator, Model
from solver.runtime.kernel import shared_library
from solver.runtime.layout import OFFSETS, SIZES, TABLES, measured_size, state_size
from tests.support.kernel.kernels_without_skips import kernel_without

Doubles = ctypes.Array[ctypes.c_double]


class ModelStruct(ctypes.Structure):
    """``holonom_model`` of the kernel's header, field by field."""

    _fields_ = [
        *((name, ctypes.c_int32) for name in SIZES),
        *((name, ctypes.c_void_p) for name in TABLES),
        *((f"{name}_at", ctypes.c_int32) for name in OFFSETS),
    ]


def doubles(values: Sequence[float]) -> Doubles:
    """Copy numbers; of none, one, so that there is an address."""
    content = array("d", values) or array("d", [0.0])
    return (ctypes.c_double * len(content)).from_buffer_copy(content)


def declared(library: ctypes.CDLL) -> ctypes.CDLL:
    """Declare the functions that only tests call."""
    pointer, integer, size = ctypes.c_void_p, ctypes.c_int32, ctypes.c_int64
    for name, result, arguments in (
        ("work_size", size, [pointer]),
        ("measured_size", size, [pointer]),
        ("evaluate", None, [pointer, pointer, integer]),
        ("initialise", integer, [pointer] * 4),
        ("residuals", None, [pointer] * 6),
        ("advance", integer, [*[pointer] * 4, ctypes.c_double, pointer, pointer]),
        ("set_inputs", None, [pointer] * 6),
        ("measure", None, [pointer] * 4),
    ):
        function = getattr(library, f"holonom_{name}")
        function.restype, function.argtypes = result, arguments
    return library


class Kernel:
    """A model bound to the kernel, with its own numbers, state and scratch, or those of a run.

    `numbers`, `state` and `work` are ctypes arrays of doubles; nothing in `work` survives a step.
    """

    def __init__(self, model: Model, library: ctypes.CDLL | None = None) -> None:
        self.model = model
        self._library = declared(library or shared_library(model.sizes["dim"]))
        self.numbers = doubles(model.numbers)
        self.state = (ctypes.c_double * state_size(model.sizes))()
        self._struct = ModelStruct(
            **model.sizes,
            **{name: table.buffer_info()[0] for name, table in model.tables.items()},
            **{f"{name}_at": offset for name, offset in model.offsets.items()},
        )
        structure = ctypes.addressof(self._struct)
        assert self._library.holonom_state_size(structure) == len(self.state)
        assert self._library.holonom_measured_size(structure) == measured_size(model.sizes)
        self.work = (ctypes.c_double * self._library.holonom_work_size(structure))()
        self._point()

    def _point(self) -> None:
        memory = (self._struct, self.numbers, self.state, self.work)
        self._pointers = tuple(map(ctypes.addressof, memory))

    def evaluate(self, segment: int) -> None:
        """Run one segment of the tape on the numbers."""
        self._library.holonom_evaluate(*self._pointers[:2], segment)

    def initialise(self) -> int:
        """Take the initial configuration into the state; return a status."""
        return self._library.holonom_initialise(*self._pointers, None)

    def advance(self, step: float) -> int:
        """Advance the state by `step` [s]; return a status."""
        return self._library.holonom_advance(*self._pointers, step, None, None)

    def measure(self) -> None:
        """Fill the measurements in the numbers from the state."""
        self._library.holonom_measure(*self._pointers, 255)

    def set_inputs(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters; a jump of stored energy is booked as work."""
        self._library.holonom_set_inputs(
            *self._pointers, doubles(inputs), doubles(parameters), doubles([0.0])
        )

    def residuals(self) -> tuple[list[float], list[float]]:
        """Return the residuals of the rows and their rates, each in the unit of its row."""
        phi, phi_dot = (doubles([0.0] * len(self.model.rows)) for _ in range(2))
        self._library.holonom_residuals(*self._pointers, phi, phi_dot)
        count = len(self.model.rows)
        return list(phi)[:count], list(phi_dot)[:count]

    def probe(
        self, h: float, w: Sequence[float], mu: Sequence[float], x: Sequence[float]
    ) -> tuple[int, list[float], list[float]]:
        """Return status, residual and tangent times `x` of one step: what `probe.c` adds."""
        library = kernel_without(0, self.model.sizes["dim"])
        assert library.holonom_model_bytes() == ctypes.sizeof(ModelStruct)
        size = len(w) + len(mu)
        r, tx = doubles([0.0] * size), doubles([0.0] * size)
        arguments = (ctypes.c_double(h), doubles(w), doubles(mu), doubles(x), r, tx)
        status = library.holonom_probe(*map(ctypes.c_void_p, self._pointers), *arguments)
        return status, list(r)[:size], list(tx)[:size]

    def half_step(self, h: float, half: int) -> int:
        """Take half step 0 or 1 of a pair, of length h [s]; return a status."""
        library = kernel_without(0, self.model.sizes["dim"])
        pointers = map(ctypes.c_void_p, self._pointers)
        return library.holonom_half_step(*pointers, ctypes.c_double(h), half)


def kernel_of(run: Any) -> Kernel:
    """Bind the kernel to the memory of an `Integrator`; or the kernel that a run by hand has."""
    if not isinstance(run, Integrator):
        return run.kernel
    kernel = Kernel(run.model)
    kernel.numbers, kernel.state, kernel.work = run.numbers, run.state.block, run.work
    kernel._point()
    return kernel
