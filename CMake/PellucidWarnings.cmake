# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# pellucid_warnings(TARGET...): the warnings that our own code is free of.
function (pellucid_warnings)
  foreach (target IN LISTS ARGN)
    if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      target_compile_options("${target}" PRIVATE -Wall -Wextra -Wshadow -Wno-deprecated-copy)
      if (PELLUCID_WARNINGS_AS_ERRORS)
        target_compile_options("${target}" PRIVATE -Werror)
      endif ()
    endif ()
  endforeach ()
endfunction ()
