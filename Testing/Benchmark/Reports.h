// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Figures as files. README.md explains their keys and columns.
 */

#ifndef Reports_h
#define Reports_h

#include "Row.h"
#include "Scaling.h"

#include <iosfwd> // for the terminal
#include <string> // for file names
#include <vector> // for rows

namespace pellucid
{
namespace benchmark
{
/** Where it was measured. */
struct Machine
{
  std::string Date;     // of the start: ISO 8601, in UTC
  std::string Pellucid; // version
  std::string Renderer;
  std::string OpenGL;
  std::string VTK;
  std::string Processor;
  int Threads = 0;
};

struct Figures
{
  Machine Where;
  std::vector<Row> Rows;
  std::vector<Series> Scaling;
};

///@{
/** Write a file, or replace it as a whole; throw RenderError where that fails. */
void WriteJson(const Figures& figures, const std::string& fileName);
void WriteCsv(const Figures& figures, const std::string& fileName);
void WriteTables(const Figures& figures, const std::string& fileName);
///@}

/** What WriteTables() writes: Markdown. */
void PrintTables(const Figures& figures, std::ostream& stream);
}
}

#endif
