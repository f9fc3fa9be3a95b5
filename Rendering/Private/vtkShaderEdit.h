// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShaderEdit
 * @brief   A shader source that substitutes as vtkShaderProgram does, and is stored back when it
 * goes.
 */

#ifndef vtkShaderEdit_h
#define vtkShaderEdit_h

#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkShaderEdit
{
public:
  explicit vtkShaderEdit(vtkShader* shader)
    : Shader(shader)
    , Source(shader->GetSource())
  {
  }
  ~vtkShaderEdit() { this->Shader->SetSource(this->Source); }
  vtkShaderEdit(const vtkShaderEdit&) = delete;
  void operator=(const vtkShaderEdit&) = delete;

  void Replace(const std::string& tag, const std::string& code)
  {
    vtkShaderProgram::Substitute(this->Source, tag, code, false);
  }

  /** Put code where the tag is; after what was prepended earlier. */
  void Prepend(const std::string& tag, const std::string& code) { this->Replace(tag, code + tag); }

  /** Put code after what will replace the tag; before what was appended earlier. */
  void Append(const std::string& tag, const std::string& code)
  {
    this->Replace(tag, tag + "\n" + code);
  }

private:
  vtkShader* Shader;
  std::string Source;
};

VTK_ABI_NAMESPACE_END
#endif
