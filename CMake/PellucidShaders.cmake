# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# pellucid_encode_shaders(SOURCES_VARIABLE HEADERS_VARIABLE SHADER...): turn glsl/NAME.glsl into a
# C string NAME declared in NAME.h, as VTK does with its own shaders.
function (pellucid_encode_shaders sources_variable headers_variable)
  foreach (shader IN LISTS ARGN)
    vtk_encode_string(
      INPUT "${shader}"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND sources "${source}")
    list(APPEND headers "${header}")
  endforeach ()
  set("${sources_variable}" ${sources} PARENT_SCOPE)
  set("${headers_variable}" ${headers} PARENT_SCOPE)
endfunction ()
