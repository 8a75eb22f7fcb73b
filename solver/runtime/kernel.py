"""The compiled kernel through ctypes: one crossing a call, pointers stored once."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from array import array
from collections.abc import Sequence

from .layout import ABI, OFFSETS, SIZES, TABLES, measured_size, state_size
from .model import Model

Doubles = ctypes.Array[ctypes.c_double]


class KernelMissingError(Exception):
    """There is no compiled kernel for this platform, or it does not load."""


class _ModelStruct(ctypes.Structure):
    """``holonom_model`` of the kernel's header, field by field."""

    _fields_ = [
        *((name, ctypes.c_int32) for name in SIZES),
        *((name, ctypes.c_void_p) for name in TABLES),
        *((f"{name}_at", ctypes.c_int32) for name in OFFSETS),
    ]


def library_path(dimension: int) -> str:
    """Return where the kernel of this platform for models of this dimension lies when built."""
    suffix = {"win32": "dll", "cygwin": "dll", "darwin": "dylib"}.get(sys.platform, "so")
    kind = "planar" if dimension == 2 else "spatial"
    return os.path.join(os.path.dirname(__file__), "_kernel", f"libholonom_{kind}.{suffix}")


def _other(path: str) -> str:
    return f"{path} belongs to another version of this Python code; build it again"


def _missing(path: str, error: OSError) -> str:
    """Return why a library does not load: this platform, those of the kernels here, the remedy."""
    import sysconfig  # only here: it would take a tenth of the time to import all this

    folder, name = os.path.split(path)
    stem = os.path.splitext(name)[0]
    try:
        names = sorted(n for n in os.listdir(folder) if os.path.splitext(n)[0] == stem)
    except OSError:
        names = []
    platforms = ", ".join(library_platform(os.path.join(folder, n)) for n in names)
    carried = f"a kernel for {platforms}" if names else "no kernel"
    loads = f" ({error})" if name in names else ""
    return (
        f"no kernel for this platform, {sysconfig.get_platform()}: the folder {folder} has "
        f"{carried}{loads}; build the FMU on this platform, or compile the kernel: "
        "python -m build_kernel"
    )


def library_platform(path: str) -> str:
    """Return the platform of a shared library as its first bytes have it, as sysconfig names it."""
    with open(path, "rb") as file:
        head = file.read(4096)
    portable = int.from_bytes(head[60:64], "little") + 4  # where Windows has the machine
    for magic, at, platforms in (
        (b"\x7fELF", 18, {62: "linux-x86_64", 183: "linux-aarch64"}),
        (b"MZ", portable, {0x8664: "win-amd64", 0xAA64: "win-arm64"}),
        (b"\xcf\xfa\xed\xfe", 4, {7: "macosx-x86_64", 12: "macosx-arm64"}),
    ):
        machine = int.from_bytes(head[at : at + 2], "little")
        if head.startswith(magic) and machine in platforms:
            return platforms[machine]
    return f"another machine ({os.path.basename(path)})"


def load_library(dimension: int, path: str | None = None) -> ctypes.CDLL:
    """Load the kernel for models of this dimension, 2 or 3, and declare its functions.

    Raises
    ------
    KernelMissingError
        When the library is absent, is for another machine, or was built from other sources.
    """
    path = path or library_path(dimension)
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise KernelMissingError(_missing(path, error)) from error
    pointer, integer, real = ctypes.c_void_p, ctypes.c_int32, ctypes.c_double
    for name, result, arguments in (
        ("abi", integer, []),
        ("dimension", integer, []),
        ("model_bytes", ctypes.c_int64, []),
        ("state_size", ctypes.c_int64, [pointer]),
        ("work_size", ctypes.c_int64, [pointer]),
        ("measured_size", ctypes.c_int64, [pointer]),
        ("instance_size", ctypes.c_int64, [pointer, ctypes.c_int64, pointer, ctypes.c_int64]),
        ("make", pointer, [pointer, ctypes.c_int64, pointer, integer]),
        ("reset", None, [pointer]),
        ("message", ctypes.c_char_p, [pointer]),
        ("remarks", ctypes.c_char_p, [pointer]),
        ("get", integer, [pointer, pointer, integer, pointer]),
        ("set", integer, [pointer, pointer, integer, pointer, pointer]),
        ("word", ctypes.c_char_p, [pointer, integer, real]),
        ("number_of_word", real, [pointer, integer, ctypes.c_char_p]),
        ("assemble", integer, [pointer]),
        ("begin", None, [pointer]),
        ("move", integer, [pointer, real, real]),
        ("saved_size", ctypes.c_int64, [pointer]),
        ("save", None, [pointer, pointer]),
        ("restore", integer, [pointer, ctypes.c_char_p, ctypes.c_int64]),
        ("phase_of", integer, [pointer]),
        ("model_of", pointer, [pointer]),
        ("numbers_of", pointer, [pointer]),
        ("state_of", pointer, [pointer]),
        ("work_of", pointer, [pointer]),
        ("operate", real, [integer, real, real, real]),
        ("evaluate", None, [pointer, pointer, integer]),
        ("initialise", integer, [pointer] * 4),
        ("residuals", None, [pointer] * 6),
        ("advance", integer, [*[pointer] * 4, real]),
        ("set_inputs", None, [pointer] * 6),
        ("measure", None, [pointer] * 4),
        ("probe", integer, [*[pointer] * 4, real, *[pointer] * 5]),
    ):
        function = getattr(library, f"holonom_{name}", None)
        if function is None:
            raise KernelMissingError(_other(path))
        function.restype, function.argtypes = result, arguments
    found = (library.holonom_abi(), library.holonom_model_bytes(), library.holonom_dimension())
    if found != (ABI, ctypes.sizeof(_ModelStruct), dimension):
        raise KernelMissingError(_other(path))
    return library


@functools.cache
def shared_library(dimension: int, path: str) -> ctypes.CDLL:
    """Load a kernel once: ctypes keeps some 1.4 kB for every time that a library is loaded."""
    return load_library(dimension, path)


def _doubles(values: Sequence[float]) -> Doubles:
    content = array("d", values) or array("d", [0.0])
    return (ctypes.c_double * len(content)).from_buffer_copy(content)


class Kernel:
    """A model bound to the compiled kernel, with its own numbers, state and scratch.

    `numbers`, `state` and `work` are ctypes arrays of doubles; nothing in `work` survives a step.
    """

    def __init__(self, model: Model, library: ctypes.CDLL | None = None) -> None:
        self.model = model
        dimension = model.sizes["dim"]
        self._library = library or shared_library(dimension, library_path(dimension))
        self.numbers = _doubles(model.numbers)
        self.state = (ctypes.c_double * state_size(model.sizes))()
        self._struct = _ModelStruct(
            **model.sizes,
            **{name: table.buffer_info()[0] for name, table in model.tables.items()},
            **{f"{name}_at": offset for name, offset in model.offsets.items()},
        )
        structure = ctypes.addressof(self._struct)
        assert self._library.holonom_state_size(structure) == len(self.state)
        assert self._library.holonom_measured_size(structure) == measured_size(model.sizes)
        self.work = (ctypes.c_double * self._library.holonom_work_size(structure))()
        self._pointers = (
            structure,
            ctypes.addressof(self.numbers),
            ctypes.addressof(self.state),
            ctypes.addressof(self.work),
        )
        self._advance = self._library.holonom_advance

    def evaluate(self, segment: int) -> None:
        """Run one segment of the tape on the numbers."""
        self._library.holonom_evaluate(*self._pointers[:2], segment)

    def initialise(self) -> int:
        """Take the initial configuration into the state; return a status."""
        return self._library.holonom_initialise(*self._pointers)

    def advance(self, step: float) -> int:
        """Advance the state by `step` [s]; return a status."""
        return self._advance(*self._pointers, step)

    def measure(self) -> None:
        """Fill the measurements in the numbers from the state."""
        self._library.holonom_measure(*self._pointers)

    def set_inputs(self, inputs: Sequence[float], parameters: Sequence[float]) -> None:
        """Change inputs and tunable parameters; a jump of stored energy is booked as work."""
        self._library.holonom_set_inputs(*self._pointers, _doubles(inputs), _doubles(parameters))

    def residuals(self) -> tuple[list[float], list[float]]:
        """Return the residuals of the rows and their rates, each in the unit of its row."""
        phi, phi_dot = (_doubles([0.0] * len(self.model.row_names)) for _ in range(2))
        self._library.holonom_residuals(*self._pointers, phi, phi_dot)
        count = len(self.model.row_names)
        return list(phi)[:count], list(phi_dot)[:count]

    def probe(
        self, h: float, w: Sequence[float], mu: Sequence[float], x: Sequence[float]
    ) -> tuple[int, list[float], list[float]]:
        """Return status, residual and tangent times `x` of one step, for tests of the tangent."""
        size = len(w) + len(mu)
        r, tx = _doubles([0.0] * size), _doubles([0.0] * size)
        arguments = (h, _doubles(w), _doubles(mu), _doubles(x), r, tx)
        status = self._library.holonom_probe(*self._pointers, *arguments)
        return status, list(r)[:size], list(tx)[:size]
