"""FMUs in libcosimpy, fixed step: coupled, or with parameters and an input that is 1, 2, 3, ..."""

import job
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

task = job.read()
log_output_level(CosimLogLevel.WARNING)
execution = CosimExecution.from_step_size(round(task["h"] * 1e9))
units = {
    name: execution.add_local_slave(CosimLocalSlave(fmu_path=path, instance_name=name))
    for name, path in task["fmus"].items()
}
references = task["references"]
observer = CosimObserver.create_last_value()
assert execution.add_observer(observer)
for source, output, target, input_ in task["links"]:
    ends = (units[source], references[source][output], units[target], references[target][input_])
    assert execution.connect_real_variables(*ends) == 0
for name, values in task.get("parameters", {}).items():
    for variable, value in values.items():
        assert execution.real_initial_value(units[name], references[name][variable], value)
pushing = CosimManipulator.create_override()
assert execution.add_manipulator(pushing)
rows = []
for k in range(task["steps"]):
    for name, variable in task.get("pushed", ()):
        assert pushing.slave_real_values(units[name], [references[name][variable]], [1.0 + k])
    assert execution.step()
    rows.append(
        [
            observer.last_real_values(units[name], [references[name][variable]])[0]
            for name, variable in task["watch"]
        ]
    )
job.end(rows)
