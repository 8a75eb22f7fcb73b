"""One mechanism in motion: parameters in, steps, named values out."""

from __future__ import annotations

import ctypes
import math
import sys
from collections.abc import Callable, Sequence

from .errors import AssemblyError, OptionError, Status, StepError, tell
from .kernel import library_path, shared_library
from .model import Model, Variable
from .state import State

REFUSED, UNASSEMBLED, FAILED, UNTRIED, REMARKED = 1, 2, 3, 4, 256
"""Results of the core, ``holonom_result`` of ``solver/kernel/instance.h``."""
MOST_PLANS = 64

Value = float | str | bool


class Instance:
    """A model with its state, in the core.

    Parameters
    ----------
    model : Model
        What to move.
    log : callable, optional
        Receives one sentence whenever something happens that a user should know; without it such a
        sentence is a RuntimeWarning.
    """

    def __init__(self, model: Model, *, log: Callable[[str], None] | None = None) -> None:
        self.model, self._log = model, log
        dimension = model.sizes["dim"]
        self._library = library = shared_library(dimension, library_path(dimension))
        self._file, size = model.checked_file(library)
        self._memory = (ctypes.c_double * (size // 8 + 2))()
        address = ctypes.addressof(self._memory)
        address += -address % 16
        self._instance = library.holonom_make(
            ctypes.addressof(self._file), len(model.file), address, log is not None
        )
        self._get, self._advance = library.holonom_get, library.holonom_move
        self._plans: dict[tuple[int, ...], tuple] = {}
        self.state = State(model, self._doubles("state", library.holonom_state_size))
        self.message = "done"

    def _doubles(self, name: str, size: Callable[[int], int]) -> ctypes.Array[ctypes.c_double]:
        """Return a vector of the instance, in its memory."""
        model = self._library.holonom_model_of(self._instance)
        address = getattr(self._library, f"holonom_{name}_of")(self._instance)
        return (ctypes.c_double * size(model)).from_address(address)

    def reset(self) -> None:
        """Return to the condition after construction."""
        self._library.holonom_reset(self._instance)
        self.message = "done"

    def _end(self, result: int) -> None:
        """Say what was noticed, and raise what went wrong."""
        if result & REMARKED:
            for sentence in self._library.holonom_remarks(self._instance).decode().splitlines():
                tell(self._log, sentence)
        if result & ~REMARKED:
            message = self._library.holonom_message(self._instance).decode()
            if result == REFUSED:
                raise OptionError(message)
            if result == UNASSEMBLED:
                raise AssemblyError(message)
            if result == FAILED:
                self.message = message
            raise StepError(message, self.status if result == FAILED else None)

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
        """Phase of the run, one of ``state.PHASES``."""
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
        shown = None
        if len(values) != count:
            message = f"set: {count} variables and {len(values)} values"
            raise ValueError(message)
        for k, value in enumerate(values):
            if type(value) is float and not words:
                numbers[k] = value
            else:
                shown = shown or (ctypes.c_char_p * count)()
                numbers[k], text = self._number(key[k], value)
                shown[k] = text.encode("utf-8", "replace")
        self._end(self._library.holonom_set(self._instance, index, count, address, shown))

    def _number(self, index: int, value: object) -> tuple[float, str]:
        """Return the double of a value, NaN if it has none, and the text that shows it."""
        kind = self.model.variables[index].type
        if isinstance(value, int) and abs(value) > sys.float_info.max:
            return math.nan, "an integer of more than 308 digits"  # too many to be shown
        if kind == "String":
            word = value.encode("utf-8", "replace") if isinstance(value, str) else b""
            number = self._library.holonom_number_of_word(self._instance, index, word)
        elif isinstance(value, int | float):
            number = float(value)
        else:
            number = math.nan
        return number, repr(value)

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
        """
        if start_time is not None:
            self.state.head["time"] = start_time
        self._end(self._library.holonom_assemble(self._instance))

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
        """
        result = self._advance(self._instance, t, step)
        if result:
            self._end(result)
        self.message = "done"

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
