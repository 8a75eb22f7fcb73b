"""Multibody mechanics and time integration: from a scene to a trajectory."""
