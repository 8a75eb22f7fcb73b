"""Compile `solver/kernel` into the two shared libraries of which `solver.runtime` loads one.

One is for mechanisms in the plane, one for those in space, as no mechanism needs both.

The compiler is `$CC`, or else the first of cc, gcc, clang that can build a shared library, or else
the clang inside the `ziglang` wheel, told to link against a glibc that every current Linux has.

Flags that matter: `-ffp-contract=off` and the absence of `-ffast-math` and `-march` keep the
arithmetic of a step the same on every machine of one architecture.
"""

from __future__ import annotations

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from build_fmu.platforms import PLATFORMS, SCOPES, library_path, own_platform
from build_kernel.model_tables import write_headers
from build_kernel.record import digest_of_inputs, is_compiled, keep_record
from build_kernel.universal import universal

SOURCES = Path("solver/kernel")
LIBRARIES = Path("solver/runtime/_kernel")
SLAVES = Path("fmu_src")
SLAVE_SOURCES = SLAVES / "native"
"""Of FMUs; with the kernel they make one library."""
DIMENSIONS = {2: "planar", 3: "spatial"}
FLAGS = (
    *("-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=off"),
    *("-fPIC", "-shared", "-fvisibility=hidden"),
    # Smaller in an archive, and no slower: loops are as short as a link has coordinates. For the
    # same reason -O2, with HM_OFTEN (internal.h), takes no longer than -O3 and is a tenth smaller.
    "-fno-tree-vectorize",
    *("-ffunction-sections", "-fdata-sections"),
    *("-Wall", "-Wextra", "-Wpedantic"),  # the Makefile's lint makes errors of warnings
    # A function that no header declares would take and return integers.
    "-Werror=implicit-function-declaration",
)
KERNELS = Path("build/kernels")
"""Python's kernels, below the names of their platforms, from which a wheel takes its own."""
SYSTEMS = {"windows": "Windows", "macos": "Darwin"}
"""What Python calls systems, by a word in zig's name of a platform; all else is Linux."""
SYSTEM_COMPILERS = ("cc", "gcc", "clang")
PROBE = "#include <math.h>\ndouble probe(double x);\ndouble probe(double x) { return sin(x); }\n"


class Kind(NamedTuple):
    """What a library is for.

    Attributes
    ----------
    dimension : int
        2 or 3.
    scope : str
        What models it serves, of `SCOPES`.
    slave : Path, optional
        Folder of a slave's sources: the library is that of an FMU, and shows the standard's
        functions alone.
    """

    dimension: int
    scope: str = SCOPES[-1]
    slave: Path | None = None


class CompilerError(Exception):
    """The kernel cannot be compiled; the text has the compiler's message and the remedy."""


def compile_kernel(root: Path) -> list[Path]:
    """Compile the kernel below `root`, the folder of pyproject.toml; the paths of its libraries.

    They are those of this platform: for Python and, where FMI has a name for it, for FMUs. Nothing
    is compiled where they are there already, of the same sources, compiler and options.
    """
    compiler = any_compiler()
    if not kernel_sources(root / SOURCES):
        text = f"no C source in {SOURCES}: the source tree is incomplete, take all of it"
        raise CompilerError(text)
    system, own = platform.system(), own_platform()
    options = _without_runtime(compiler)
    command = [*compiler, *flags(system), *options]
    libraries: dict[Path, Kind] = {
        root / LIBRARIES / library_name(system, dimension): Kind(dimension)
        for dimension in DIMENSIONS
    }
    for kind in _slaves(root) if own else ():
        libraries[library_path(root / SLAVES, own, kind.dimension, kind.scope)] = kind

    def compiled(target: Path, kind: Kind) -> Path:
        # The new file takes the old one's place at once: a running process may have that mapped.
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=target.parent, prefix="compile-") as scratch:
            new = Path(scratch, target.name)
            compile_library(compiler, root / SOURCES, kind, new, *options)
            return new.replace(target)

    write_headers((root / SOURCES).parent)
    inputs = digest_of_inputs(root, command, (SOURCES, SLAVE_SOURCES))
    found = [*libraries]
    if is_compiled(root, inputs, found):
        print("the kernel is compiled already, of the same sources by the same command")
    else:
        print("compiling the kernel:", shlex.join(command))
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            found = [*pool.map(lambda item: compiled(*item), libraries.items())]
        keep_record(root, inputs, found)
    others = {
        *(root / LIBRARIES).glob("libholonom_*"),
        *(root / SLAVES).glob("native/_libraries/*/*"),
    }
    for other in others - {*found}:
        if other.is_file():  # of another platform and, it may be, of other sources
            other.unlink()  # a folder is what an interrupted compiler left
    return found


def compile_for_all(root: Path) -> None:
    """Compile all libraries with zig, Python's and those of FMUs, for each of `PLATFORMS`.

    Python's go to `KERNELS`, and those of this machine's platform to where Python loads them.

    Raises
    ------
    CompilerError
        When zig is not installed, or refuses.
    """
    if importlib.util.find_spec("ziglang") is None:
        text = (
            "the kernels of all platforms are compiled with zig, which is not installed\n"
            "remedy: pip install ziglang (100 MB, 400 MB unpacked)"
        )
        raise CompilerError(text)
    write_headers((root / SOURCES).parent)
    with tempfile.TemporaryDirectory(dir=root) as folder:
        for name in PLATFORMS:
            jobs = {
                library_path(root / SLAVES, name, kind.dimension, kind.scope): kind
                for kind in _slaves(root)
            }
            system = _system(PLATFORMS[name].targets[0])
            for dimension in DIMENSIONS:
                jobs[root / KERNELS / name / library_name(system, dimension)] = Kind(dimension)
            for target, kind in jobs.items():
                new, parts = Path(folder, target.name), []
                for zig_name in PLATFORMS[name].targets:
                    _compile_with_zig(root, zig_name, kind, new)
                    parts.append(new.read_bytes())
                new.write_bytes(universal(parts) if len(parts) > 1 else parts[0])
                target.parent.mkdir(parents=True, exist_ok=True)
                new.replace(target)
    take_kernels(root, own_platform())


def take_kernels(root: Path, platform: str) -> None:
    """Put the kernels of a platform where Python loads them."""
    (root / LIBRARIES).mkdir(parents=True, exist_ok=True)
    for old in (root / LIBRARIES).glob("libholonom_*"):
        old.unlink()
    for kernel in (root / KERNELS / platform).glob("libholonom_*"):
        shutil.copy(kernel, root / LIBRARIES)


def _slaves(root: Path) -> list[Kind]:
    """Libraries of FMUs for one platform."""
    return [Kind(d, scope, root / SLAVE_SOURCES) for d in DIMENSIONS for scope in SCOPES]


def _compile_with_zig(root: Path, zig_name: str, kind: Kind, target: Path) -> None:
    compiler = [sys.executable, "-m", "ziglang", "cc", "-target", zig_name]
    system = _system(zig_name)
    options = [*_without_runtime(compiler)]
    if kind.slave is not None:
        options += ["-Os", "-fomit-frame-pointer"]
        # Handlers of exceptions on Windows need the tables. stack_probe.c is all that is taken of a
        # run-time library there, and none is to be started.
        if system == "Windows":
            options += ["-nostdlib", "-lc", "-Wl,--no-entry"]
        else:
            options += ["-fno-unwind-tables", "-fno-asynchronous-unwind-tables"]
    if system == "Darwin":
        options.append(f"-Wl,-install_name,@rpath/{target.name}")
    print("compiling", target.name, "for", zig_name)
    compile_library(compiler, root / SOURCES, kind, target, *options, system=system)


def _system(zig_name: str) -> str:
    return next((system for word, system in SYSTEMS.items() if word in zig_name), "Linux")


def compile_library(
    compiler: list[str],
    folder: Path,
    kind: Kind,
    target: Path,
    *options: str,
    system: str | None = None,
) -> None:
    """Compile the C sources in a folder into a library of this kind.

    `system` is the operating system that it is for, this one where left out.

    Raises
    ------
    CompilerError
        When the compiler refuses; the text has its message.
    """
    write_headers(folder.parent)
    sources = [str(path.relative_to(folder)) for path in kernel_sources(folder)]
    if kind.slave is not None:
        sources += sorted(str(path.resolve()) for path in kind.slave.glob("*.c"))
        options = ("-DHOLONOM_STATIC", *options)
    macros = f"-DDIM={kind.dimension}", f"-DHM_SCOPE={SCOPES.index(kind.scope)}"
    options = (*flags(system or platform.system()), *macros, *includes(folder), *options)
    command = [*compiler, *options, "-o", str(target), *sources, "-lm"]
    run = _run(command, folder, str(target.parent))
    if run.returncode != 0:
        raise CompilerError(_failure(command, run.stdout))


def kernel_sources(folder: Path) -> list[Path]:
    """C files of the kernel, in its folder and the rooms below, by name: names occur once."""
    return sorted(folder.rglob("*.c"), key=lambda path: path.name)


def includes(folder: Path) -> list[str]:
    """Options for a compiler to find each header of the kernel by its name alone."""
    rooms = {path.parent.resolve() for path in folder.rglob("*.h")}
    return [f"-I{room}" for room in sorted(rooms)]


def any_compiler() -> list[str]:
    """Command of a C compiler of this machine or, where it has none, of the `ziglang` wheel.

    Raises
    ------
    CompilerError
        When there is neither; the text has the remedy.
    """
    if compiler := system_compiler() or zig_compiler():
        return compiler
    text = (
        "a C compiler is needed, and neither $CC nor cc, gcc, clang works here\n"
        "remedy: install one, or its replacement from PyPI: pip install ziglang"
    )
    raise CompilerError(text)


def system_compiler() -> list[str] | None:
    """Command of this machine's C compiler: `$CC`, or one that works; None if there is none."""
    chosen = shlex.split(os.environ.get("CC", ""))
    if chosen and shutil.which(chosen[0]):
        return chosen
    for name in SYSTEM_COMPILERS:
        path = shutil.which(name)
        if path is not None and _works(path):
            return [path]
    return None


def zig_compiler() -> list[str] | None:
    """Command of the C compiler in the `ziglang` wheel, None if that is not installed."""
    if importlib.util.find_spec("ziglang") is None:
        return None
    target = zig_target(platform.system(), platform.machine(), platform.libc_ver()[0])
    return [sys.executable, "-m", "ziglang", "cc", "-target", target]


def zig_target(system: str, machine: str, libc: str) -> str:
    """Zig's name of a platform, from what Python's `platform` calls it."""
    architecture = {"amd64": "x86_64", "arm64": "aarch64"}.get(machine.lower(), machine.lower())
    if system == "Windows":
        return f"{architecture}-windows-gnu"
    if system == "Darwin":
        return f"{architecture}-macos"
    return f"{architecture}-linux-" + ("gnu.2.17" if libc == "glibc" else "musl")


def library_name(system: str, dimension: int) -> str:
    """File name of the kernel on an operating system for mechanisms of this dimension."""
    suffix = {"Windows": ".dll", "Darwin": ".dylib"}.get(system, ".so")
    return f"libholonom_{DIMENSIONS[dimension]}{suffix}"


def flags(system: str) -> list[str]:
    """Flags of every compiler for an operating system; those of `$CFLAGS` come last and so win."""
    strip = [] if system == "Darwin" else ["-s"]  # zig's library is else four times as big
    # Elsewhere the tables are part of the platform's interface; here only exceptions, of which C
    # has none, and debuggers read them. Nor is anything to be run when a library is loaded.
    lean = ["-fno-asynchronous-unwind-tables", "-nostartfiles"] if system == "Linux" else []
    # No name of the compiler or the build; functions in an order that takes 0.4 kB less in an FMU.
    if lean:
        lean += ["-fno-ident", "-Wl,--build-id=none", "-Wl,--sort-section=alignment"]
    # Functions that nobody calls are left out: a library of FMUs has no use for some.
    called = "-Wl,-dead_strip" if system == "Darwin" else "-Wl,--gc-sections"
    return [*FLAGS, *strip, *lean, called, *shlex.split(os.environ.get("CFLAGS", ""))]


def _without_runtime(compiler: list[str]) -> list[str]:
    """Options that keep zig from compiling its run-time library: the kernel needs none of it."""
    glibc = "ziglang" in compiler and any("-linux-gnu" in word for word in compiler)
    return ["-nostdlib", "-lc"] if glibc else []


def _works(compiler: str) -> bool:
    # A compiler without the headers of libc, or the stub that macOS has for one, counts as none.
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "probe.c").write_text(PROBE)
        command = [compiler, "-fPIC", "-shared", "-o", "probe.out", "probe.c", "-lm"]
        return _run(command, Path(folder), folder).returncode == 0


def _run(command: list[str], where: Path, scratch: str) -> subprocess.CompletedProcess[str]:
    # Zig caches what it compiles of libc, by default below $HOME, which a build may not have.
    caches = {"ZIG_GLOBAL_CACHE_DIR": scratch, "ZIG_LOCAL_CACHE_DIR": scratch}
    return subprocess.run(
        command,
        cwd=where,
        env=caches | dict(os.environ),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )


def _failure(command: list[str], output: str) -> str:
    return (
        f"the kernel does not compile\n{shlex.join(command)}\n{output.rstrip()}\n"
        "remedy: CC=... chooses another compiler, for instance, after pip install ziglang,\n"
        "CC='python -m ziglang cc'; CFLAGS=... adds flags"
    )
