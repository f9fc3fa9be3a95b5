// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
  shown = shown && !isCut(hit.xyz);
  if (!shown)
  {
    shown = hitCone(ray, 1.0, hit) && betweenJoints(hit.xyz) && !isCut(hit.xyz) && startsInside(ray);
    facing = -1.0;
  }
