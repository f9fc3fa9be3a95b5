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

paraview_plugin_build(
  PLUGINS ${pellucid_plugins}
  AUTOLOAD ${pellucid_plugins}
  PLUGINS_FILE_NAME "pellucid.xml"
  INSTALL_HEADERS OFF
  # Help pages would need Qt's tools; the texts in the panels do not.
  DISABLE_XML_DOCUMENTATION ON
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
