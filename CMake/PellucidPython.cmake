# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package `pellucid`: the wrapped modules and the sources in Rendering/Python.
if (NOT VTK_WRAP_PYTHON)
  message(FATAL_ERROR
    "PELLUCID_WRAP_PYTHON is ON, but the VTK found was built without Python. "
    "Set PELLUCID_WRAP_PYTHON=OFF or choose another VTK with VTK_DIR.")
endif ()

vtk_module_python_default_destination(pellucid_python_destination)
vtk_module_wrap_python(
  MODULES ${pellucid_modules}
  INSTALL_HEADERS OFF
  PYTHON_PACKAGE "pellucid"
  MODULE_DESTINATION "${pellucid_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  TARGET Pellucid::Python
  BUILD_STATIC OFF)

include(PellucidPythonSources)
pellucid_install_python_sources("${pellucid_python_destination}")
