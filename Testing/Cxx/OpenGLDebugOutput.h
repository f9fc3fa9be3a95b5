// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OpenGLDebugOutput_h
#define OpenGLDebugOutput_h

#include "vtkObject.h"      // for vtkOpenGLError.h
#include "vtkOpenGLError.h" // for the OpenGL functions
#include "vtkOpenGLRenderWindow.h"

#include <cstring>
#include <iostream>

/**
 * Listens to the debug output of one window's OpenGL context for as long as it lives.
 *
 * Notifications and messages of low severity (shader statistics, buffer placement) are left out;
 * every other message is counted and printed as an error, which fails the test. Messages arrive
 * synchronously: a breakpoint in Receive shows the call that caused one.
 */
class OpenGLDebugOutput
{
public:
  /// Make the window's context, if it has none yet, and listen to it.
  explicit OpenGLDebugOutput(vtkRenderWindow* window)
    : Window(vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    this->Window->Initialize();
    this->Window->MakeCurrent();
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    for (GLenum severity : { GL_DEBUG_SEVERITY_NOTIFICATION, GL_DEBUG_SEVERITY_LOW })
    {
      glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, severity, 0, nullptr, GL_FALSE);
    }
    glDebugMessageCallback(
      [](GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* self)
      { static_cast<OpenGLDebugOutput*>(const_cast<void*>(self))->Receive(type, message); },
      this);
  }

  ~OpenGLDebugOutput()
  {
    this->Window->MakeCurrent();
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
  }

  OpenGLDebugOutput(const OpenGLDebugOutput&) = delete;
  OpenGLDebugOutput& operator=(const OpenGLDebugOutput&) = delete;

  /// Messages so far.
  int GetNumberOfMessages() const { return this->NumberOfMessages; }

  /// Count without printing: for the test that provokes a message.
  void SetQuiet(bool quiet) { this->Quiet = quiet; }

private:
  void Receive(GLenum type, const char* message)
  {
    // Advice about vtkOpenGLBufferObject, which puts changed arrays into buffers of that kind.
    if (std::strstr(message, "to update a GL_STATIC_DRAW buffer"))
    {
      return;
    }
    ++this->NumberOfMessages;
    if (!this->Quiet)
    {
      std::cerr << "ERROR: OpenGL debug output, type 0x" << std::hex << type << std::dec << ": "
                << message << std::endl;
    }
  }

  vtkOpenGLRenderWindow* Window;
  int NumberOfMessages = 0;
  bool Quiet = false;
};

#endif
