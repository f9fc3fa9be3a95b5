// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
  // The hit of view ray and rounded cone: gives VTK's shader vertexVC, normalVCVSOutput and the depth.
  ConeRay ray = viewRay();
  vec4 hit;
  if (ray.root < 0.0 || !hitCone(ray, -1.0, hit))
  {
    discard;
  }
  float facing = 1.0;
  bool shown = betweenJoints(hit.xyz, -1.0);
  //VTK::Exit::Impl
  if (!shown)
  {
    discard;
  }
  vec3 ballNormal = (hit.xyz - vec3(hit.w, 0.0, 0.0)) / (coneShape.y - coneShape.z * hit.w);
  vec3 normalVCVSOutput = facing * normalize(segmentToView(ballNormal));
  vec3 coatNormalVCVSOutput = normalVCVSOutput;
  vec4 vertexVC = vec4(centerVC + segmentToView(hit.xyz), 1.0);
  vec4 hitDC = VCDCMatrix * vertexVC;
  if (abs(hitDC.z) > hitDC.w)
  {
    discard;
  }
  gl_FragDepth = 0.5 * hitDC.z / hitDC.w + 0.5;
