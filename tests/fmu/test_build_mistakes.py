"""What `build` answers where an FMU cannot be packaged as asked."""

from __future__ import annotations

import zipfile
from pathlib import Path

import pytest

from build_fmu import build, payload
from build_fmu.command_line import main

SCENE = str(Path(__file__).parents[2] / "scenes" / "double_pendulum.toml")


def test_a_version_of_fmi_that_there_is_not_is_refused(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["build", SCENE, "--native", "--fmi", "4"])
    assert stop.value.code == 2
    assert "--fmi: invalid choice: 4" in capsys.readouterr().err


@pytest.mark.parametrize("native", [("--native", "--platforms", "all"), ()])
def test_a_missing_library_is_exit_4_with_its_remedy(native, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(payload, "library_path", lambda *_: tmp_path / "none.so")
    payload.payload.cache_clear()
    assert main(["build", SCENE, *native, "-o", str(tmp_path / "a.fmu")]) == 4
    said = capsys.readouterr().err
    assert "none.so" in said
    assert "python -m build_kernel" in said
    assert not list(tmp_path.iterdir())


def test_a_name_that_is_no_name_in_c_is_refused_with_its_line(tmp_path, capsys):
    scene = tmp_path / "arm.toml"
    text = Path(SCENE).read_text(encoding="utf-8")
    scene.write_text(text.replace("double_pendulum", "3d arm-ü"), encoding="utf-8")
    assert main(["build", str(scene), "--native", "-o", str(tmp_path)]) == 2
    assert "name: '3d arm-ü' is not a name: a letter, then letters" in capsys.readouterr().err


def test_the_page_of_an_fmu_of_sources_alone_says_that_they_are_to_be_compiled(tmp_path):
    path = build(SCENE, tmp_path, native=True, platforms="none", sources=True)
    with zipfile.ZipFile(path) as archive:
        needs = archive.read("documentation/externalDependencies.txt").decode()
    assert "compiles its sources" in needs
    assert "binaries" not in needs
