"""Coupled FMUs in libcosimpy, fixed step."""

import job
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
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
rows = []
for _ in range(task["steps"]):
    assert execution.step()
    rows.append(
        [
            observer.last_real_values(units[name], [references[name][variable]])[0]
            for name, variable in task["watch"]
        ]
    )
job.end(rows)
