# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# What find_package(Pellucid) finds, in the build tree and in the install tree.
include(CMakePackageConfigHelpers)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${pellucid_cmake_destination}"
  FILE_NAME "PellucidModules-vtk-module-find-packages.cmake"
  MODULES ${pellucid_modules})

list(TRANSFORM pellucid_modules REPLACE "^Pellucid::" "" OUTPUT_VARIABLE PELLUCID_COMPONENTS)
set(PELLUCID_DEPENDENCY_PROPERTIES INTERFACE_vtk_module_depends)
if (NOT BUILD_SHARED_LIBS)
  list(APPEND PELLUCID_DEPENDENCY_PROPERTIES INTERFACE_vtk_module_private_depends)
endif ()
configure_package_config_file(CMake/PellucidConfig.cmake.in
  "${CMAKE_BINARY_DIR}/${pellucid_cmake_destination}/PellucidConfig.cmake"
  INSTALL_DESTINATION "${pellucid_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${pellucid_cmake_destination}/PellucidConfigVersion.cmake"
  VERSION "${PROJECT_VERSION}"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${pellucid_cmake_destination}/PellucidConfig.cmake"
  "${CMAKE_BINARY_DIR}/${pellucid_cmake_destination}/PellucidConfigVersion.cmake"
  DESTINATION "${pellucid_cmake_destination}"
  COMPONENT development)
install(FILES LICENSE
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Pellucid"
  COMPONENT licenses)
