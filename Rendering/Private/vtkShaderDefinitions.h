// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lines "#define PELLUCID_NAME value" for shaders, with numbers as GLSL has them in every locale.
 */

#ifndef vtkShaderDefinitions_h
#define vtkShaderDefinitions_h

#include "vtkABINamespace.h" // for the namespace macros

#include <cstdint>
#include <locale>
#include <sstream>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkShaderDefinitions
{
public:
  vtkShaderDefinitions() { this->Lines.imbue(std::locale::classic()); }

  template <typename Value>
  void Define(const char* name, Value value)
  {
    this->Lines << "#define PELLUCID_" << name << " " << value << "\n";
  }

  void Define(const char* name, std::uint32_t value)
  {
    this->Lines << "#define PELLUCID_" << name << " " << value << "u\n";
  }

  std::string GetText() const { return this->Lines.str(); }

private:
  std::ostringstream Lines;
};

VTK_ABI_NAMESPACE_END
#endif
