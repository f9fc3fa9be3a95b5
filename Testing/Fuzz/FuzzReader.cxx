// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fuzzer's bytes are the file and, behind it, choices of the reader's properties, of which
// readers of geographic trajectories alone have any. Built once for each reader. make_seeds.py
// knows the order of the choices.

#include "FuzzReader.h"

#include PELLUCID_FUZZ_HEADER

#include "vtkGeographicTrajectoryReader.h"
#include "vtkNew.h"

#include <fuzzer/FuzzedDataProvider.h>

namespace
{
//------------------------------------------------------------------------------
[[maybe_unused]] void SetProperties(vtkTrajectoryReader*, FuzzedDataProvider&) {}

//------------------------------------------------------------------------------
[[maybe_unused]] void SetProperties(
  vtkGeographicTrajectoryReader* reader, FuzzedDataProvider& choices)
{
  reader->SetEnsembleMember(choices.ConsumeIntegralInRange(0, 1));
  reader->SetVerticalAxis(choices.ConsumeIntegralInRange(0, 1));
  reader->SetVerticalScale(choices.PickValueInArray({ 0.0, 1e-3, 1e6 }));
  reader->SetLongitudeMode(choices.ConsumeIntegralInRange(0, 1));
  reader->SetCentralLongitude(choices.ConsumeIntegralInRange(-360, 360));
  reader->SetTimeSelection(choices.ConsumeIntegralInRange(0, 1));
}
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkNew<PELLUCID_FUZZ_READER> reader;
  FuzzedDataProvider choices(data, size);
  SetProperties(reader.GetPointer(), choices);
  const auto file = choices.ConsumeRemainingBytes<std::uint8_t>();
  FuzzReader(reader, file.data(), file.size());
  return 0;
}
