"""From a scene to a model: parts as forms, rows and laws; names become indices."""

from solver.mechanics.assembly import assemble, assemble_parts

__all__ = ["assemble", "assemble_parts"]
