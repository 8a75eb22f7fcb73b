"""The build: which compiler is taken, what a failure says, what the archives hold."""

from __future__ import annotations

import importlib.util
import os
import platform
import re
import shutil
import stat
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

import pytest

from build_fmu.export import TOOL
from build_fmu.platforms import PLATFORMS
from build_fmu.version import VERSION
from build_kernel import backend, compiler
from build_kernel.record import RECORD
from solver.runtime.kernel import library_path

ROOT = Path(__file__).resolve().parents[2]
TRAVELS = ("build_fmu", "build_kernel", "fmu_src", "holonom", "scenes", "solver", "viewer")
TOP_FILES = ("CHANGELOG.md", "LICENSE", "MANIFEST.in", "README.md", "pyproject.toml")
UNUSED = re.compile(
    r"ziglang/lib/(libcxx|libtsan|libc/mingw|libc/include/(?![^/]*(linux|glibc|musl|darwin)))"
)
"""Two thirds of the 20 000 files in zig's wheel: for C++, for other systems."""


def write_compiler(folder: Path, name: str, script: str = "exit 0") -> Path:
    """Write a stand-in for a compiler, so that no test depends on this machine's."""
    path = folder / name
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.fixture
def path_folder(tmp_path, monkeypatch):
    """The one folder of PATH, empty; $CC and $CFLAGS are unset."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.delenv("CFLAGS", raising=False)
    return folder


@pytest.fixture
def tree(tmp_path):
    """A source tree with one C source."""
    (tmp_path / compiler.SOURCES).mkdir(parents=True)
    (tmp_path / compiler.SOURCES / "holonom.c").write_text("typedef int empty;\n")
    (tmp_path / compiler.LIBRARIES.parent).mkdir(parents=True)
    for name in ("options.py", "runtime/layout.py", "runtime/errors.py", "kernel/scratch.py"):
        shutil.copy(ROOT / "solver" / name, tmp_path / "solver" / name)
    return tmp_path


def copy_of_repository(folder: Path) -> Path:
    """Copy what the archives are made of, without anything built."""
    ignored = shutil.ignore_patterns("__pycache__", "_kernel", "*.fmu")
    for name in filter(lambda name: (ROOT / name).exists(), TRAVELS):
        shutil.copytree(ROOT / name, folder / name, ignore=ignored)
    for name in TOP_FILES:
        shutil.copy(ROOT / name, folder / name)
    return folder


def run_hook(tree: Path, call: str) -> str:
    """Call one hook of the build backend in its own process, as pip does; its result as text."""
    code = f"import sys; sys.stdout = sys.stderr; from build_kernel import backend; r = {call}\n"
    run = subprocess.run(
        [sys.executable, "-c", code + "print(r, file=sys.__stdout__)"],
        cwd=tree,
        env=os.environ | {"PYTHONPATH": str(tree)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout.strip()


@pytest.mark.parametrize("name", compiler.SYSTEM_COMPILERS)
def test_any_system_compiler_is_taken(path_folder, name):
    path = write_compiler(path_folder, name)
    assert compiler.system_compiler() == [str(path)]


def test_the_compiler_named_by_cc_comes_first(path_folder, monkeypatch):
    write_compiler(path_folder, "cc")
    write_compiler(path_folder, "mine", "exit 1")  # named by the user: taken at the user's word
    monkeypatch.setenv("CC", "mine -m64")
    assert compiler.system_compiler() == ["mine", "-m64"]


def test_a_compiler_that_cannot_link_counts_as_none(path_folder):
    write_compiler(path_folder, "cc", "exit 1")
    assert compiler.system_compiler() is None
    path = write_compiler(path_folder, "gcc")
    assert compiler.system_compiler() == [str(path)]


@pytest.mark.parametrize(
    "hook", ["get_requires_for_build_wheel", "get_requires_for_build_editable"]
)
def test_ziglang_is_required_only_without_a_compiler(tmp_path, path_folder, hook):
    tree = copy_of_repository(tmp_path)
    assert run_hook(tree, f"'ziglang' in backend.{hook}()") == "True"
    write_compiler(path_folder, "cc")
    assert run_hook(tree, f"'ziglang' in backend.{hook}()") == "False"


def test_a_failed_compile_shows_the_compilers_message_and_the_remedy(
    tree, path_folder, monkeypatch
):
    monkeypatch.setenv("CC", "cc")
    write_compiler(path_folder, "cc", "echo 'holonom.c:1: error: unused variable'; exit 1")
    library = tree / compiler.LIBRARIES / compiler.library_name("Linux", 2)
    library.parent.mkdir()
    library.write_text("the kernel of before")
    with pytest.raises(compiler.CompilerError) as failure:
        compiler.compile_kernel(tree)
    text = str(failure.value)
    assert "holonom.c:1: error: unused variable" in text
    assert "cc -std=c99" in text
    assert "remedy: CC=... chooses another compiler" in text
    assert [path.name for path in library.parent.iterdir()] == [library.name]
    assert library.read_text() == "the kernel of before"


@pytest.mark.usefixtures("path_folder")
def test_without_any_compiler_the_message_says_what_to_install(tree, monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(compiler.CompilerError, match="pip install ziglang"):
        compiler.compile_kernel(tree)


def test_a_tree_without_sources_is_refused(tmp_path):
    with pytest.raises(compiler.CompilerError, match="source tree is incomplete"):
        compiler.compile_kernel(tmp_path)


def test_the_flags_of_the_user_come_last(monkeypatch):
    monkeypatch.setenv("CFLAGS", "-Wno-error -O1")
    assert compiler.flags("Linux")[-2:] == ["-Wno-error", "-O1"]


def test_a_warning_stops_the_checks_of_the_project_but_no_installation(
    tree, path_folder, monkeypatch
):
    # A newer compiler warns of what none did before: users must not be the ones who find out.
    warns = """
case "$*" in *"-Werror "*) echo "holonom.c:1: error: unused"; exit 1;; esac
while [ "$1" != -o ]; do shift; done
echo "holonom.c:1: warning: unused"
echo library > "$2"
"""
    write_compiler(path_folder, "cc", warns)
    monkeypatch.setenv("CC", "cc")
    assert [path.read_text() for path in compiler.compile_kernel(tree)] == 8 * ["library\n"]
    monkeypatch.setenv("CFLAGS", "-Werror")
    with pytest.raises(compiler.CompilerError, match="error: unused"):
        compiler.compile_kernel(tree)


COUNTS = """
while [ "$1" != -o ]; do shift; done
echo run >> "$RUNS"
echo library > "$2"
"""
"""A compiler that leaves a line for each library."""


def test_what_is_compiled_is_not_compiled_again_until_something_changes(
    tree, path_folder, monkeypatch
):
    """`make demo` after an installation, and a pull that changes no source, need no compiler."""
    runs = tree / "runs.txt"
    monkeypatch.setenv("RUNS", str(runs))
    monkeypatch.setenv("CC", "cc")
    program = write_compiler(path_folder, "cc", COUNTS)

    def compiled() -> int:
        runs.write_text("")
        libraries[:] = compiler.compile_kernel(tree)
        assert [path.read_text() for path in libraries] == 8 * ["library\n"]
        return len(runs.read_text().splitlines())

    libraries: list[Path] = []
    assert [compiled(), compiled()] == [8, 0]
    source = tree / compiler.SOURCES / "holonom.c"
    layout = tree / "solver/runtime/layout.py"
    os.utime(source, (1e9, 1e9))  # as a checkout of the same text does
    assert compiled() == 0
    for change in (
        lambda: source.write_text("typedef int other;\n"),
        lambda: monkeypatch.setenv("CFLAGS", "-O1"),
        lambda: os.utime(program, (1e9, 1e9)),  # another version of the compiler
        libraries[0].unlink,
        lambda: libraries[-1].write_text("of another platform"),
        lambda: (tree / RECORD).write_text("{"),
        lambda: layout.write_text(layout.read_text().replace("MOST_LEVELS = 3", "MOST_LEVELS = 4")),
    ):
        change()
        assert [compiled(), compiled()] == [8, 0]


@pytest.mark.skipif(compiler.system_compiler() is None, reason="needs a C compiler")
def test_a_function_that_nothing_declares_is_an_error(tree, monkeypatch):
    """It would take and return integers; C99 compilers may let it pass with a warning."""
    monkeypatch.delenv("CFLAGS", raising=False)
    source = "int own(int x);\nint own(int x) { return x + unheard_of(x); }\n"
    (tree / compiler.SOURCES / "holonom.c").write_text(source)
    with pytest.raises(compiler.CompilerError, match="unheard_of"):
        compiler.compile_kernel(tree)


def test_the_checks_of_the_project_compile_without_a_warning(monkeypatch):
    makefile, flags = (ROOT / "Makefile").read_text(), []
    recipe = makefile.partition("\n$(VENV)/installed-tools:")[2].partition("\n\n")[0]
    assert "\nWARNINGS := -Werror -Wshadow -Wcast-qual -Wconversion " in makefile
    assert '-C cflags="$(WARNINGS)"' in recipe
    monkeypatch.setenv("CFLAGS", "")
    monkeypatch.setattr(backend, "compile_kernel", lambda _: flags.extend(compiler.flags("Linux")))
    monkeypatch.setattr(backend.build_meta, "build_editable", lambda *_: "a wheel")
    assert backend.build_editable("", {"cflags": "-Werror -Wshadow"}) == "a wheel"
    assert flags[-2:] == ["-Werror", "-Wshadow"]


@pytest.mark.parametrize(
    ("machine", "target", "suffix"),
    [
        (("Linux", "x86_64", "glibc"), "x86_64-linux-gnu.2.17", ".so"),
        (("Linux", "aarch64", "glibc"), "aarch64-linux-gnu.2.17", ".so"),
        (("Linux", "x86_64", ""), "x86_64-linux-musl", ".so"),
        (("Windows", "AMD64", ""), "x86_64-windows-gnu", ".dll"),
        (("Darwin", "arm64", ""), "aarch64-macos", ".dylib"),
    ],
)
def test_each_platform_has_its_target_and_its_libraries(machine, target, suffix):
    assert compiler.zig_target(*machine) == target
    names = [compiler.library_name(machine[0], dimension) for dimension in compiler.DIMENSIONS]
    assert names == [f"libholonom_planar{suffix}", f"libholonom_spatial{suffix}"]


def test_the_libraries_have_the_names_by_which_they_are_loaded():
    for dimension in compiler.DIMENSIONS:
        name = compiler.library_name(platform.system(), dimension)
        assert Path(library_path(dimension)).name == name


STAND_IN = """import os, sys
os.environ["PATH"] = {path!r}
words = sys.argv[sys.argv.index("-target") + 2 :]
if "-DDIM=2" in words and "-DHOLONOM_STATIC" not in words:  # the kernel that a four-bar is run by
    os.execvp({command[0]!r}, [*{command!r}, *words, "-O0"])
open(words[words.index("-o") + 1], "w").close()
"""
"""The package ziglang, of this machine's compiler."""


def write_zig(wheel: Path, files: dict[str, bytes | str]) -> None:
    """Write a wheel of ziglang, with these files and what pip wants to know."""
    about = {"METADATA": "Metadata-Version: 2.1\nName: ziglang\nVersion: 1\n", "RECORD": ""}
    about["WHEEL"] = "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    with zipfile.ZipFile(wheel, "w") as archive:
        for name, text in (
            files | {f"ziglang-1.dist-info/{n}": t for n, t in about.items()}
        ).items():
            archive.writestr(name, text)


@pytest.fixture(params=["stand-in", pytest.param("zig", marks=pytest.mark.long)])
def packages(request, tmp_path):
    """Folder of wheels: setuptools, and ziglang, or what calls this machine's compiler for it.

    Zig's leads to its files: pip takes as long to unpack and remove them all as zig to compile.
    Its 100 MB and its half a minute are for `make long`: here is what asks for it and calls it.
    """
    with tempfile.TemporaryDirectory(dir=tmp_path) as name:
        folder, files = Path(name), Path(name, "files")
        found = compiler.system_compiler()
        run_pip("download", "--no-deps", "--dest", str(folder), "setuptools>=77")
        if request.param == "zig":
            run_pip("download", "--no-deps", "--dest", str(folder), "ziglang")
            (wheel,) = folder.glob("ziglang-*.whl")
            with zipfile.ZipFile(wheel) as archive:
                archive.extractall(files, filter(lambda n: not UNUSED.match(n), archive.namelist()))
            (files / "ziglang/zig").chmod(0o755)
            wheel.unlink()
            write_zig(folder / "ziglang-1-py3-none-any.whl", {"ziglang.pth": str(files)})
        elif not found:
            pytest.skip("no C compiler to stand in for zig")
        else:
            text = STAND_IN.format(path=os.environ["PATH"], command=found)
            package = {"ziglang/__init__.py": "", "ziglang/__main__.py": text}
            write_zig(folder / "ziglang-1-py3-none-any.whl", package)
        yield folder


def test_a_machine_without_a_compiler_gets_a_kernel(tmp_path, packages, path_folder):
    """Source archive, wheel from it, kernel out of the wheel."""
    tree = copy_of_repository(tmp_path / "tree")
    assert list(path_folder.iterdir()) == []
    source = tmp_path / run_hook(tree, f"backend.build_sdist({str(tmp_path)!r})")
    with tarfile.open(source) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert not [name for name in names if name.endswith((".so", ".dll", ".dylib"))]
    assert {
        "solver/kernel/holonom.c",
        "solver/kernel/holonom.h",
        "build_kernel/backend.py",
    } <= names

    found = ["--no-index", "--find-links", str(packages)]
    run_pip("wheel", "--no-deps", *found, "--wheel-dir", str(tmp_path), str(source))
    wheel = next(tmp_path.glob("*.whl"))
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        archive.extractall(tmp_path / "site")
    assert wheel.name.startswith("holonom-")
    assert "-py3-none-" in wheel.name
    assert not wheel.name.endswith("-any.whl")
    scenes = {f"build_fmu/scenes/{path.name}" for path in ROOT.glob("scenes/*.toml")}
    assert scenes == {name for name in names if "/scenes/" in name}  # for holonom init
    assert {name.partition("/")[0] for name in names if "dist-info" not in name} == {
        "build_fmu",
        "fmu_src",
        "holonom",
        "solver",
        "viewer",
    }
    for dimension in compiler.DIMENSIONS:
        name = compiler.library_name(platform.system(), dimension)
        assert (compiler.LIBRARIES / name).as_posix() in names
    # IEEE arithmetic without contraction: another compiler gives the same bits.
    assert four_bar(tmp_path / "site") == four_bar(ROOT)


def test_a_wheel_of_a_release_has_the_kernels_and_the_name_of_its_platform(tmp_path):
    tree = copy_of_repository(tmp_path / "tree")
    for target, name in (
        ("linux64", "planar.so"),
        ("win64", "planar.dll"),
        ("darwin64", "planar.dylib"),
    ):
        (tree / compiler.KERNELS / target).mkdir(parents=True)
        (tree / compiler.KERNELS / target / f"libholonom_{name}").write_text(target)
    found = []
    for target in ("darwin64", "linux64"):  # what the first takes stays out of the second
        wheel = run_hook(
            tree, f"backend.build_wheel({str(tmp_path)!r}, {{'platform': {target!r}}})"
        )
        assert wheel == f"holonom-{VERSION}-py3-none-{PLATFORMS[target].wheel}.whl"
        with zipfile.ZipFile(tmp_path / wheel) as archive:
            found.append({Path(n).suffix for n in archive.namelist() if "libholonom_" in n})
    assert found == [{".dylib"}, {".so"}]


def test_the_changelog_begins_with_the_version():
    headings = re.findall(r"^## \[(.+?)\]", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    assert headings[0] == VERSION
    assert f"holonom {VERSION}" == TOOL  # of FMUs, as their generating tool


def four_bar(packages: Path) -> str:
    """Digest of a run of the four-bar by the kernel below a folder of packages."""
    code = (
        "import hashlib, solver; from pathlib import Path\n"
        f"assert {str(packages)!r} == str(Path(solver.__file__).parent.parent)\n"
        f"scene = solver.load({str(ROOT / 'scenes/four_bar.toml')!r})\n"
        "run = solver.simulate(scene, stop_time=2.0)\n"
        "print(hashlib.sha256(run.table.tobytes()).hexdigest())"
    )
    environment = os.environ | {"PYTHONPATH": str(packages)}
    command = [sys.executable, "-c", code]
    # From the parent folder, for `-c` puts the working folder before all packages.
    return subprocess.check_output(command, cwd=packages.parent, env=environment, text=True)


def run_pip(*arguments: str) -> None:
    """Run a command of pip, which builds in an environment of its own."""
    run = subprocess.run(
        [sys.executable, "-m", "pip", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout
