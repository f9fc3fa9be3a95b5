// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A parallel loop of a filter that reports progress and obeys an abort. Private to the module.
 */

#ifndef vtkParallelBatches_h
#define vtkParallelBatches_h

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm> // for batch sizes

VTK_ABI_NAMESPACE_BEGIN

/** What part of a filter's progress, which goes from 0 to 1, a loop is. */
struct vtkProgressPart
{
  double Begin = 0.0;
  double End = 1.0;
};

/**
 * Call function(first, last) for parts of 0, ..., count - 1 from all threads. Between batches, of a
 * hundredth of `count` but at least `smallestBatch`, the calling thread alone reports the progress
 * and looks whether `filter` has to abort: then nothing more is called and the result is false.
 */
template <typename Function>
bool vtkForInBatches(vtkAlgorithm* filter, vtkProgressPart part, vtkIdType count,
  vtkIdType smallestBatch, const Function& function)
{
  const vtkIdType batch = std::max(smallestBatch, (count + 99) / 100);
  for (vtkIdType first = 0; first < count; first += batch)
  {
    const vtkIdType last = std::min(first + batch, count);
    vtkSMPTools::For(first, last, function);
    filter->UpdateProgress(part.Begin +
      (part.End - part.Begin) * static_cast<double>(last) / static_cast<double>(count));
    if (filter->CheckAbort())
    {
      return false;
    }
  }
  return true;
}

VTK_ABI_NAMESPACE_END
#endif
