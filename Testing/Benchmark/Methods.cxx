// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Methods.h"

#include "Candidates.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"
#include "vtkTransparencyInstaller.h"

namespace pellucid
{
namespace benchmark
{
namespace
{
//------------------------------------------------------------------------------
// The renderer draws with the pass that `make` returns.
template <typename MakePass>
std::function<void(vtkRenderer*)> WithPass(MakePass make)
{
  return [make](vtkRenderer* renderer)
  {
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(make());
    renderer->SetPass(camera);
  };
}

//------------------------------------------------------------------------------
// A renderer without passes has no way to it.
vtkSmartPointer<vtkRenderPass> MakeUnsortedPass()
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(vtkNew<vtkTranslucentPass>());
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(passes);
  return sequence;
}

//------------------------------------------------------------------------------
void UseWeightedBlending(vtkRenderer*)
{
  // VTK's default.
}

//------------------------------------------------------------------------------
void Install(vtkRenderer* renderer)
{
  vtkTransparencyInstaller::Install(renderer);
}

//------------------------------------------------------------------------------
void InstallOptimized(vtkRenderer* renderer)
{
  Install(renderer);
  vtkOpacityOptimization::Attach(
    renderer->GetActors()->GetLastActor(), vtkNew<vtkOpacityOptimization>());
}

//------------------------------------------------------------------------------
Method MakeDualPeeling(const std::string& suffix, const std::string& description, int peels)
{
  return { "vtk-dual-peeling-" + suffix, "vtk-dual-peeling", description, Geometry::Triangles,
    [peels](vtkRenderer* renderer)
    {
      renderer->UseDepthPeelingOn();
      renderer->SetMaximumNumberOfPeels(peels);
      renderer->SetOcclusionRatio(0.0);
    },
    peels };
}

//------------------------------------------------------------------------------
std::vector<Method> MakeMethods()
{
  std::vector<Method> methods = {
    { "vtk-unsorted", "vtk-unsorted", "VTK, blended in the order of drawing", Geometry::Triangles,
      WithPass(MakeUnsortedPass) },
    { "vtk-weighted-blended", "vtk-weighted-blended",
      "VTK's default, colours averaged with weights by depth", Geometry::Triangles,
      UseWeightedBlending },
  };
  for (const int peels : { 1, 2, 4, 8, 16, 32 })
  {
    const std::string number = std::to_string(peels);
    methods.push_back(MakeDualPeeling(number,
      "VTK, dual depth peeling, at most " + number + (peels == 1 ? " peel" : " peels") +
        ", the rest blended unsorted",
      peels));
  }
  methods.push_back(
    MakeDualPeeling("exact", "VTK, dual depth peeling until nothing is left", VTK_INT_MAX));
  methods.push_back({ ProductName, ProductName,
    "Pellucid as it is, lines as ray-cast rounded cones", Geometry::Trajectories, Install });
  methods.push_back({ "pellucid-tubes", ProductName, "Pellucid, with the triangles that VTK draws",
    Geometry::Triangles, Install });
  methods.push_back({ "pellucid-optimized", ProductName,
    "Pellucid, with opacities optimised for an importance that grows with the height",
    Geometry::Segments, InstallOptimized });
  for (const Candidate& candidate : GetCandidates())
  {
    methods.push_back(
      { candidate.Name, candidate.Family, candidate.Description, Geometry::Trajectories,
        WithPass(candidate.MakePass), candidate.Parameter, candidate.Reason });
  }
  return methods;
}
}

//------------------------------------------------------------------------------
std::string Method::GetShape(const Scene& scene) const
{
  return this->Form == Geometry::Triangles || scene.HasPolygons() ? "triangles" : "cones";
}

//------------------------------------------------------------------------------
bool Method::Suits(const Scene& scene) const
{
  const bool isVariant = this->Family == ProductName && this->Name != ProductName;
  const bool isOfLines = isVariant || this->Family == "depth-slices";
  return !isOfLines || !scene.HasPolygons();
}

//------------------------------------------------------------------------------
const std::vector<Method>& GetMethods()
{
  static const std::vector<Method> methods = MakeMethods();
  return methods;
}
}
}
