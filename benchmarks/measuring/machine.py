"""What the numbers were measured on: processor, system, compiler, versions; no names or folders."""

from __future__ import annotations

import datetime
import os
import platform
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

PACKAGES = ("holonom", "numpy", "scipy", "fmpy", "pythonfmu")


def describe() -> dict[str, float | str | None]:
    """Machine and software, by name."""
    facts: dict[str, float | str | None] = {
        "processor": _processor(),
        "cores": f"{os.cpu_count()}, of which one is used",
        "system": _system(),
        "C compiler": _compiler(),
        "Python": f"{platform.python_implementation()} {platform.python_version()}",
    }
    for package in PACKAGES:
        try:
            facts[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            facts[package] = "from the source tree"
    facts["day"] = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    if hasattr(os, "getloadavg"):
        facts["load before the run"] = f"{os.getloadavg()[0]:.2f} processes"
    return facts


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        text = cpuinfo.read_text(encoding="utf-8", errors="replace")
        model = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
        if model:
            return f"{model[1].strip()} ({platform.machine()})"
    if sys.platform == "darwin":
        return _first_line(["sysctl", "-n", "machdep.cpu.brand_string"]) or platform.machine()
    return platform.processor() or platform.machine()


def _system() -> str:
    release = re.match(r"[\d.]*", platform.release())
    kernel = f"{platform.system()} {release[0] if release else ''}".rstrip()
    try:
        return f"{platform.freedesktop_os_release()['PRETTY_NAME']}, {kernel}"
    except (OSError, KeyError):
        return kernel


def _compiler() -> str:
    """First line of what the compiler that builds the kernel says of itself."""
    from build_kernel.compiler import system_compiler

    command = system_compiler()
    if not command:
        return "ziglang"
    return _first_line([*command, "--version"]) or Path(command[0]).name


def _first_line(command: list[str]) -> str | None:
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return run.stdout.partition("\n")[0].strip() or None
