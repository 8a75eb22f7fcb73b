"""Coupled FMUs in one FMU, made by fmucontainer and run by fmpy."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import fmpy
import job
from fmpy.validation import validate_fmu

task = job.read()
folder = Path(tempfile.mkdtemp())
files = {name: f"{name}.fmu" for name in task["fmus"]}
for name, path in task["fmus"].items():
    shutil.copy(path, folder / files[name])
options = ("mt", "profiling", "auto_link", "auto_input", "auto_output", "auto_parameter")
container = dict.fromkeys(options, False) | {
    "name": "coupled.fmu",
    "step_size": task["h"],
    "sequential": task["scheme"] == "sequential",
    "fmu": list(files.values()),
    "link": [[files[s], output, files[t], input_] for s, output, t, input_ in task["links"]],
    "output": [
        [files[name], variable, f"watched.{name}.{variable}"] for name, variable in task["watch"]
    ],
}
(folder / "coupled.json").write_text(job.json.dumps(container))
program = Path(sys.executable).with_name("fmucontainer")
command = [program, "-fmu-directory", folder, "-container", "coupled.json"]
made = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
assert made.returncode == 0, made.stdout + made.stderr
path = str(folder / "coupled.fmu")
problems = validate_fmu(path)
assert not problems, problems
stop = task["steps"] * task["h"]
result = fmpy.simulate_fmu(path, stop_time=stop, output_interval=task["h"])
shutil.rmtree(folder)
names = [f"watched.{name}.{variable}" for name, variable in task["watch"]]
job.end([[float(row[name]) for name in names] for row in result[1:]])
