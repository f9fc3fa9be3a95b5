// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidateListsPass
 * @brief   Keeps all fragments and sorts each pixel's in one shader with the compositing.
 *
 * Unlike vtkExactTransparencyPass, which sorts in place before it composites, a fragment shader
 * reads the list of its pixel into local memory, or selects from it, and composites what it sorts.
 * The parameters are the ways to sort, store and stop that the papers weigh (M. Bandle,
 * Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D, 2016, section 2.4). Bubble
 * sort is left out: it makes the comparisons of insertion sort, never fewer, and moves more.
 *
 * Buffers grow until the frame is complete, as the product's; there is no division into rectangles.
 * What does not fit into one buffer of OpenGL's largest size is an error, and all pixels are lossy.
 * Fragments of equal depth are ordered as the product orders them.
 *
 * Lists up to GetLargestExactList() are exact. Longer ones are composited from a part of their
 * fragments and counted as lossy; selection is exact until it runs out of iterations, and counts
 * then. Mesa's software renderer ends a shader invocation without a word after some 65,000 loop
 * iterations, which is what these limits come from.
 */

#ifndef vtkCandidateListsPass_h
#define vtkCandidateListsPass_h

#include "vtkCandidatePass.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkCandidateListsPass : public vtkCandidatePass
{
public:
  static vtkCandidateListsPass* New();
  vtkTypeMacro(vtkCandidateListsPass, vtkCandidatePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How a list is sorted; default SORT_HEAP. */
  enum Sorts
  {
    SORT_INSERTION = 0, ///< in local memory
    SORT_SHELL = 1,     ///< with Ciura's gaps
    SORT_HEAP = 2,      ///< a quaternary heap as priority queue
    SORT_MERGE = 3,     ///< bottom up
    SORT_SELECTION = 4  ///< of the 16 nearest of what is left, again and again
  };
  vtkSetClampMacro(Sort, int, SORT_INSERTION, SORT_SELECTION);
  vtkGetMacro(Sort, int);

  /** Colour and opacity of a stored fragment; its depth adds 4 bytes. Default COLOR_64_BITS. */
  enum Colors
  {
    COLOR_32_BITS = 4,  ///< 8 bits each
    COLOR_64_BITS = 8,  ///< the product's: 13 bits each, opacity 25
    COLOR_128_BITS = 16 ///< floats
  };
  vtkSetMacro(ColorBytes, Colors);
  vtkGetMacro(ColorBytes, Colors);

  ///@{
  /**
   * Off (the default): linked lists, 4 bytes more for each fragment. On: the geometry is drawn
   * twice, to count the fragments of each pixel and to fill an array of that length.
   */
  vtkSetMacro(Contiguous, bool);
  vtkGetMacro(Contiguous, bool);
  ///@}

  /** The longest list that is exact whatever the order of its fragments. */
  int GetLargestExactList() const;

protected:
  vtkCandidateListsPass() = default;
  ~vtkCandidateListsPass() override = default;

  bool RenderTranslucent(const vtkRenderState* state) override;
  void Define(vtkShaderDefinitions& definitions) override;
  std::string GetDeclarations() override;
  std::string GetStoreCode() override;
  void SetStoreUniforms(vtkShaderProgram* program) override;

private:
  vtkCandidateListsPass(const vtkCandidateListsPass&) = delete;
  void operator=(const vtkCandidateListsPass&) = delete;

  enum Binding : GLuint
  {
    HeadsBinding = CountersBinding + 1,
    LinksBinding,
    ColorsBinding
  };

  bool Gather(const vtkRenderState* state);
  bool GatherArrays(const vtkRenderState* state);
  void ClearHeads();
  bool ReserveNodes(vtkIdType needed);
  void Resolve();

  int Sort = SORT_HEAP;
  Colors ColorBytes = COLOR_64_BITS;
  bool Contiguous = false;
  vtkIdType NodeCapacity = 0;
  bool Fills = false; ///< the second of the draws that fill arrays
};

VTK_ABI_NAMESPACE_END
#endif
