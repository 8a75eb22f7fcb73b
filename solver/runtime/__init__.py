"""The part that travels: models, states, and the integrator that moves them.

Imports the standard library alone. Its buffers are ctypes arrays, so that an FMU needs no NumPy.
"""

from .errors import AssemblyError, OptionError, Status, StepError
from .integrator import Integrator
from .model import Experiment, Model, Row, Rule, Variable
from .state import State

__all__ = [
    "AssemblyError",
    "Experiment",
    "Integrator",
    "Model",
    "OptionError",
    "Row",
    "Rule",
    "State",
    "Status",
    "StepError",
    "Variable",
]
