"""One mechanism in motion: parameters in, steps, named values out."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable, Iterator, Sequence
from mmap import mmap

from .errors import AssemblyError, OptionError, Status, StepError, is_double, shown, tell
from .kernel import LOOK, shared_library
from .layout import MESH, RESULTS, state_size
from .model import Model
from .state import State

MOST_PLANS = 64

Value = float | str | bool


def takes_signals(caught: list[BaseException]) -> Iterator[int]:
    """Let Python answer signals, as it does between two lines, and catch what a handler raises.

    The core asks this for the next value, 1 where something was caught: within a call of C nothing
    else of Python runs. It waits within `try`, or an exception could strike ahead of it.
    """
    while True:
        try:
            while True:  # within, as Python looks for signals where a loop turns
                yield len(caught)
        except GeneratorExit:
            return
        except BaseException as error:
            caught.append(error)


class MeshMemory(ctypes.Structure):
    """``holonom_mesh``: internal steps of a communication step, taken or to be repeated.

    A step has the numbers of `MESH`, and one for each switch of the model.
    """

    _fields_ = [
        ("_row", ctypes.c_void_p), ("_room", ctypes.c_int64), ("_count", ctypes.c_int64),
        ("_start", ctypes.c_void_p), ("_ahead", ctypes.c_double * 3),
        ("_ahead_of", ctypes.c_double * 3), ("_ahead_kept", ctypes.c_double * 3),
        ("_ahead_of_kept", ctypes.c_double * 3), ("_back_at", ctypes.c_double),
        ("_is_full", ctypes.c_int32),
    ]  # fmt: skip

    def __init__(self, room: int, switches: int, state: int = 0) -> None:
        """Take room for so many steps and, to repeat them, for a state of so many numbers."""
        super().__init__()
        self.width = len(MESH) + switches
        self._rows = (ctypes.c_double * (room * self.width))()
        self._state = (ctypes.c_double * state)()
        self._row, self._room = ctypes.addressof(self._rows), room
        self._start = ctypes.addressof(self._state) if state else None

    def clear(self) -> None:
        """Forget the steps of before."""
        self._count = self._is_full = 0
        self._ahead_of[:] = [math.nan] * 3
        self._back_at = math.nan

    def fill(self, numbers: Sequence[float]) -> None:
        """Take the steps to repeat, one after the other."""
        self._rows[: len(numbers)] = numbers
        self._count = len(numbers) // self.width

    @property
    def is_full(self) -> bool:
        """Whether there were more steps than room."""
        return bool(self._is_full)

    def numbers(self) -> list[float]:
        """Numbers of the steps that were taken, one after the other."""
        return self._rows[: self._count * self.width]


class Integrator:
    """A model with its state, in the core.

    Parameters
    ----------
    model : Model
        What to move.
    log : callable, optional
        Receives one sentence whenever something happens that a user should know; without it such a
        sentence is a RuntimeWarning.
    library : ctypes.CDLL, optional
        Core to use, of ``kernel.load_library``; that of this installation where left out.

    Raises
    ------
    KernelMissingError
        When no compiled kernel fits this platform, or it belongs to another version.
    OptionError
        When an index of the model leads beyond what it points into.
    """

    def __init__(
        self,
        model: Model,
        *,
        log: Callable[[str], None] | None = None,
        library: ctypes.CDLL | None = None,
    ) -> None:
        self.model, self._log = model, log
        library = library or shared_library(model.sizes["dim"])
        self._library = library
        self._file, size = model.checked_file(library)
        # Its pages become memory where they are used: most of a large one is scratch.
        self._memory = (ctypes.c_double * (size // 8 + 2)).from_buffer(mmap(-1, size + 24))
        address = ctypes.addressof(self._memory)
        address += -address % 16
        self._instance = library.holonom_make(
            ctypes.addressof(self._file), address, log is not None
        )
        self._caught: list[BaseException] = []
        watch = takes_signals(self._caught)
        next(watch)  # from here on it waits within `try`
        self._look = LOOK(watch.__next__)
        library.holonom_let_look(self._instance, self._look)
        self._get, self._advance = library.holonom_get, library.holonom_move
        self._plans: dict[tuple[int, ...], tuple] = {}
        self.state = State(model.sizes, self._vector("state", state_size(model.sizes)))
        self.message = "done"

    def _vector(self, name: str, size: int) -> ctypes.Array[ctypes.c_double]:
        """Return a vector of doubles in the memory of the instance, which it keeps alive."""
        address = getattr(self._library, f"holonom_{name}_of")(self._instance)
        first = address - ctypes.addressof(self._memory)
        return (ctypes.c_double * size).from_buffer(self._memory, first)

    @property
    def numbers(self) -> ctypes.Array[ctypes.c_double]:
        """The vector of numbers at present; in the order of the model's."""
        return self._vector("numbers", len(self.model.numbers))

    @property
    def work(self) -> ctypes.Array[ctypes.c_double]:
        """Scratch of the core, of which nothing survives a step."""
        model = self._library.holonom_model_of(self._instance)
        return self._vector("work", self._library.holonom_work_size(model))

    def tape(self, numbers: int) -> Callable[[int], None]:
        """Return what runs a segment of the tape on a copy of the numbers at an address."""
        model = self._library.holonom_model_of(self._instance)
        return lambda segment: self._library.holonom_evaluate(model, numbers, segment)

    def reset(self) -> None:
        """Return to the condition after construction."""
        self._library.holonom_reset(self._instance)
        self.message = "done"

    def _end(self, result: int) -> None:
        """Say what was noticed, and raise what went wrong, or what a handler of a signal raised."""
        if self._caught:
            raise self._caught.pop()
        remarked = RESULTS["remarked"]
        if result & remarked:
            for sentence in self._library.holonom_remarks(self._instance).decode().splitlines():
                tell(self._log, sentence)
        if result & ~remarked:
            message = self._library.holonom_message(self._instance).decode()
            if result == RESULTS["refused"]:
                raise OptionError(message)
            if result == RESULTS["unassembled"]:
                raise AssemblyError(message)
            failed = result == RESULTS["failed"]
            if failed:
                self.message = message
            raise StepError(message, self.status if failed else None)

    # ------------------------------------------------------------------------------- values

    @property
    def time(self) -> float:
        """Present time [s]."""
        return self.state.head["time"]

    @property
    def status(self) -> Status:
        """Status of the last `advance`."""
        return Status(int(self.state.head["status"]))

    @property
    def phase(self) -> int:
        """0: values may change; 1: the initial configuration is taken; 2: steps were done."""
        return self._library.holonom_phase_of(self._instance)

    def _plan(self, indices: tuple[int, ...]) -> tuple:
        """Return memory for some indices and their values, and what makes words of numbers."""
        count = len(indices)
        index, values = (ctypes.c_int32 * count)(*indices), (ctypes.c_double * count)()
        words = []
        for k, i in enumerate(indices):
            variable = self.model.variables[i]
            if variable.type != "Real":
                words.append((k, bool if variable.type == "Boolean" else self._word_of(i)))
        if len(self._plans) >= MOST_PLANS:
            self._plans.clear()
        # Addresses, since ctypes takes longer to find them than the core takes for the values.
        plan = ctypes.addressof(index), count, ctypes.addressof(values), values, words, index
        self._plans[indices] = plan
        return plan

    def _word_of(self, index: int) -> Callable[[float], str]:
        return lambda x: self._library.holonom_word(self._instance, index, x).decode()

    def get(self, indices: Sequence[int]) -> list[Value]:
        """Return the values of variables, by their index in ``model.variables``.

        Raises
        ------
        AssemblyError
            When an output is asked for and the mechanism cannot be assembled.
        StepError
            When a value is not finite.
        """
        key = tuple(indices)
        index, count, address, values, words, _ = self._plans.get(key) or self._plan(key)
        result = self._get(self._instance, index, count, address)
        if result:
            self._end(result)
        found: list[Value] = values[:]
        for k, word in words:
            found[k] = word(values[k])
        return found

    def __getitem__(self, name: str) -> Value:
        """Return the value of a variable by its name."""
        return self.get([self.model.index(name)])[0]

    def set(self, indices: Sequence[int], values: Sequence[Value]) -> None:
        """Set parameters, inputs and settings; all of them or, on an error, none.

        Raises
        ------
        OptionError
            Naming the variable, the value and the rule that it breaks.
        """
        key = tuple(indices)
        index, count, address, numbers, words, _ = self._plans.get(key) or self._plan(key)
        texts = None
        if len(values) != count:
            message = f"set: {count} variables and {len(values)} values"
            raise ValueError(message)
        for k, value in enumerate(values):
            if type(value) is float and not words:
                numbers[k] = value
            else:
                texts = texts or (ctypes.c_char_p * count)()
                numbers[k] = self._number(key[k], value)
                texts[k] = shown(value).encode("utf-8", "replace")
        self._end(self._library.holonom_set(self._instance, index, count, address, texts))

    def _number(self, index: int, value: object) -> float:
        """Return the double of a value, NaN if it has none."""
        if self.model.variables[index].type != "String":
            return float(value) if is_double(value) else math.nan  # type: ignore[arg-type]
        if not isinstance(value, str) or "\0" in value:  # which would end a word of C
            return math.nan
        word = value.encode("utf-8", "replace")
        return self._library.holonom_number_of_word(self._instance, index, word)

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
        KeyboardInterrupt
            At Ctrl-C, or what else a handler of a signal raises; then there is no start yet.
        """
        if start_time is not None:
            self.state.head["time"] = start_time
        self._end(self._library.holonom_assemble(self._instance))

    def steps(self, has_explicit: bool = True) -> str:
        """Return in words which steps the settings choose.

        `has_explicit` is False where a run has shown that none is explicit.
        """
        return self._library.holonom_steps(self._instance, has_explicit).decode()

    def begin(self) -> None:
        """End the start: what is set from now on is for the step to come, as after a step.

        Else a tunable parameter that is set before the first step starts the mechanism anew.
        """
        self._library.holonom_begin(self._instance)

    def advance(self, t: float, step: float) -> None:
        """Advance from time `t`, which must be the present time, by `step`; both in s.

        Raises
        ------
        StepError
            When the step cannot be solved; time, h, reason and remedy in one sentence. The state
            is as before.
        KeyboardInterrupt
            At Ctrl-C, or what else a handler of a signal raises; the state is as before.
        """
        result = self._advance(self._instance, t, step)
        if result:
            self._end(result)
        self.message = "done"

    def use_mesh(self, mesh: MeshMemory | None) -> None:
        """Let steps from now on be recorded there, or repeated from there; see `solver.mesh`."""
        self._mesh = mesh  # it lives as long as the core may write there
        self._library.holonom_use_mesh(self._instance, mesh and ctypes.addressof(mesh))

    def residuals(self) -> tuple[list[float], list[float]]:
        """Return the residuals of the rows and their rates, each in the unit of its row."""
        phi, rate = ((ctypes.c_double * len(self.model.rows))() for _ in range(2))
        self._library.holonom_rows(self._instance, phi, rate)
        return list(phi), list(rate)

    # --------------------------------------------------------------------------- save, restore

    def save(self) -> bytes:
        """Return the whole state: motion, multipliers, ledger, inputs, parameters, settings."""
        data = ctypes.create_string_buffer(self._library.holonom_saved_size(self._instance))
        self._library.holonom_save(self._instance, data)
        return data.raw

    def restore(self, data: bytes) -> None:
        """Return to a state that `save` gave, bit for bit.

        Raises
        ------
        OptionError
            When it is a state of another model, or damaged; the present one is then kept.
        """
        self._end(self._library.holonom_restore(self._instance, data, len(data)))
