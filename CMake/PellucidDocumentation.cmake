# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# The target `documentation`: the API reference in documentation/html of the build tree. A warning of
# Doxygen fails it, and so does a class or setter whose text leaves out what it has to tell.
find_package(Doxygen 1.9 QUIET)
find_package(Python3 QUIET COMPONENTS Interpreter)
if (NOT Doxygen_FOUND OR NOT Python3_Interpreter_FOUND)
  message(STATUS "Pellucid: without the target documentation, which needs Doxygen 1.9 and Python")
  return ()
endif ()

set(pellucid_documentation_folder "${CMAKE_BINARY_DIR}/documentation")
file(GLOB pellucid_documentation_inputs CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/*.md"
  "${PROJECT_SOURCE_DIR}/Data/README.md"
  "${PROJECT_SOURCE_DIR}/Testing/Benchmark/README.md"
  "${PROJECT_SOURCE_DIR}/Filters/vtk*.h"
  "${PROJECT_SOURCE_DIR}/Rendering/vtk*.h"
  "${PROJECT_SOURCE_DIR}/Plugin/Representations/vtk*.h")
set(pellucid_flatten_package "")
if (PELLUCID_WRAP_PYTHON)
  set(pellucid_flat_package "${pellucid_documentation_folder}/python/pellucid.py")
  list(APPEND pellucid_documentation_inputs "${pellucid_flat_package}")
  set(pellucid_flatten_package
    COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/.ci/flatten_package.py"
      "${CMAKE_BINARY_DIR}/${pellucid_python_destination}/pellucid" "${pellucid_flat_package}")
endif ()
list(TRANSFORM pellucid_documentation_inputs REPLACE "(.+)" "\"\\1\"")
list(JOIN pellucid_documentation_inputs " " pellucid_documentation_inputs)
configure_file(CMake/Doxyfile.in "${pellucid_documentation_folder}/Doxyfile" @ONLY)

# README.md links to folders that are no part of the reference.
set(pellucid_copy_folders "")
foreach (folder IN ITEMS
    Plugin/Documentation Plugin/Examples Rendering/Applications/Example Rendering/Python/Examples)
  list(APPEND pellucid_copy_folders
    COMMAND "${CMAKE_COMMAND}" -E copy_directory "${PROJECT_SOURCE_DIR}/${folder}"
      "${pellucid_documentation_folder}/html/${folder}")
endforeach ()
add_custom_target(documentation
  ${pellucid_flatten_package}
  COMMAND Doxygen::doxygen "${pellucid_documentation_folder}/Doxyfile"
  ${pellucid_copy_folders}
  COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/.ci/check_documentation.py"
    "${pellucid_documentation_folder}"
  COMMENT "The API reference: ${pellucid_documentation_folder}/html/index.html"
  VERBATIM)
