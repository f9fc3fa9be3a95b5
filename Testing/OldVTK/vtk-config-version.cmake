# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause

# With vtk-config.cmake, stands for a VTK release that lacks what Pellucid calls.
set(PACKAGE_VERSION "9.2.6")
set(PACKAGE_VERSION_COMPATIBLE TRUE)
