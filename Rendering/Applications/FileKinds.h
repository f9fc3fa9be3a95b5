// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Which of VTK's readers reads a file: by its content, by its suffix second.
 */

#ifndef FileKinds_h
#define FileKinds_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string> // for names

namespace pellucid
{
/**
 * A reader with its file name set; null if neither the content nor the suffix says of which kind
 * the file is. Throw RenderError for damage that the reader would not notice.
 */
vtkSmartPointer<vtkAlgorithm> MakeFileReader(const std::string& fileName);

/** All kinds of files that are read, lines of text for a person. */
std::string ListFileKinds();

/**
 * Why a file that no reader takes is not read: that its name promises another content, that it is
 * NetCDF without trajectories, or that it is of no known kind, and then all the kinds.
 */
std::string ExplainUnknownFile(const std::string& fileName);
}

#endif
