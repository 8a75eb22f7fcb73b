"""The slave of pythonfmu: FMI 2.0's calls, handed on to the library in C that native FMUs have too.

pythonfmu turns an exception into fmi2Fatal and frees the instance, and it knows no other way to
refuse a call than a discarded step. So no exception leaves this class. What cannot be done is
written to the log and remembered, the old values stay, and every doStep is then discarded until
the value is set again, a saved state is restored or the instance is reset. The reason stands in
the log and, as a code (`status.py`), in the output `solver.status`.
"""

from __future__ import annotations

import ctypes
import functools
import json
import os  # not pathlib, which would take a tenth of the time to import all this
import sys
import zlib
from collections.abc import Sequence
from ctypes import byref, c_char_p, c_double, c_int, c_int32, c_size_t, c_uint32, c_void_p
from weakref import ref

from . import status
from .interrupt_guard import guarded, hang_doors, shielded, takes_signals
from .log import Fmi2Slave
from .status import INITIALIZING, INSTANTIATED, STEPPING

TYPE_CHECKING = False  # typing would take a tenth of the time to import all this
if TYPE_CHECKING:
    from typing import Any

TYPES = {"Real": c_double, "Integer": c_int, "Boolean": c_int, "String": c_char_p}
LOGGER = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p)
LOOK = ctypes.CFUNCTYPE(c_int32)
SUFFIX = {"win32": ".dll", "cygwin": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")
GUID = slice(44, 84)
"""Where the file of the model has it (``hm_header`` in model_tables.h)."""


class _Front(ctypes.Structure):
    """How ``struct slave`` in native/slave.h begins: its memory, and what its steps ask."""

    _fields_ = (
        *((name, c_int32) for name in ("phase", "is_assembled", "status", "refusal")),
        *(("start_time", c_double), ("look", LOOK)),
    )


@functools.cache
def _library() -> ctypes.CDLL:
    """Library for this machine, which lies beside this file under the name of its platform."""
    folder, others = os.path.dirname(__file__), []
    for name in sorted(os.listdir(folder)):
        if name.endswith(SUFFIX):
            try:
                return ctypes.CDLL(os.path.join(folder, name))
            except OSError as error:  # of another processor
                others.append(f"{name} ({error})")
    import sysconfig  # only here: it would take a tenth of the time to import all this

    message = (
        f"no library for this platform, {sysconfig.get_platform()}: the folder {folder} has "
        f"{', '.join(others) or f'none that ends with {SUFFIX}'}; build the FMU on this platform"
    )
    raise RuntimeError(message)


@functools.lru_cache(64)
def _references(vrs: tuple[int, ...]) -> tuple[ctypes.Array, c_size_t]:
    """Value references as the library wants them, and their count; importers ask for the same."""
    return (c_uint32 * len(vrs))(*vrs), c_size_t(len(vrs))


def _in_python(kind: str, values: Any) -> list:
    if kind == "String":
        return [(value or b"").decode() for value in values]
    return [value != 0 for value in values] if kind == "Boolean" else values[:]


def _getter(kind: str) -> Any:
    """Return a method that hands out no NaN."""

    def get(self: Slave, vrs: list[int]) -> list:
        values = (TYPES[kind] * len(vrs))()
        call = self._call if "assembly" in self._refusals else self._ask  # that was told already
        call(f"fmi2Get{kind}", *_references((*vrs,)), values)
        return _in_python(kind, values)

    # After an interrupt, which spoils no value, once more.
    return shielded(get, lambda _, vrs: _in_python(kind, (TYPES[kind] * len(vrs))()))(get)


def _setter(kind: str) -> Any:
    """Return a method that takes all values, or none and a line in the log."""

    def set_values(self: Slave, vrs: list[int], values: Sequence) -> None:
        if kind == "String":
            values = [None if v is None else v.encode("utf-8", "surrogateescape") for v in values]
        given = (TYPES[kind] * len(vrs))(*values)
        self._try(vrs, status.VALUE_REFUSED, f"fmi2Set{kind}", *_references((*vrs,)), given)

    return shielded()(set_values)


class Slave(Fmi2Slave):
    """One instance of the FMU. fmi2Reset is a new object of this class."""

    _instance = c_void_p()

    def __init__(self, **kwargs) -> None:
        super().__init__(**kwargs)
        self._refusals: dict[int | str, str] = {}
        self._said: list[str] = []  # why the library refused the last call
        self.struck = 0  # whether an exception struck during that call
        self._library = _library()
        self._logger = LOGGER(guarded(ref(self), "_hear"))
        self._make(os.path.abspath(self.resources or "."))
        watch = takes_signals(ref(self))
        next(watch)  # from here on it waits within `try`
        self._front.look = self._look = LOOK(watch.__next__)
        hang_doors(self)
        if self.resources in sys.path:  # pythonfmu puts it there for every instance and leaves it
            sys.path.remove(self.resources)

    def _make(self, folder: str) -> None:
        try:
            with open(os.path.join(folder, "model.bin"), "rb") as file:
                guid = file.read(GUID.stop)[GUID].rstrip(b"\0")
        except OSError as error:
            message = f"instantiate: {error.filename} cannot be read: {error.strerror}"
            raise RuntimeError(message) from None
        path = folder.replace(os.sep, "/").replace("%", "%25")
        uri = f"file:{'' if path.startswith('/') else '/'}{path}".encode("utf-8", "surrogateescape")
        name = self.instance_name.encode("utf-8", "replace")
        self._callbacks = (c_void_p * 5)(ctypes.cast(self._logger, c_void_p))  # and no others
        self._library.fmi2Instantiate.restype = c_void_p
        made = self._library.fmi2Instantiate(name, 1, guid, uri, self._callbacks, 0, 1)
        if not made:
            raise RuntimeError("; ".join(self._said))
        self._instance, self._front = c_void_p(made), _Front.from_address(made)

    def __del__(self) -> None:
        """Give back the memory of the instance."""
        if self._instance:
            self._library.fmi2FreeInstance(self._instance)

    def _hear(self, _environment: Any, _name: bytes, level: int, _kind: bytes, said: bytes) -> None:
        text = said.decode("utf-8", "replace").replace("%%", "%")
        if level in (status.DISCARD, status.ERROR):
            self._said.append(text)
        else:
            self.say(text, level)

    def _call(self, name: str, *arguments: object) -> int:
        """Call a function of the library; its status."""
        self._said.clear()
        self.struck = 0
        answer = getattr(self._library, name)(self._instance, *arguments)
        if self.struck:  # which is told and remembered already
            self._said.clear()
        return answer

    def _ask(self, name: str, *arguments: object) -> int:
        """Call a function of the library, and log why it refuses; its status."""
        answer = self._call(name, *arguments)
        for text in self._said:
            self.say(text, status.ERROR)
        return answer

    def _try(self, what: Sequence[int | str], code: int, name: str, *arguments: object) -> None:
        """Call a function of the library, and remember what it refuses, until that is well."""
        if self._call(name, *arguments):
            self._refuse(what, code, *self._said)
            return
        for each in what if self._refusals else ():
            self._refusals.pop(each, None)
        if not self._refusals:
            self._front.refusal = 0

    def _refuse(self, what: Sequence[int | str], code: int, *why: str) -> None:
        """Remember what was refused, and why: no step is taken while this stands."""
        if text := "; ".join(why):
            self._front.refusal = code
            self._refusals.update(dict.fromkeys(what, text))
            self.say(text, status.ERROR)

    def broken(self, error: BaseException) -> None:
        """Refuse all steps after a call that an exception broke: nobody knows where it left things.

        It ends the step of which it strikes the midst.
        """
        self.struck, code, text = 1, status.INTERRUPTED, "interrupted from the keyboard"
        if not isinstance(error, KeyboardInterrupt):
            code, what = status.INTERNAL_FAULT, "fault of this program, please report it"
            text = f"{what}: {type(error).__name__}: {error}"
        self._refuse(["break"], code, f"{text}; restore a saved state, or reset the instance")

    @shielded()
    def setup_experiment(self, start_time, stop_time=None, tolerance=None) -> None:
        """Take start and stop time and, where the scene asks for a tolerance, this one."""
        times = c_double(start_time), stop_time is not None, c_double(stop_time or 0.0)
        given = tolerance is not None, c_double(tolerance or 0.0), *times
        if self._front.phase == INSTANTIATED:
            self._try(["experiment"], status.VALUE_REFUSED, "fmi2SetupExperiment", *given)
        else:
            self._ask("fmi2SetupExperiment", *given)

    @shielded()
    def enter_initialization_mode(self) -> None:
        """Begin initialisation; outputs may be read from now on."""
        self._ask("fmi2EnterInitializationMode")

    @shielded()
    def exit_initialization_mode(self) -> None:
        """Assemble the mechanism with the parameters that have arrived."""
        if self._front.phase != INITIALIZING:
            self._ask("fmi2ExitInitializationMode")
            return
        self._try(["assembly"], status.ASSEMBLY_FAILED, "fmi2ExitInitializationMode")
        self._front.phase = STEPPING  # the importer hears of no error, and goes on

    get_real, get_integer, get_boolean, get_string = map(_getter, TYPES)
    set_real, set_integer, set_boolean, set_string = map(_setter, TYPES)

    @shielded(lambda *_: False)
    def do_step(self, current_time: float, step_size: float) -> bool:
        """Advance to `current_time + step_size`; False (fmi2Discard) leaves all as it was."""
        if self._refusals:
            reasons = "; ".join(dict.fromkeys(self._refusals.values()))
            self.say(f"no step is taken: {reasons}", status.DISCARD, "discarded")
            return False
        phase = self._front.phase
        if not self._call("fmi2DoStep", c_double(current_time), c_double(step_size), 1):
            return True
        self._front.phase = phase  # an error ended the run, which the importer sees discarded
        for text in self._said:
            what = "repeated" if " steps in a row failed " in text else "discarded"
            self.say(text, status.DISCARD, what)
        return False

    @shielded()
    def terminate(self) -> None:
        """End the run; values can still be read."""
        self._ask("fmi2Terminate")

    @shielded(lambda _: b"")
    def _get_fmu_state(self) -> Any:
        """Return the state of the library, and in a last line what was refused, with a checksum."""
        kept, size = c_void_p(), c_size_t()
        if self._ask("fmi2GetFMUstate", byref(kept)):
            return b""
        self._call("fmi2SerializedFMUstateSize", kept, byref(size))
        data = ctypes.create_string_buffer(size.value)
        self._call("fmi2SerializeFMUstate", kept, data, size)
        self._call("fmi2FreeFMUstate", byref(kept))
        refused = json.dumps([*self._refusals.items()]).encode()
        return b"%b\n%08x%b" % (data.raw, zlib.crc32(refused), refused)

    @shielded()
    def _set_fmu_state(self, state: Any) -> None:
        kept = c_void_p()
        data, _, refused = state.rpartition(b"\n")
        if refused[:8] != b"%08x" % zlib.crc32(refused[8:]):
            data = b""  # which is no state
        given = data, c_size_t(len(data)), byref(kept)
        if self._call("fmi2DeSerializeFMUstate", *given) or self._call("fmi2SetFMUstate", kept):
            self._refuse(["state"], status.STATE_REFUSED, *self._said)
        else:
            self._refusals = dict(json.loads(refused[8:]))
        self._call("fmi2FreeFMUstate", byref(kept))

    # A state is bytes already. The library asks the class, where nobody could shield a method.
    _fmu_state_to_bytes = _fmu_state_from_bytes = bytes  # type: ignore[assignment]
