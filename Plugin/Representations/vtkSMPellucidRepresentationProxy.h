// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPellucidRepresentationProxy
 * @brief   Proxy of vtkPellucidRepresentation whose statistics are those of the process that draws.
 *
 * Representations live in the client and on the servers, and ParaView reads information properties
 * from the client alone. With remote rendering only the server knows what a picture has cost: there
 * they are read from it, of several processes from the first.
 *
 * @par Reference
 * None: ParaView's own way to statistics.
 *
 * @sa vtkPellucidRepresentation
 */

#ifndef vtkSMPellucidRepresentationProxy_h
#define vtkSMPellucidRepresentationProxy_h

#include "vtkPellucidRepresentationsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDREPRESENTATIONS_EXPORT vtkSMPellucidRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMPellucidRepresentationProxy* New();
  vtkTypeMacro(vtkSMPellucidRepresentationProxy, vtkSMRepresentationProxy);

protected:
  vtkSMPellucidRepresentationProxy() = default;
  ~vtkSMPellucidRepresentationProxy() override = default;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMPellucidRepresentationProxy(const vtkSMPellucidRepresentationProxy&) = delete;
  void operator=(const vtkSMPellucidRepresentationProxy&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
