"""The method of García Orden and Ortega (2006), sections 2 and 3, as printed: dense NumPy.

All six formulations take any Phi(q), and tell what each iteration did. `motion` moves a `Problem`
that one writes down; ``holonom.simulate(scene, formulation=...)`` a scene.
"""

from .energies import Iteration
from .problem import FORMULATIONS, Functions, Method, Problem
from .step import Moment, motion, step

__all__ = ["FORMULATIONS", "Functions", "Iteration", "Method", "Moment", "Problem"]
__all__ += ["motion", "step"]
