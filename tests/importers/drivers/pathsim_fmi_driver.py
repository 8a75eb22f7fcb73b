"""Coupled FMUs as blocks of pathsim."""

import job
from pathsim import Connection, Simulation
from pathsim_fmi import CoSimulationFMU

task = job.read()
h = task["h"]
blocks = {
    name: CoSimulationFMU(path, instance_name=name, dt=h) for name, path in task["fmus"].items()
}
connections = [
    Connection(blocks[source][output], blocks[target][input_])
    for source, output, target, input_ in task["links"]
]
simulation = Simulation(list(blocks.values()), connections, dt=h, log=False)
rows = []
for i in range(task["steps"]):
    simulation.run((i + 1) * h - simulation.time, reset=False)
    rows.append([float(blocks[name].outputs[variable]) for name, variable in task["watch"]])
job.end(rows)
