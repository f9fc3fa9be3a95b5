// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The inner wall of tubes: only where the near plane or a clipping plane may cut one open.

uniform int clipPlaneCount;
uniform vec4 clipPlanesVC[6];
uniform float nearVC;            // distance of the near plane
uniform int enteredCount;
uniform vec4 enteredBalls[64];   // ends in VC and radii of the segments that hold a part of the near plane
flat in int enteredMask;         // which of them belong to this segment's stretch of line

bool isCut(vec3 pointLC)
{
  vec4 point = vec4(centerVC + segmentToView(pointLC), 1.0);
  bool cut = -point.z < nearVC;
  for (int i = 0; i < clipPlaneCount; ++i)
  {
    cut = cut || dot(clipPlanesVC[i], point) < 0.0;
  }
  return cut;
}

bool isInBallHull(vec3 point, vec4 ball1, vec4 ball2)
{
  vec3 axis = ball2.xyz - ball1.xyz;
  float len = length(axis);
  float slope = (ball1.w - ball2.w) / max(len, 1e-30);
  if (abs(slope) >= 0.9999)
  {
    vec4 larger = ball1.w > ball2.w ? ball1 : ball2;
    return length(point - larger.xyz) <= larger.w;
  }
  vec3 way = point - ball1.xyz;
  float x = dot(way, axis) / len;
  float y = length(way - x * axis / len);
  float ball = clamp(x - y * slope / sqrt(1.0 - slope * slope), 0.0, len);
  return length(vec2(x - ball, y)) <= ball1.w - slope * ball;
}

// Does the ray start, at the near plane, within the tube that this segment continues?
bool startsInside(vec3 directionLC)
{
  vec3 direction = segmentToView(directionLC);
  vec3 start = perspective > 0.5
    ? direction * (nearVC / max(-direction.z, 1e-30))
    : vec3(0.0, 0.0, -nearVC) + vec3((centerVC + segmentToView(quadLC)).xy, 0.0);
  bool inside = false;
  for (int i = 0; i < enteredCount; ++i)
  {
    inside = inside ||
      ((enteredMask >> i & 1) != 0 &&
        isInBallHull(start, enteredBalls[2 * i], enteredBalls[2 * i + 1]));
  }
  return inside;
}
