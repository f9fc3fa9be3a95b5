// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fuzzer's bytes are the file. Built once for each reader.

#include "FuzzReader.h"

#include PELLUCID_FUZZ_HEADER

#include "vtkNew.h"

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkNew<PELLUCID_FUZZ_READER> reader;
  FuzzReader(reader, data, size);
  return 0;
}
