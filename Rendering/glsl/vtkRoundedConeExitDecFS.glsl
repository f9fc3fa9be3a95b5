// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The inner wall of tubes: only where the near plane or a clipping plane may cut one open. A ray
// that starts in a tube may leave it through the wall of a segment several joints away. So a segment
// follows the ray back through the tube, and shows its wall if it comes to the start of the ray.
//
// Points are in view coordinates from the middle of the segment drawn (centerVC), intervals (x, y)
// are distances along the ray.

uniform int clipPlaneCount;
uniform vec4 clipPlanesVC[7];  // the near plane and the clipping planes; positive where they keep
flat in int segmentNode;       // the node at which the segment drawn begins

// Bounds the time for a ray along the axis of a tube of very many segments.
const int FOLLOWED_SEGMENTS = 256;
const float FAR = 1e30;

float clipHeight(int plane, vec3 point)
{
  return dot(clipPlanesVC[plane], vec4(centerVC + point, 1.0));
}

bool isCut(vec3 pointLC)
{
  vec3 point = segmentToView(pointLC);
  bool cut = false;
  for (int i = 0; i < clipPlaneCount; ++i)
  {
    cut = cut || clipHeight(i, point) < 0.0;
  }
  return cut;
}

float rayStart(vec3 origin, vec3 direction)
{
  float start = -FAR;
  for (int i = 0; i < clipPlaneCount; ++i)
  {
    float slope = dot(clipPlanesVC[i].xyz, direction);
    start = slope > 0.0 ? max(start, -clipHeight(i, origin) / slope) : start;
  }
  return start;
}

vec2 unite(vec2 a, vec2 b)
{
  return vec2(min(a.x, b.x), max(a.y, b.y));
}

vec2 insideBall(vec3 origin, vec3 direction, vec4 ball)
{
  vec3 start = origin - ball.xyz;
  float middle = dot(start, direction);
  vec3 nearest = start - middle * direction;
  float h = ball.w * ball.w - dot(nearest, nearest);
  return h > 0.0 ? vec2(-sqrt(h), sqrt(h)) - middle : vec2(FAR, -FAR);
}

// The rounded cone is convex: the first and the last crossing of its two balls and its mantle count.
vec2 insideCone(vec3 origin, vec3 direction, vec4 ball1, vec4 ball2)
{
  vec2 inside =
    unite(insideBall(origin, direction, ball1), insideBall(origin, direction, ball2));
  vec3 axis = ball2.xyz - ball1.xyz;
  float len = length(axis);
  if (len <= abs(ball1.w - ball2.w) * 1.0001)
  {
    return inside;
  }
  axis /= len;
  float slope = (ball1.w - ball2.w) / len;
  float c2 = 1.0 - slope * slope;
  vec3 start = origin - ball1.xyz;
  float x = dot(start, axis);
  float climb = dot(direction, axis);
  vec3 across = start - x * axis;
  vec3 drift = direction - climb * axis;
  float f = ball1.w - slope * x;
  vec3 k = vec3(c2 * dot(across, across) - f * f, c2 * dot(across, drift) + slope * climb * f,
    c2 * dot(drift, drift) - slope * slope * climb * climb);
  float h = k.y * k.y - k.z * k.x;
  float q = -k.y - (k.y < 0.0 ? -1.0 : 1.0) * sqrt(max(h, 0.0));
  vec2 roots = vec2(abs(k.z) < 1e-20 ? FAR : q / k.z, abs(q) < 1e-20 ? FAR : k.x / q);
  for (int i = 0; i < 2; ++i)
  {
    float ball = (x + roots[i] * climb - slope * ball1.w) / c2;
    if (h >= 0.0 && ball >= 0.0 && ball <= len && abs(roots[i]) < FAR)
    {
      inside = unite(inside, vec2(roots[i]));
    }
  }
  return inside;
}

vec4 fetchBall(int node)
{
  vec4 values = fetchNode(node);
  return vec4((nodeVCMatrix * vec4(values.xyz, 1.0)).xyz - centerVC, abs(values.w));
}

// Where the ray comes through a joint into the segment that begins (side 1) or ends (side -1) there.
float enterJoint(vec3 origin, vec3 direction, int joint, float side)
{
  if (joint < 1 || fetchNode(joint - 1).w >= 0.0 || fetchNode(joint).w >= 0.0)
  {
    return -FAR;
  }
  vec3 point = fetchNode(joint).xyz;
  mat3 nodeVC = mat3(nodeVCMatrix);
  vec3 normal = bisector(
    nodeVC * (point - fetchNode(joint - 1).xyz), nodeVC * (fetchNode(joint + 1).xyz - point));
  float slope = dot(normal, direction);
  return slope * side > 0.0 ? dot(normal, fetchBall(joint).xyz - origin) / slope : -FAR;
}

bool startsInside(ConeRay ray)
{
  vec3 origin = segmentToView(ray.origin);
  vec3 direction = segmentToView(ray.direction);
  float start = rayStart(origin, direction);
  float reached = FAR;
  int node = segmentNode;
  for (int i = 0; i < FOLLOWED_SEGMENTS; ++i)
  {
    int last = fetchNode(node).w < 0.0 ? node + 1 : node;
    vec2 inside = insideCone(origin, direction, fetchBall(node), fetchBall(last));
    float fromBefore = enterJoint(origin, direction, node, 1.0);
    float fromAfter = enterJoint(origin, direction, last, -1.0);
    float joint = max(fromBefore, fromAfter);
    float entry = max(inside.x, joint);
    // A ray that does not reach the next segment passes between tubes of different radius.
    if (entry >= reached || (i > 0 && inside.y < reached))
    {
      return false;
    }
    if (entry <= start)
    {
      return true;
    }
    if (inside.x >= joint)
    {
      return false;
    }
    node += fromBefore > fromAfter ? -1 : 1;
    reached = entry;
  }
  return false;
}
