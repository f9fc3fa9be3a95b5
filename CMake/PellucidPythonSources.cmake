# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# pellucid_install_python_sources(DESTINATION [FILE...]): the Python sources of the package `pellucid`,
# and more files of Rendering/Python, in the build tree and in the install tree. DESTINATION is the
# folder of Python's modules there.
function (pellucid_install_python_sources destination)
  set(sources "${PROJECT_SOURCE_DIR}/Rendering/Python")
  set(package "${CMAKE_BINARY_DIR}/${destination}/pellucid")
  configure_file("${sources}/__init__.py.in" "${package}/__init__.py" @ONLY)
  set(files "${package}/__init__.py")
  foreach (file IN ITEMS
      _adding.py
      _appearance.py
      _arguments.py
      _geometry.py
      _opacities.py
      _plotters.py
      _properties.py
      _renderers.py
      ${ARGN})
    configure_file("${sources}/${file}" "${package}/${file}" COPYONLY)
    list(APPEND files "${package}/${file}")
  endforeach ()
  install(FILES ${files}
    DESTINATION "${destination}/pellucid"
    COMPONENT python)
endfunction ()
