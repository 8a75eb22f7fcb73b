"""Coupled FMUs in cofmupy."""

import job
from cofmupy.coordinator import Coordinator

task = job.read()


def end_of(name, variable):
    """One end of a connection."""
    return {"id": name, "variable": variable, "type": "fmu"}


coordinator = Coordinator()
coordinator.start(
    {
        "fmus": [
            {"id": name, "name": name, "path": path, "initialization": task["start"][name]}
            for name, path in task["fmus"].items()
        ],
        "connections": [
            {"source": end_of(source, output), "target": end_of(target, input_)}
            for source, output, target, input_ in task["links"]
        ],
        "cosim_method": {"parallel": "jacobi", "sequential": "gauss_seidel"}[task["scheme"]],
        "iterative": False,
    }
)
rows = []
for _ in range(task["steps"]):
    outputs = coordinator.master.do_step(task["h"])
    rows.append([float(outputs[name][variable][0]) for name, variable in task["watch"]])
job.end(rows)
