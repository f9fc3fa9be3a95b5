#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Assemble the SDK of the VTK 9.5.0 wheel for Linux x86_64 in this Python environment.

An SDK carries the headers, CMake files and hierarchy files that are needed to build against the
`vtk` wheel. The package index holds the SDK of 9.5.0 for macOS only. This script takes the parts of
it that do not depend on the platform, points every imported target at the libraries of the
installed wheel, and lends it the wrapping tools of Debian's paraview-dev (VTK 9.2). The result is
an installed package `vtk_sdk`, which scikit-build-core finds like an official one. It serves the
tests; a release is built with an official SDK.

Needs a virtual environment with `vtk==9.5.0`, and Debian's paraview-dev. It replaces an SDK that it
assembled before, and leaves one alone that something else installed.

    venv/bin/python assemble_vtk_sdk.py               assemble, then print the folder for VTK_DIR
    venv/bin/python assemble_vtk_sdk.py --vtk-dir     print that folder only

The wheel has libstdc++'s old string ABI. Pellucid's CMake files find that out by themselves; other
projects add -D_GLIBCXX_USE_CXX11_ABI=0 to every target that links VTK.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

VERSION = "9.5.0"
SITE = pathlib.Path(sysconfig.get_path("platlib"))
LIBRARIES = SITE / "vtkmodules"
SDK = SITE / "vtk_sdk"
DATA = f"content/vtk-{VERSION}.data/headers"
VTK_DIR = SDK / DATA / "cmake"
INFO = SITE / f"vtk_sdk-{VERSION}.dist-info"
INSTALLER = "assemble_vtk_sdk\n"
EXTENSION_SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")
PYTHON = f"{sys.version_info.major}.{sys.version_info.minor}"

# The macOS wheel that the parts come from, and the Debian tools that work on them.
DONOR = ["--platform", "macosx_11_0_arm64", "--python-version", "3.10"]
DONOR_PYTHON = "3.10"
TOOLS = pathlib.Path("/usr/bin")
TOOL_SUFFIX = "-pv5.11"


def fail(message):
    sys.exit(f"assemble_vtk_sdk: {message}")


def check_needs():
    """Stop early, and say what is missing."""
    if not list(LIBRARIES.glob("libvtkCommonCore*")):
        fail(f"no VTK wheel in {SITE}; run: {sys.executable} -m pip install vtk=={VERSION}")
    if not (TOOLS / f"vtkWrapPython{TOOL_SUFFIX}").exists():
        fail(f"{TOOLS}/vtkWrapPython{TOOL_SUFFIX} is missing; install Debian's paraview-dev")
    installer = INFO / "INSTALLER"
    if SDK.exists() and not (installer.exists() and installer.read_text() == INSTALLER):
        fail(f"{SDK} was installed by something else; use it, or uninstall vtk-sdk first")


def download(folder):
    """Fetch the donor wheel with pip; return its path."""
    subprocess.run(
        [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check",
         "--no-deps", "--only-binary=:all:", *DONOR, "--dest", folder, f"vtk-sdk=={VERSION}"],
        check=True)
    return next(pathlib.Path(folder).glob("*.whl"))


def unpack(wheel):
    """Extract headers, CMake files and hierarchy files: everything but binaries."""
    wanted = (f"vtk_sdk/{DATA}/", "vtk_sdk/cmake/", "vtk_sdk/_")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(SITE, [n for n in archive.namelist() if n.startswith(wanted)])


def edit(path, pattern, replacement):
    """Replace every match of a pattern; a file without one is not the file we know."""
    text, count = re.subn(pattern, replacement, path.read_text())
    if not count:
        fail(f"{path.name} is not as expected: no match of {pattern}")
    path.write_text(text)


def retarget():
    """Point the imported targets at the libraries of the installed wheel."""
    def shared_object(match):
        return match.group(1).replace(DONOR_PYTHON, PYTHON) + ".so"

    for path in VTK_DIR.rglob("*argets-release.cmake"):
        text = path.read_text()
        text = re.sub(r'\$\{_IMPORT_PREFIX\}/build/[^"]*/([^/"]+)\.dylib',
                      lambda m: f"{LIBRARIES}/{shared_object(m)}", text)
        text = re.sub(r'\$\{_IMPORT_PREFIX\}/\./vtkmodules/([^".]+)\.cpython-310-darwin\.so',
                      lambda m: f"{LIBRARIES}/{m.group(1)}{EXTENSION_SUFFIX}", text)
        text = re.sub(r'@rpath/([^"]+)\.dylib', shared_object, text)
        for library in re.findall(rf'"({re.escape(str(LIBRARIES))}/[^"]+)"', text):
            if not pathlib.Path(library).exists():
                fail(f"{library} is missing: the installed wheel is not vtk=={VERSION}")
        path.write_text(text)
    edit(VTK_DIR / "VTK-targets.cmake", r";-framework Cocoa", "")


# Names of Python 2 that the older wrapping tools still write.
OLD_PYTHON_NAMES = """
#ifndef PyInt_Type
#define PyIntObject PyLongObject
#define PyInt_Type PyLong_Type
#define PyInt_Check PyLong_Check
#define PyInt_FromLong PyLong_FromLong
#define PyInt_AsLong PyLong_AsLong
#define PyString_AsString PyUnicode_AsUTF8
#define PyString_InternFromString PyUnicode_InternFromString
#define PyString_FromFormat PyUnicode_FromFormat
#define PyString_Check PyUnicode_Check
#define PyString_FromString PyUnicode_FromString
#define PyString_FromStringAndSize PyUnicode_FromStringAndSize
#endif
"""


def adapt_headers():
    """Window system of Linux; what the older wrapping tools do not know yet, or still ask for."""
    headers = SDK / DATA / "vtk-9.5"
    with open(headers / "vtkPythonCompatibility.h", "a") as compatibility:
        compatibility.write(OLD_PYTHON_NAMES)
    edit(headers / "vtkRenderingOpenGLConfigure.h", "#define VTK_USE_COCOA", "#define VTK_USE_X")
    edit(headers / "vtkWrappingHints.h",
         r"(#define VTK_(?:MARSHAL\w+(?:\(\w+\))?|UNBLOCKTHREADS|PROPEXCLUDE)) \[\[.*", r"\1")


def write_script(path, body):
    path.write_text("#!/bin/sh\n" + body)
    path.chmod(0o755)


def lend_tools():
    """Scripts with today's command lines around the older tools."""
    folder = SDK / "content" / "bin"
    folder.mkdir(parents=True)
    # Newer CMake code asks for a dependency file, which the older tools cannot write.
    dependencies = 'if [ "$1" = -MF ]; then printf "%s:\\n" "${2%.d}" > "$2"; shift 2; fi\n'
    for tool in ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapJava", "vtkParseJava"):
        write_script(folder / tool, dependencies + f'exec {TOOLS}/{tool}{TOOL_SUFFIX} "$@"\n')
    # Newer: one output file. Older: one for the declarations, one for the implementation.
    write_script(
        folder / "vtkWrapPythonInit",
        f'{TOOLS}/vtkWrapPythonInit{TOOL_SUFFIX} "$1" "$2" "$2.impl" && cat "$2.impl" >> "$2"\n')
    for tool in ("vtkWrapSerDes", "vtkProbeOpenGLVersion"):
        write_script(folder / tool, f'echo "{tool} is not in the assembled SDK" >&2; exit 1\n')


def register():
    """Make the package visible to pip and to scikit-build-core."""
    shutil.rmtree(INFO, ignore_errors=True)
    INFO.mkdir()
    (INFO / "METADATA").write_text(f"Metadata-Version: 2.1\nName: vtk-sdk\nVersion: {VERSION}\n")
    (INFO / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: assemble\nRoot-Is-Purelib: false\n")
    (INFO / "INSTALLER").write_text(INSTALLER)
    (INFO / "entry_points.txt").write_text("[cmake.prefix]\nany = vtk_sdk.cmake\n")
    (INFO / "RECORD").write_text("")


def assemble():
    check_needs()
    shutil.rmtree(SDK, ignore_errors=True)
    with tempfile.TemporaryDirectory() as folder:
        unpack(download(folder))
    retarget()
    adapt_headers()
    lend_tools()
    register()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--vtk-dir", action="store_true", help="print the folder for VTK_DIR only")
    if not parser.parse_args().vtk_dir:
        assemble()
    elif not VTK_DIR.exists():
        fail("nothing assembled yet; run without --vtk-dir first")
    print(VTK_DIR)


if __name__ == "__main__":
    main()
