# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# The ParaView plugin: the modules that are built already, and the representations on top.
paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS pellucid_plugins
  REQUIRES_MODULES pellucid_plugin_modules
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)

foreach (module IN LISTS pellucid_plugin_modules)
  if (NOT TARGET "${module}")
    message(FATAL_ERROR "The plugin needs ${module}, which the ParaView in ${ParaView_DIR} lacks.")
  endif ()
endforeach ()

# The documentation enters ParaView's Help by tools of Qt; without them it is only installed. The
# variable of xmlpatterns is ParaView's: /usr/bin may hold a link that leads nowhere.
find_package(Qt5 QUIET COMPONENTS Help)
find_program(qt_xmlpatterns_executable
  NAMES xmlpatterns-qt5 xmlpatterns
  HINTS "${Qt5_DIR}/../../../qt5/bin"
  DOC "Path to xmlpatterns")
set(pellucid_no_help ON)
if (PARAVIEW_USE_QT AND TARGET Qt5::qhelpgenerator AND qt_xmlpatterns_executable)
  execute_process(COMMAND "${qt_xmlpatterns_executable}" -help
    RESULT_VARIABLE pellucid_no_help OUTPUT_QUIET ERROR_QUIET)
endif ()
if (pellucid_no_help)
  message(STATUS "The documentation will not be in ParaView's Help: that needs Qt's qhelpgenerator "
    "and xmlpatterns.")
endif ()

paraview_plugin_build(
  PLUGINS ${pellucid_plugins}
  AUTOLOAD ${pellucid_plugins}
  PLUGINS_FILE_NAME "pellucid.xml"
  INSTALL_HEADERS OFF
  DISABLE_XML_DOCUMENTATION "${pellucid_no_help}"
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
