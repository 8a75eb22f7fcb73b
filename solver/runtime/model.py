"""A model: the structure of a mechanism as integers, and one vector of numbers.

    M (v_1 - v_n) + h [ Gm' mu + dU - Q ] = 0,   (v_n + v_1)/2 = (q_1 - q_n)/h,   Phi(q_1) = 0

Every term is a function of forms s = u . w of the nodes (``solver/kernel/holonom.h``). Names appear
only in `variables`, `rules` and `rows`: they were turned into indices when the model was
assembled. A model is the only thing that assembly and kernel share, and what travels in an FMU.

Symbols: q coordinates, v velocities, M mass matrix, Phi constraint rows, G their Jacobian, lambda
multipliers held fixed in the inner iteration, mu total multipliers, alpha penalties, h step.

Records are named tuples: `dataclasses` and `typing` would double the time to import all this.
"""

from __future__ import annotations

import ctypes
from collections import namedtuple
from functools import cached_property

from .errors import OptionError, UnknownNameError
from .layout import INPUT_COURSES
from .model_file import fingerprint, from_bytes


class Variable(
    namedtuple(
        "Variable",
        "name type causality variability unit description start minimum maximum kind place clips"
        " display_unit",
        defaults=("", "", None, None, None, "measured", 0, False, ""),
    )
):
    """A named quantity that a user reads or sets.

    Attributes
    ----------
    name, unit, description : str
    type : {"Real", "String", "Boolean"}
    causality : {"parameter", "calculatedParameter", "input", "output"}
    variability : {"fixed", "tunable", "continuous"}
    start : float, str, bool or None
        Value at the beginning of a parameter or input.
    minimum, maximum : float or None
    kind, place
        Where it lies: "parameter", "input" (in the state), "number" (in the vector of numbers),
        "measured" (behind the offset of the measurements) or "option"; and the index there.
    clips : bool
        Whether a value beyond minimum or maximum is the limit instead of an error.
    display_unit : str
        In which tools show it; values stay in `unit`.
    """

    __slots__ = ()


class Rule(namedtuple("Rule", "number relation bound location name message")):
    """A condition that is checked whenever the mechanism is assembled.

    Attributes
    ----------
    number : int
        Place in the vector of numbers.
    relation : {">", ">=", "finite", "drawn", "noted"}
        Against `bound`; "drawn" is >= at the start alone; "noted" is = 0, and a run that breaks it
        tells so and goes on.
    bound : float
    location, name : str
        Where it stands in the scene, ``bodies.rod``, and what it is called in a sentence.
    message : str
        What is said when it does not hold, with ``{value}``.
    """

    __slots__ = ()


class Row(namedtuple("Row", "location name kind detail", defaults=("",))):
    """What a constraint row belongs to, for what is said when the drawn mechanism contradicts it.

    Attributes
    ----------
    location, name : str
        Where the part stands in the scene, ``joints.bearing``, and what it is called in a sentence.
    kind, detail : str
        Which of the sentences of ``assembly_sentences.c``, and what stands in it, such as
        the bodies.
    """

    __slots__ = ()


class Experiment(
    namedtuple(
        "Experiment", "start_time stop_time step_size tolerance", defaults=(0.0, 1.0, 0.1, None)
    )
):
    """Default run: start and stop time and communication step [s]; relative tolerance or None."""

    __slots__ = ()


class Model(
    namedtuple(
        "Model",
        "name description sizes tables offsets numbers variables rules rows forces meshes "
        "sampled switches settings experiment",
    )
):
    """Structure and numbers of a mechanism; never modified.

    Attributes
    ----------
    name, description : str
    sizes : mapping of str to int
        As in ``layout.SIZES``.
    tables : mapping of str to array of int
        As in ``layout.TABLES``.
    offsets : mapping of str to int
        As in ``layout.OFFSETS``.
    numbers : array of float
    variables : tuple of Variable
    rules : tuple of Rule
    rows : tuple of Row
        What each constraint row belongs to, in the order of the multipliers.
    forces : mapping of str to str
        Type of each force of the scene, by name, such as "torsion_damper".
    meshes : mapping of str to dict
        The grid of each contact with a mesh, by name, and how exact its distances are.
    sampled : tuple of str
        What each load that reads the mechanism is called in a sentence.
    switches : tuple of str
        Part and condition, or kink, of each switch of laws and drivers, ``force 'f': t < 0.6``.
    settings : mapping of str to float, str or bool
        Of the solver, as in ``solver.options.DEFAULTS``.
    experiment : Experiment
    dependencies : dict or None
        Variables on which outputs and calculated parameters depend, by the index of each: at a
        communication point, and in the initialization mode. The bytes do not have it.
    scene : solver.scene.Scene or None
        What it was assembled from. The bytes do not have it.
    """

    dependencies: dict | None = None
    scene: object = None
    _checked: tuple[ctypes.Array[ctypes.c_double], int] | None = None

    @property
    def fingerprint(self) -> str:
        """Hash of all that a run depends on."""
        return fingerprint(self.file)

    @property
    def moving_inputs(self) -> dict[str, str]:
        """How inputs go that move within a communication step, "ramp" or "smooth", by name."""
        courses = self.tables["input_course"]
        words = {
            v.name: INPUT_COURSES[courses[v.place]] for v in self.variables if v.kind == "input"
        }
        return {name: word for name, word in words.items() if word != "hold"}

    @cached_property
    def _places(self) -> dict[str, int]:
        return {variable.name: index for index, variable in enumerate(self.variables)}

    def index(self, name: str) -> int:  # type: ignore[override]
        """Return the index of a variable; `UnknownNameError` if there is none of that name."""
        if name not in self._places:
            raise UnknownNameError(name, self._places)
        return self._places[name]

    def to_bytes(self) -> bytes:
        """Return the model as bytes (``model_writing``); the same model gives the same ones."""
        from .model_writing import to_bytes  # which imports this module

        return to_bytes(self)

    def with_guid(self, guid: str) -> bytes:
        """Return the bytes of the model in the FMU of a GUID."""
        from .model_writing import with_guid

        return with_guid(self.file, guid)

    @staticmethod
    def from_bytes(data: bytes) -> Model:
        """Return the model that `to_bytes` wrote.

        Raises
        ------
        ValueError
            When the bytes are of another format version, or damaged.
        """
        model = Model(**from_bytes(data))
        model.__dict__["file"] = data
        return model

    @cached_property
    def file(self) -> bytes:
        """The bytes that the core reads."""
        return self.to_bytes()

    def checked_file(self, library: ctypes.CDLL) -> tuple[ctypes.Array[ctypes.c_double], int]:
        """Return the bytes that the core reads, aligned, and the memory of an instance [bytes].

        Raises
        ------
        OptionError
            When the core finds an index in them that leads beyond what it points into.
        """
        checked = self._checked
        if checked is None:
            content = (ctypes.c_double * (len(self.file) // 8)).from_buffer_copy(self.file)
            why = ctypes.create_string_buffer(200)
            address = ctypes.addressof(content)
            size = library.holonom_instance_size(address, len(self.file), why, len(why))
            if not size:
                raise OptionError(why.value.decode())
            checked = self.__dict__["_checked"] = content, size
        return checked
