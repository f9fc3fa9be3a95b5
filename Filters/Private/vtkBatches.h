// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBatches
 * @brief   Loops of a filter, serial or parallel, that report progress and obey an abort.
 *
 * A loop goes over consecutive batches, about a hundredth of it each. Between them the filter
 * reports its progress from the thread that called.
 *
 * Private to the module.
 */

#ifndef vtkBatches_h
#define vtkBatches_h

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <algorithm> // for std::min

VTK_ABI_NAMESPACE_BEGIN

class vtkBatches
{
public:
  /** Loops that move the progress of the filter from `begin` to `end`. */
  explicit vtkBatches(vtkAlgorithm* filter, double begin = 0.0, double end = 1.0)
    : Filter(filter)
    , Begin(begin)
    , End(end)
  {
  }

  /** The part of the progress from one fraction, in [0, 1], to the other. */
  vtkBatches GetPart(double begin, double end) const
  {
    const double length = this->End - this->Begin;
    return vtkBatches(this->Filter, this->Begin + begin * length, this->Begin + end * length);
  }

  /**
   * Call `work(begin, end)` for each batch of [0, count). Returns false, with work left undone,
   * when the filter is to abort.
   */
  template <typename Function>
  bool For(vtkIdType count, Function&& work, vtkIdType minimumSize = DefaultMinimumSize) const
  {
    const vtkIdType size = std::max(minimumSize, count / 100 + 1);
    for (vtkIdType begin = 0; begin < count && !this->Filter->CheckAbort(); begin += size)
    {
      const vtkIdType end = std::min(begin + size, count);
      work(begin, end);
      const double done = static_cast<double>(end) / static_cast<double>(count);
      this->Filter->UpdateProgress(this->Begin + (this->End - this->Begin) * done);
    }
    return !this->Filter->CheckAbort();
  }

  /** The same; any thread calls `work` for any part of a batch. */
  template <typename Function>
  bool ParallelFor(
    vtkIdType count, Function&& work, vtkIdType minimumSize = DefaultMinimumSize) const
  {
    return this->For(
      count, [&work](vtkIdType begin, vtkIdType end) { vtkSMPTools::For(begin, end, work); },
      minimumSize);
  }

private:
  static constexpr vtkIdType DefaultMinimumSize = 1 << 14;

  vtkAlgorithm* Filter;
  double Begin;
  double End;
};

VTK_ABI_NAMESPACE_END
#endif
