// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
  bool cutOpen = isCut(hit.xyz);
  shown = shown && !cutOpen;
  if (!shown && (cutOpen || startsInside(ray.direction)))
  {
    shown = hitCone(ray, 1.0, hit) && betweenJoints(hit.xyz) && !isCut(hit.xyz);
    facing = -1.0;
  }
