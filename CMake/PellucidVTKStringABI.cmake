# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# The VTK wheel for Linux is built with libstdc++'s old string ABI and its CMake files do not say so:
# code that includes its headers with the new ABI ends in an undefined symbol with std::string. Ask
# the library itself, and state the answer where it belongs, as a usage requirement of
# VTK::CommonCore, which every other VTK module passes on.
include(CheckCXXSourceCompiles)

function (pellucid_check_vtk_string_abi result)
  set(CMAKE_REQUIRED_LIBRARIES VTK::CommonCore)
  set(CMAKE_REQUIRED_DEFINITIONS ${ARGN})
  set(CMAKE_REQUIRED_QUIET ON)
  check_cxx_source_compiles([[
    #include <vtkLogger.h>
    int main() { return static_cast<int>(vtkLogger::GetThreadName().size()); }
    ]] "${result}")
endfunction ()

pellucid_check_vtk_string_abi(PELLUCID_VTK_DEFAULT_STRING_ABI)
if (NOT PELLUCID_VTK_DEFAULT_STRING_ABI)
  pellucid_check_vtk_string_abi(PELLUCID_VTK_OLD_STRING_ABI -D_GLIBCXX_USE_CXX11_ABI=0)
  if (NOT PELLUCID_VTK_OLD_STRING_ABI)
    message(FATAL_ERROR
      "No program links with the VTK in ${VTK_DIR}, neither with the compiler's string ABI nor with "
      "the old one. Look for the reason in CMakeFiles/CMakeError.log or CMakeConfigureLog.yaml.")
  endif ()
  message(STATUS "Pellucid: this VTK has the old string ABI (_GLIBCXX_USE_CXX11_ABI=0)")
  target_compile_definitions(VTK::CommonCore INTERFACE _GLIBCXX_USE_CXX11_ABI=0)
endif ()
