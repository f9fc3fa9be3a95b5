// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   How far a picture of 8 bits is from the one it should be.
 */

#ifndef PictureError_h
#define PictureError_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector> // for edges

namespace pellucid
{
namespace benchmark
{
/**
 * A picture as it should be, RGB or RGBA of double in [0,1], with the number of translucent
 * fragments of each pixel (vtkReferenceRenderer::GetFragmentCounts()).
 *
 * Where the edge of a surface runs through the centre of a pixel, to within what a rasteriser
 * resolves, both sides of it are right. Such edge pixels are those of which the number changes when
 * the picture is displaced by that small part of a pixel. So are those of which the colour changes
 * by more than one step of 8 bits: there one edge takes the place of another, two surfaces
 * intersect, or one is seen so much from its side that its shading is not resolved. And so are
 * those where single precision does not resolve which of two fragments is in front.
 */
class ExpectedPicture
{
public:
  /** Throws std::invalid_argument where the dimensions differ; so do the others. */
  ExpectedPicture(vtkSmartPointer<vtkImageData> picture, vtkSmartPointer<vtkImageData> counts);

  /** Take into account the same picture, displaced. */
  void AddDisplaced(vtkImageData* picture, vtkImageData* counts);

  /** Take into account how much other orders of the fragments, also of a displaced picture, show
   * (vtkReferenceRenderer::GetOrderChanges()). */
  void AddOrderChanges(vtkImageData* changes);

  vtkImageData* GetPicture() const { return this->Picture; }
  bool IsCovered(vtkIdType pixel) const;
  bool IsEdge(vtkIdType pixel) const { return this->Edges[pixel] || this->Unordered[pixel]; }

  /** Whether it is an edge pixel only since an order of fragments is not resolved. */
  bool IsEdgeByOrder(vtkIdType pixel) const
  {
    return this->Unordered[pixel] && !this->Edges[pixel];
  }

private:
  vtkSmartPointer<vtkImageData> Picture;
  vtkSmartPointer<vtkImageData> Counts;
  std::vector<bool> Edges;
  std::vector<bool> Unordered;
};

/** Differences of some pixels, in steps of 8 bits; NaN without pixels. */
struct Differences
{
  /** Root of the mean square over all components; rounding gives 0.29. */
  double RootMeanSquare = 0.0;

  /** Largest difference of a component to what the expected picture is when rounded. */
  double Maximum = 0.0;
};

/** The differences by which a method is measured, of the pixels that are no edges; and others. */
struct PictureError : Differences
{
  /** Of those with translucent fragments that are no edges. */
  Differences Covered;

  /** Of all pixels. */
  Differences All;

  /** 20 log10(255 / RootMeanSquare) in dB; infinite for equal pictures. */
  double PeakSignalToNoise = 0.0;

  /**
   * Structural similarity of the luminances, at most 1: the mean over all windows of 11 x 11
   * pixels, weighted by a Gaussian with standard deviation 1.5 (Z. Wang, A. C. Bovik, H. R. Sheikh
   * and E. P. Simoncelli, Image Quality Assessment: From Error Visibility to Structural Similarity,
   * 2004, eqs. 13 to 17, K1 = 0.01, K2 = 0.03). Only windows inside the picture count; NaN where it
   * is smaller. Edge pixels are compared with the expected picture as it is.
   */
  double StructuralSimilarity = 0.0;

  vtkIdType CoveredPixels = 0;
  vtkIdType EdgePixels = 0;

  /** Of these, those that are edges by the order of fragments alone. */
  vtkIdType OrderPixels = 0;
};

/**
 * Compare `shown`, 3 or more components of unsigned char, with a picture of the same dimensions.
 * Only the first 3 components count. Throws std::invalid_argument where the dimensions differ.
 */
PictureError FindPictureError(vtkImageData* shown, const ExpectedPicture& expected);
}
}

#endif
