# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What is in the wheel, named by PELLUCID_WHEEL, and what it is when it is installed."""

import importlib.metadata
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import zipfile

from vtkmodules.vtkCommonCore import vtkVersion

import pellucid

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = str(pathlib.Path(sys.executable).with_name("pellucid-render"))
VTK_VERSION = vtkVersion.GetVTKVersion()

STUB = """
class vtkVersion:
    @staticmethod
    def GetVTKVersion():
        return "9.4.2"
"""


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=120, **options)


class TestWheel(unittest.TestCase):
    def setUp(self):
        path = pathlib.Path(os.environ["PELLUCID_WHEEL"])
        self.name = path.name
        self.wheel = zipfile.ZipFile(path)
        self.addCleanup(self.wheel.close)
        self.files = self.wheel.namelist()

    def test_tags(self):
        python = f"cp{sys.version_info.major}{sys.version_info.minor}"
        self.assertRegex(self.name, rf"^pellucid-[0-9.]+-{python}-{python}-\w*linux\w*\.whl$")

    def test_files(self):
        for file in self.files:
            self.assertRegex(file, r"^pellucid(-[0-9.]+\.dist-info)?/")
        libraries = [file for file in self.files if "/lib" in file]
        self.assertEqual(
            libraries, ["pellucid/libvtkPellucidFilters.so", "pellucid/libvtkPellucidRendering.so"])
        for file in ("py.typed", "vtkPellucidFilters.pyi", "vtkPellucidRendering.pyi",
                     "bin/pellucid-render"):
            self.assertIn(f"pellucid/{file}", self.files)
        stubs = self.wheel.read("pellucid/vtkPellucidRendering.pyi").decode()
        self.assertIn("class vtkTrajectoryMapper(", stubs)
        self.assertLess(sum(info.file_size for info in self.wheel.infolist()), 10e6)

    def test_licences(self):
        for file in ("LICENSE", "Rendering/Python/THIRD-PARTY-LICENSES"):
            found, = (name for name in self.files if name.endswith(f"/licenses/{file}"))
            self.assertEqual(self.wheel.read(found), (ROOT / file).read_bytes())

    def test_versions_have_one_source(self):
        project = re.search(r"project\(Pellucid\s+VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
        version = project.group(1)
        self.assertIn(f"\nversion: {version}\n", (ROOT / "CITATION.cff").read_text())
        self.assertEqual(importlib.metadata.version("pellucid"), version)
        self.assertEqual(pellucid.__version__, version)
        self.assertIn(version, run(PROGRAM, "--version").stdout)
        self.assertEqual(
            sorted(importlib.metadata.requires("pellucid")), ["numpy", f"vtk=={VTK_VERSION}"])

    def test_description_is_whole_without_our_files(self):
        metadata = importlib.metadata.metadata("pellucid")
        self.assertEqual(metadata["Description-Content-Type"], "text/markdown")
        text = metadata.get_payload() or metadata["Description"]
        self.assertIn("pellucid.install(plotter)", text)
        self.assertNotRegex(text, r"\]\((?!https://)")

    def test_no_path_of_the_build(self):
        for file in self.files:
            if file.endswith(".so") or "/bin/" in file:
                self.assertNotIn(b"site-packages/vtk_sdk", self.wheel.read(file))


class TestInstalled(unittest.TestCase):
    def test_imports_without_a_display(self):
        environment = {"PATH": os.environ["PATH"]}
        done = run(sys.executable, "-c", "import pellucid", env=environment)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_program_ends_as_the_program_does(self):
        done = run(PROGRAM, "no-such-file.vtk", "-o", "picture.png")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no-such-file.vtk", done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_signals_end_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(pathlib.Path(pellucid.__file__).with_name("_program.py"), folder)
            program = pathlib.Path(folder, "bin", "pellucid-render")
            program.parent.mkdir()
            program.write_text("#!/bin/sh\nkill -s \"$1\" $$\n")
            program.chmod(0o755)
            # Shells start what runs in the background with SIGINT ignored, and children inherit that.
            before = signal.signal(signal.SIGINT, signal.SIG_DFL)
            self.addCleanup(signal.signal, signal.SIGINT, before)
            for name in ("SEGV", "INT"):
                done = run(sys.executable, "-c", "import _program; _program.main()", name, cwd=folder)
                self.assertEqual((done.returncode, done.stderr), (-signal.Signals[f"SIG{name}"], ""))

    def test_another_vtk_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "vtkmodules")
            package.mkdir()
            (package / "__init__.py").touch()
            (package / "vtkCommonCore.py").write_text(STUB)
            done = run(sys.executable, "-c", "import pellucid", env={**os.environ, "PYTHONPATH": folder})
        self.assertEqual(done.returncode, 1)
        self.assertIn(
            f"ImportError: pellucid {pellucid.__version__} was built for VTK {VTK_VERSION}, and this is "
            "VTK 9.4.2. Install a pellucid for this VTK, or build one against it, or install VTK "
            f"{VTK_VERSION} (pip install vtk=={VTK_VERSION}).", done.stderr)


if __name__ == "__main__":
    unittest.main()
