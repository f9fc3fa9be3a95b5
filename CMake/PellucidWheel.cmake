# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# The wheel: one folder `pellucid` beside VTK's `vtkmodules`, with libraries, wrapped modules, their
# type stubs, Python sources and the program. pyproject.toml brings VTK's SDK and its helper.
include(VTKSDKPythonWheelHelper)
vtksdk_build_modules(pellucid
  SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}/Filters;${CMAKE_CURRENT_SOURCE_DIR}/Rendering"
  MODULES Pellucid::Filters Pellucid::Rendering)

include(PellucidPythonSources)
pellucid_install_python_sources("." _program.py)

# Type stubs by VTK's generator, which loads the modules; the helper's option makes none.
set(pellucid_stubs "${CMAKE_BINARY_DIR}/stubs")
file(MAKE_DIRECTORY "${pellucid_stubs}")
file(TOUCH "${pellucid_stubs}/py.typed")
add_custom_command(
  OUTPUT "${pellucid_stubs}/vtkPellucidFilters.pyi" "${pellucid_stubs}/vtkPellucidRendering.pyi"
  COMMAND "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi
    -p pellucid -o "${pellucid_stubs}" vtkPellucidFilters vtkPellucidRendering
  WORKING_DIRECTORY "${CMAKE_BINARY_DIR}"
  DEPENDS vtkPellucidFiltersPython vtkPellucidRenderingPython
  COMMENT "Creating type stubs"
  VERBATIM)
add_custom_target(pellucid_stubs ALL
  DEPENDS "${pellucid_stubs}/vtkPellucidFilters.pyi" "${pellucid_stubs}/vtkPellucidRendering.pyi")
install(DIRECTORY "${pellucid_stubs}/" DESTINATION pellucid)

# Beside the libraries, where it finds them and VTK's wherever the wheel is put; the command is a script
# that starts it.
set(CMAKE_INSTALL_BINDIR "pellucid/bin")
set(CMAKE_INSTALL_LIBDIR "")
set(CMAKE_INSTALL_RPATH "$ORIGIN/../../vtkmodules")
set(PELLUCID_BUILD_VIEWER OFF) # it needs libraries that a wheel does not bring
add_subdirectory(Rendering/Applications)
