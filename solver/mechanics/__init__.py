"""From a scene to a model: bodies, joints and forces as forms, rows and laws; names become indices."""

from solver.mechanics.assembly import assemble

__all__ = ["assemble"]
