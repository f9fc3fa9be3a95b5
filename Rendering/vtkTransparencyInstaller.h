// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTransparencyInstaller
 * @brief   Makes a renderer draw exact transparency with one call.
 *
 * @code{.cpp}
 * vtkTransparencyInstaller::Install(renderer);
 * @endcode
 *
 * The installer observes the renderer. At the start of each frame it looks for the leaf of the
 * renderer's chain of passes, through passes that hold another one: image processing,
 * supersampling and camera passes, sequences of one pass, and those of AddHolder(). A leaf that is
 * VTK's or ParaView's default pass is replaced for this frame by a vtkExactTransparencyPass, and at
 * the end of the frame the chain is as it was. A renderer without passes gets a camera pass with
 * ours behind it, until it is uninstalled or the application sets a pass. Any other leaf, ray
 * tracing or a sequence of several passes for example, is left alone, with one warning. Nothing has
 * to be subclassed, and passes that the application sets later keep working.
 *
 * A hardware selection runs in VTK's own path. Graphics memory is freed when the renderer is
 * uninstalled, or deleted, or its window gives up its resources.
 *
 * @par Reference
 * None: an interface to VTK's render passes.
 *
 * @sa vtkExactTransparencyPass
 */

#ifndef vtkTransparencyInstaller_h
#define vtkTransparencyInstaller_h

#include "vtkNew.h" // for the pass
#include "vtkObject.h"
#include "vtkPellucidRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the chain of the frame
#include "vtkWeakPointer.h"             // for the renderer

#include <set>    // for the owners
#include <string> // for names of classes

VTK_ABI_NAMESPACE_BEGIN

class vtkCameraPass;
class vtkExactTransparencyPass;
class vtkInformationObjectBaseKey;
class vtkRenderer;
class vtkRenderPass;

class VTKPELLUCIDRENDERING_EXPORT vtkTransparencyInstaller : public vtkObject
{
public:
  /** An installer that observes nothing; use Install. */
  static vtkTransparencyInstaller* New();
  vtkTypeMacro(vtkTransparencyInstaller, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Make the renderer exact from its next frame on and return the pass that will draw it, for its
   * parameters and statistics. A second call returns the same pass. The renderer owns it. Returns
   * null, with a warning, when there is no renderer.
   *
   * Several parts of an application may each want the renderer exact: a part that names itself as
   * `owner` does not disturb the others. The owner is only compared, never used.
   */
  static vtkExactTransparencyPass* Install(vtkRenderer* renderer, vtkObject* owner = nullptr);

  /**
   * The owner no longer needs the renderer exact. Gives it back to VTK when nobody else does; does
   * nothing when the owner had not installed it.
   */
  static void Uninstall(vtkRenderer* renderer, vtkObject* owner = nullptr);

  /** The pass of a renderer; null when it was not installed. */
  static vtkExactTransparencyPass* GetPass(vtkRenderer* renderer);

  ///@{
  /**
   * Look through passes of one more class, and its subclasses, that hold another pass: all
   * installers do, from their next frame on. `get` and `set` are only called with passes of that
   * class.
   *
   * @code{.cpp}
   * vtkTransparencyInstaller::AddHolder(
   *   "vtkIceTCompositePass",
   *   [](vtkRenderPass* holder)
   *   { return vtkIceTCompositePass::SafeDownCast(holder)->GetRenderPass(); },
   *   [](vtkRenderPass* holder, vtkRenderPass* delegate)
   *   { vtkIceTCompositePass::SafeDownCast(holder)->SetRenderPass(delegate); });
   * @endcode
   *
   * What is added for a class again replaces what was known of it. For a pass of several classes
   * that are known, the last one added counts. Not for calls from several threads.
   */
  using GetDelegateFunction = vtkRenderPass* (*)(vtkRenderPass* holder);
  using SetDelegateFunction = void (*)(vtkRenderPass* holder, vtkRenderPass* delegate);
  static void AddHolder(
    const std::string& className, GetDelegateFunction get, SetDelegateFunction set);
  ///@}

  /** Where the installer lives: in vtkRenderer::GetInformation() of an installed renderer. */
  static vtkInformationObjectBaseKey* KEY();

protected:
  vtkTransparencyInstaller();
  ~vtkTransparencyInstaller() override;

private:
  vtkTransparencyInstaller(const vtkTransparencyInstaller&) = delete;
  void operator=(const vtkTransparencyInstaller&) = delete;

  static vtkTransparencyInstaller* Find(vtkRenderer* renderer);

  void Observe(vtkRenderer* renderer);
  void StopObserving();
  void EnterFrame();
  void LeaveFrame();
  void Replace(vtkRenderPass* expected, vtkRenderPass* leaf);

  std::set<vtkObject*> Owners;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long StartTag = 0;
  unsigned long EndTag = 0;
  vtkNew<vtkExactTransparencyPass> Pass;
  vtkNew<vtkCameraPass> CameraPass; // for a renderer without passes; Pass is its delegate

  // What is replaced in this frame, by what, and who holds it: null when the renderer itself does.
  vtkSmartPointer<vtkRenderPass> Holder;
  vtkRenderPass* Replacement = nullptr;
  vtkSmartPointer<vtkRenderPass> ReplacedLeaf;
  bool WarnedOfLeaf = false;
};

VTK_ABI_NAMESPACE_END
#endif
