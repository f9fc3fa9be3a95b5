# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# VTK, alone or through ParaView.
set(pellucid_vtk_components
  CommonColor
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonSystem
  CommonTransforms
  FiltersCore
  FiltersFlowPaths
  FiltersGeneral
  FiltersGeometry
  FiltersModeling
  FiltersSources
  IOGeometry
  IOImage
  IOLegacy
  IOParallel
  IOPLY
  IOXML
  InteractionStyle
  RenderingAnnotation
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2
  RenderingVolumeOpenGL2
  eigen
  netcdf
  vtksys)

set(pellucid_vtk_optional_components RenderingUI WrappingPythonCore Python)
if (BUILD_TESTING)
  list(APPEND pellucid_vtk_components
    ChartsCore
    FiltersHybrid
    ImagingCore
    ImagingGeneral
    RenderingContextOpenGL2)
  list(APPEND pellucid_vtk_optional_components TestingRendering)
endif ()

if (PELLUCID_BUILD_PLUGIN)
  # VTK comes with ParaView; a VTK_DIR left from an earlier configuration would silently win.
  unset(VTK_DIR CACHE)
  find_package(ParaView 5.11 REQUIRED
    COMPONENTS RemotingCore RemotingServerManager RemotingViews
    OPTIONAL_COMPONENTS pvpython pvbatch)
endif ()
find_package(VTK 9.2 REQUIRED
  COMPONENTS ${pellucid_vtk_components}
  OPTIONAL_COMPONENTS ${pellucid_vtk_optional_components})
# The releases 9.2.0 to 9.2.6 are older than that date of VTK's development.
if (VTK_VERSION VERSION_LESS "9.2.20230111")
  message(FATAL_ERROR
    "Pellucid needs the VTK of ParaView 5.11 (9.2.20230111) or VTK 9.3 or newer. The VTK ${VTK_VERSION} "
    "in ${VTK_DIR} lacks vtkAlgorithm::CheckAbort; choose another with VTK_DIR.")
endif ()
include(PellucidVTKStringABI)
message(STATUS "Pellucid: VTK ${VTK_VERSION}, Python wrapping ${VTK_WRAP_PYTHON}")

# What is installed finds a VTK outside the system's folders, such as the wheel's. A wheel of our own
# knows where that is by itself.
get_target_property(pellucid_vtk_folder VTK::CommonCore LOCATION)
get_filename_component(pellucid_vtk_folder "${pellucid_vtk_folder}" DIRECTORY)
if (NOT SKBUILD AND NOT pellucid_vtk_folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
  list(APPEND CMAKE_INSTALL_RPATH "${pellucid_vtk_folder}")
endif ()
