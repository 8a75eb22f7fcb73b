"""Impacts: our located contacts beside MuJoCo, Exudyn's penalty contact and SciPy with events."""
