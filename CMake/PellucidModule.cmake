# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# What the modules' own CMakeLists.txt use. Each of them includes this file, because inside a VTK tree
# nobody else does.
include_guard(GLOBAL)
include("${CMAKE_CURRENT_LIST_DIR}/PellucidShaders.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/PellucidWarnings.cmake")
