"""Coupled FMUs in ecospy, fixed step."""

import job
from ecospy import EcosLib, EcosSimulation, EcosSimulationStructure

task = job.read()
EcosLib.set_log_level("warn")
structure = EcosSimulationStructure()
for name, path in task["fmus"].items():
    structure.add_model(name, path)
for source, output, target, input_ in task["links"]:
    structure.make_real_connection(f"{source}::{output}", f"{target}::{input_}")
simulation = EcosSimulation(structure=structure, step_size=task["h"])
assert simulation.init()
rows = []
for _ in range(task["steps"]):
    simulation.step()
    rows.append([simulation.get_real(f"{name}::{variable}") for name, variable in task["watch"]])
simulation.terminate()
job.end(rows)
