// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Any array and the range of it that matters give the picture of an array of importances; what is
// missing in either is unimportant; another range draws anew, but runs no pipeline.
#include "SegmentedScene.h"

#include "vtkCallbackCommand.h"

#include "FrameStages.h"
#include <limits>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Range = std::array<double, 2>;

/** Beyond [0,1] too, and missing in places. */
double GetImportance(const double* point)
{
  return point[2] > 0.7 ? NotANumber : Wave(point);
}

/** Lines with balls at their ends, and surfaces of both mappers, each with its own parameters. */
class Scene : public SphereScene
{
public:
  explicit Scene(bool avoids = false)
    : SphereScene(90, 70, 0, 0, 0)
  {
    this->Actors = { AddLines(*this, MakeSegmentedLines(12, 100), 0.06, 0.9),
      AddSurface<vtkPolyDataMapper>(*this, MakeSegmentedSphere(0.7, Wave), 0.9),
      AddSurface<vtkTrajectoryMapper>(*this, MakeSegmentedSphere(1.3, Wave), 0.8) };
    for (vtkActor* actor : this->Actors)
    {
      if (avoids)
      {
        // Without what is in front, which rounding may decide.
        Avoid(actor, vtkOcclusionAvoidance::WEIGHTING, true)->SetDepthWeight(0.0);
      }
      else
      {
        Optimize(actor, 50.0, 10.0, 2.0, 3, false);
      }
      this->Settings.push_back(vtkImportanceDrivenOpacity::Get(actor));
      this->Data.push_back(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0)));
    }
    vtkTransparencyInstaller::Install(this->Renderer);
    this->AddArray("Values", [](double importance) { return importance; });
    this->AddArray("None", [](double) { return 0.0; });
    this->SetValues("Values", { 0.0, 1.0 });
  }

  /** An array of numbers that follow from importance. */
  void AddArray(const char* name, const std::function<double(double)>& getValue)
  {
    for (vtkPolyData* data : this->Data)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
      {
        array->InsertNextValue(getValue(GetImportance(data->GetPoint(point))));
      }
      data->GetPointData()->AddArray(array);
    }
  }

  void SetValues(const char* array, const Range& range)
  {
    for (vtkImportanceDrivenOpacity* settings : this->Settings)
    {
      settings->SetImportanceArray(array);
      settings->SetImportanceRange(range[0], range[1]);
    }
  }

  std::vector<vtkActor*> Actors;
  std::vector<vtkImportanceDrivenOpacity*> Settings;
  std::vector<vtkPolyData*> Data;
};

std::string ToText(const Range& range)
{
  return "from " + std::to_string(range[0]) + " to " + std::to_string(range[1]);
}

//------------------------------------------------------------------------------
bool TestValues()
{
  bool passed = true;
  for (const bool avoids : { false, true })
  {
    Scene plain(avoids);
    const Picture expected = Picture::Render(plain.Window);
    plain.SetValues("None", { 0.0, 1.0 });
    passed &= Check(expected.GetLargestDifference(Picture::Render(plain.Window)) > 50,
      "importance makes no difference");
    for (const Range& range :
      { Range{ 3.0, 10.0 }, { 10.0, 3.0 }, { 1e5, 1e5 + 7.0 }, { -1e-6, 1e-6 }, { 2.0, -1e20 } })
    {
      Scene scene(avoids);
      scene.AddArray(
        "Values", [&](double importance) { return range[0] + (range[1] - range[0]) * importance; });
      scene.SetValues("Values", range);
      const int difference = Picture::Render(scene.Window).GetLargestDifference(expected);
      passed &= Check(difference <= 1,
        "values " + ToText(range) + (avoids ? ", avoidance" : "") + ": off by " +
          std::to_string(difference));
      if (range[0] == 10.0)
      {
        passed &= Compare(scene, "values " + ToText(range));
      }
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestEqualEnds()
{
  Scene expected;
  expected.AddArray("Values", [](double importance) { return importance >= 0.5 ? 1.0 : 0.0; });
  Scene scene;
  // Also at the threshold itself, which all mappers have to see as the same.
  scene.AddArray(
    "Values", [](double importance) { return importance >= 0.5 ? 0.1 : importance / 6; });
  scene.SetValues("Values", { 0.1, 0.1 });
  return Check(Picture::Render(scene.Window) == Picture::Render(expected.Window),
    "equal ends are not a threshold");
}

//------------------------------------------------------------------------------
// Of one actor after the other, beside others that are important.
bool TestUnimportant()
{
  struct Case
  {
    std::string Name;
    const char* Array;
    Range Ends;
  };
  bool passed = true;
  for (std::size_t actor = 0; actor < 3; ++actor)
  {
    Scene expected;
    expected.Settings[actor]->SetImportanceArray("None");
    const Picture picture = Picture::Render(expected.Window);
    for (const Case& test : { Case{ "NaN to 1", "Values", { NotANumber, 1.0 } },
           { "0 to NaN", "Values", { 0.0, NotANumber } },
           { "infinite first", "Infinite", { -Infinity, 1.0 } },
           { "infinite second", "Infinite", { 0.0, Infinity } },
           { "both infinite", "Infinite", { Infinity, Infinity } },
           { "NaN in the data", "Missing", { 1.0, 0.0 } },
           { "equal ends and NaN in the data", "Missing", { 0.0, 0.0 } },
           { "below a wide range", "Values", { 5.0, VTK_DOUBLE_MAX } },
           { "no array", "Typo", { -1.0, 0.0 } }, { "vectors", "Normals", { -2.0, -1.0 } } })
    {
      Scene scene;
      scene.AddArray(
        "Infinite", [](double importance) { return importance > 0.5 ? Infinity : -Infinity; });
      scene.AddArray("Missing", [](double) { return NotANumber; });
      if (!scene.Data[actor]->GetPointData()->GetArray("Normals"))
      {
        vtkNew<vtkFloatArray> vectors;
        vectors->SetName("Normals");
        vectors->SetNumberOfComponents(3);
        vectors->SetNumberOfTuples(scene.Data[actor]->GetNumberOfPoints());
        vectors->Fill(0.0);
        scene.Data[actor]->GetPointData()->AddArray(vectors);
      }
      scene.Settings[actor]->SetImportanceArray(test.Array);
      scene.Settings[actor]->SetImportanceRange(test.Ends[0], test.Ends[1]);
      passed &= Check(Picture::Render(scene.Window) == picture,
        test.Name + " makes actor " + std::to_string(actor) + " important");
      passed &= Check(Picture::Render(scene.Window) == picture &&
          GetStages(vtkTransparencyInstaller::GetPass(scene.Renderer)) == UnchangedStages,
        test.Name + ": not the same in a frame more");
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
// Each range draws anew what a scene shows that has had no other; no filter runs for it.
bool TestDrag()
{
  int executions = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&executions);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  const auto connect = [&](Scene& scene)
  {
    for (std::size_t actor = 0; actor < 3; ++actor)
    {
      vtkSmartPointer<vtkAlgorithm> filter = vtkSmartPointer<vtkTrajectorySegments>::New();
      if (actor > 0)
      {
        filter = vtkSmartPointer<vtkSurfaceSegments>::New();
      }
      filter->SetInputDataObject(scene.Data[actor]);
      filter->AddObserver(vtkCommand::EndEvent, observer);
      scene.Actors[actor]->GetMapper()->SetInputConnection(filter->GetOutputPort());
    }
  };
  Scene scene;
  OpenGLDebugOutput debugOutput(scene.Window);
  connect(scene);
  Picture before = Picture::Render(scene.Window);
  bool passed = true;
  for (const Range& range : { Range{ 0.2, 0.8 }, { 0.2, 0.3 }, { 0.3, 0.2 }, { 0.0, 1.0 } })
  {
    scene.SetValues("Values", range);
    executions = 0;
    const Picture picture = Picture::Render(scene.Window);
    passed &= Check(executions == 0, "the pipeline runs for values " + ToText(range));
    passed &= Check(!(picture == before), "another range changes nothing: " + ToText(range));
    Scene fresh;
    connect(fresh);
    fresh.SetValues("Values", range);
    passed &= Check(
      Picture::Render(fresh.Window) == picture, "not the fresh picture: values " + ToText(range));
    passed &= Check(executions == 3, "executions are not counted");
    before = picture;
  }
  return passed;
}
}

//------------------------------------------------------------------------------
int TestImportanceRange(int, char*[])
{
  bool passed = TestValues();
  passed &= TestEqualEnds();
  passed &= TestUnimportant();
  passed &= TestDrag();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
