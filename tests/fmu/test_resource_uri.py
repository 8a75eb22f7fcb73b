"""Where the resources of an FMU of FMI 2.0 are: a file URI in every form that RFC 8089 knows.

Schemes and hosts have no case (RFC 3986, 6.2.2.1), an authority may be left out (FMI 2.0.5, 2.1.5).
"""

from __future__ import annotations

import ctypes
from pathlib import Path
from urllib.parse import quote

import fmpy
import pytest
from fmpy.fmi2 import FMU2Slave

from tests.support.fmus.fmu_instance import Instance, pendulum

FORMS = (
    "file://{}", "file:{}", "file://localhost{}",
    "FILE://{}", "File:{}", "file://LOCALHOST{}", "FILE://LocalHost{}",
)  # fmt: skip
OTHERS = (
    "{}", "http://localhost{}", "files://{}", "file//{}", "file://elsewhere{}", "file://localhostile{}",
    "file:", "file://", "file://localhost", "",
)  # fmt: skip
"""Not a file URI, or not of this machine."""


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory) -> Path:
    """Unpacked FMU below a folder with characters that a URI escapes."""
    folder = tmp_path_factory.mktemp("a b#ü%41+(c)")
    fmpy.extract(str(pendulum(native=True)), str(folder))
    return folder


def made(folder: Path, uri: str) -> tuple[bool, list[str]]:
    """Whether fmi2Instantiate makes an instance, and what it logs."""
    description = fmpy.read_model_description(str(folder))
    fmu = FMU2Slave(
        guid=description.guid, unzipDirectory=str(folder),
        modelIdentifier=description.coSimulation.modelIdentifier,
    )  # fmt: skip
    heard = Instance.__new__(Instance)  # for its callbacks
    heard.log = []
    callbacks = heard._callbacks()
    component = fmu.fmi2Instantiate(
        b"a", 1, description.guid.encode(), uri.encode(), ctypes.byref(callbacks), 0, 0
    )
    if component:
        fmu.fmi2FreeInstance(component)
    fmu.freeLibrary()
    return bool(component), [text for *_, text in heard.log]


@pytest.mark.parametrize("end", ["", "/"])
@pytest.mark.parametrize("form", FORMS)
def test_every_form_of_a_file_uri_leads_to_the_resources(form, end, unpacked):
    path = quote(str(unpacked / "resources"))
    assert "%20" in path
    assert "%2541" in path  # which is %41, and not A
    assert made(unpacked, form.format(path) + end) == (True, [])


@pytest.mark.parametrize("form", OTHERS)
def test_what_is_none_makes_no_instance_and_is_told(form, unpacked):
    is_made, said = made(unpacked, form.format(quote(str(unpacked / "resources"))))
    assert not is_made
    assert len(said) == 1
    assert said[0].startswith("instantiate: ")
