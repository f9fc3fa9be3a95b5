// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Which two files make up a PLOT3D data set.
 */

#ifndef Plot3DFiles_h
#define Plot3DFiles_h

#include <string> // for names
#include <vector> // for the list of inputs

namespace pellucid
{
struct Plot3DFiles
{
  std::string Grid;     // coordinates
  std::string Solution; // density, momentum, energy
};

/** Whether the suffix is one of PLOT3D's. */
bool IsPlot3DFileName(const std::string& fileName);

/** ".bin, .xyz, ..." */
std::string ListPlot3DSuffixes();

/**
 * Take the first file and its partner out of the list. The partner is the one in the list or in the
 * first one's folder that is named alike (combxyz.bin and combq.bin, a.xyz and a.q), or else the
 * second file of the list, the first one being the grid. Throw RenderError when there is none.
 */
Plot3DFiles TakePlot3DFiles(std::vector<std::string>& fileNames);
}

#endif
