// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   How far a picture of 8 bits is from the one it should be.
 */

#ifndef PictureError_h
#define PictureError_h

class vtkImageData;

namespace pellucid
{
namespace benchmark
{
/** Differences of colours, in steps of 8 bits where there is no other unit. */
struct PictureError
{
  /** Root of the mean square over all pixels and components; rounding alone gives 0.29. */
  double RootMeanSquare = 0.0;

  /** Largest difference of a component to what the expected picture is when rounded. */
  double Maximum = 0.0;

  /** 20 log10(255 / RootMeanSquare) in dB; infinite for equal pictures. */
  double PeakSignalToNoise = 0.0;

  /**
   * Structural similarity of the luminances, at most 1: the mean over all windows of 11 x 11
   * pixels, weighted by a Gaussian with standard deviation 1.5 (Z. Wang, A. C. Bovik, H. R. Sheikh
   * and E. P. Simoncelli, Image Quality Assessment: From Error Visibility to Structural Similarity,
   * 2004, eqs. 13 to 17, K1 = 0.01, K2 = 0.03). Only windows inside the picture count; NaN where it
   * is smaller.
   */
  double StructuralSimilarity = 0.0;
};

/**
 * Compare `shown`, 3 or more components of unsigned char, with `expected`, 3 or more of double in
 * [0,1], of the same dimensions. Only the first 3 components count.
 */
PictureError FindPictureError(vtkImageData* shown, vtkImageData* expected);
}
}

#endif
