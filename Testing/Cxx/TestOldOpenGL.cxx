// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Where OpenGL is older than 4.3 an installed renderer keeps VTK's own path, with one warning that
// says what was found and what is needed.
#include "Picture.h"
#include "SphereScene.h"

#include "vtkExactTransparencyPass.h"
#include "vtkTestErrorObserver.h"
#include "vtkTransparencyInstaller.h"

#include <cstdlib>

int TestOldOpenGL(int, char*[])
{
  // Mesa reads this when the first context of the process is made.
  setenv("MESA_GL_VERSION_OVERRIDE", "4.2", 1);
  SphereScene scene(200, 150, 0, 8, 1);
  const Picture stock = Picture::Render(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::WarningEvent, observer);
  bool passed = Check(Picture::Render(scene.Window) == stock, "not VTK's own picture");
  passed &= Check(observer->GetWarning() &&
      observer->GetWarningMessage().find("needs OpenGL 4.3, found \"4.2") != std::string::npos,
    "no warning of what was found and what is needed: " + observer->GetWarningMessage());
  observer->Clear();
  Picture::Render(scene.Window);
  passed &= Check(!observer->GetWarning(), "the warning is repeated");
  passed &= Check(pass->GetStatistics()->GetBufferBytes() == 0, "memory was taken");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
