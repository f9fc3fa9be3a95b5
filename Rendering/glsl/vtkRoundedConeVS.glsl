//VTK::System::Dec
//VTK::Shape::Dec

// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// One quad for each node i of the trajectories: four vertices draw the segment from node i to node
// i + 1, or the ball of a node that has no neighbour. The quad is view-aligned and encloses the
// outline of the rounded cone, as in Gross and Gumhold 2021, section 5.1; unlike there it is made
// in the plane perpendicular to the middle ray, which has no special case for the order of the radii.
// No vertex attribute is read: gl_VertexID is 4 i + corner.
//
// With SPRITES, one point sprite for each node i instead, which gl_VertexID is: the square of whole
// pixels around those that the quad covers. vtkNodeGroups says when.
//
// Frames: VC view coordinates; LC the frame of a segment: origin in its middle, x along its axis,
// y in the plane of axis and view ray, z across.

uniform mat4 VCDCMatrix;
uniform mat4 pixelVCMatrix;  // window coordinates to VC
uniform float perspective;  // 1, or 0 for parallel projection
#if SPRITES
uniform vec2 viewportSize;  // in pixels
#endif
uniform vec4 frustumVC[6];  // inward planes, unit normals

flat out vec3 centerVC;      // the LC origin
flat out vec3 axisVC;        // the LC x axis
flat out vec3 sideVC;        // the LC y axis
flat out vec3 coneShape;     // half length, radius in the middle, decrease of the radius along x
flat out vec4 startPlaneLC;  // the segment lies where dot(plane, (p, 1)) <= 0
flat out vec4 endPlaneLC;    // ... and < 0

// The joints, and the unit directions of the segments before and after this one.
flat out vec3 startJointVC;
flat out vec3 endJointVC;
flat out vec3 beforeVC;
flat out vec3 afterVC;

//VTK::CustomUniforms::Dec

//VTK::NodeValue::Dec

//VTK::DrawOrder::Dec

//VTK::TrajectoryNodes::Dec

//VTK::Exit::Dec

//VTK::Picking::Dec

const float WHOLE_VIEW = 0.05;  // an eye nearer than this to the surface, in radii, gets a full quad

// How far a quad reaches beyond the outline, where it would end with that of the next segment: in
// radii, for rounding; in pixels, for the grid of 1/256 pixel that vertices are moved to.
const float MARGIN = 0.001;
const float MARGIN_PIXELS = 0.01;

const vec4 NO_PLANE = vec4(0.0, 0.0, 0.0, -1e30);
const vec4 NOTHING_PLANE = vec4(0.0, 0.0, 0.0, 1.0);

float cross2(vec2 a, vec2 b)
{
  return a.x * b.y - a.y * b.x;
}

vec4 jointPlane(vec3 normal, vec3 point)
{
  return dot(normal, normal) > 0.0 ? vec4(normal, -dot(normal, point)) : NO_PLANE;
}

// The vector may be 0, for a ball around the eye.
vec3 anyNormal(vec3 v)
{
  vec3 other = abs(v.x) < abs(v.y) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  vec3 normal = cross(v, other);
  return dot(normal, normal) > 0.0 ? normalize(normal) : other;
}

// What bounds the quad at one end of a segment: a ball, or where a joint cuts the ball off, a disc.
struct End
{
  float x;       // centre on the LC x axis
  float radius;
  bool disc;
};

// A joint plane that leaves the axis at an angle g keeps no point farther out than radius * sin(g).
// There a steep cone would be far wider than its balls.
End makeEnd(float x, float outward, float radius, vec4 plane, float middleRadius, float slope)
{
  float cosine = plane.x * outward;
  float reach = max(sqrt(max(1.0 - cosine * cosine, 0.0)), slope * outward);
  float cut = x + outward * radius * reach;
  float cutRadius = (middleRadius - slope * cut) / sqrt(1.0 - slope * slope);
  bool disc = cosine > 0.0 && cutRadius < 2.0 * radius;
  return disc ? End(cut, cutRadius, true) : End(x, radius, false);
}

// The interval (x, y) that an end covers in the plane at distance 1 along `middle`, z its half width
// across; in parallel projection the same for the plane through the LC origin. Negative z: none.
vec3 parallelExtent(End end, vec2 across)
{
  float reach = end.disc ? end.radius * abs(across.y) : end.radius;
  return vec3(end.x * across.x - reach, end.x * across.x + reach, end.radius);
}

// The two rays that touch an end in the plane of eye and axis, counter-clockwise one first.
vec4 touchingRays(End end, vec2 center)
{
  if (end.disc)
  {
    vec2 high = normalize(center + vec2(0.0, end.radius));
    vec2 low = normalize(center - vec2(0.0, end.radius));
    return center.x > 0.0 ? vec4(high, low) : vec4(low, high);
  }
  float distance = length(center);
  float sine = end.radius / distance;
  vec2 forward = center * sqrt(max(1.0 - sine * sine, 0.0)) / distance;
  vec2 aside = vec2(-center.y, center.x) * sine / distance;
  return vec4(forward + aside, forward - aside);
}

vec3 perspectiveExtent(End end, vec2 center, vec4 rays, vec2 middle, vec2 across)
{
  float depth = dot(center, middle);
  if (depth < (1.0 + WHOLE_VIEW) * end.radius)
  {
    return vec3(0.0, 0.0, -1.0);
  }
  return vec3(dot(rays.xy, across) / dot(rays.xy, middle), dot(rays.zw, across) / dot(rays.zw, middle),
    end.radius / sqrt(depth * depth - end.radius * end.radius));
}

// Half widths at the two sides (left, right) of a symmetric trapezoid over two boxes (left, right,
// half width).
vec2 trapezoid(vec3 a, vec3 b, vec2 sides)
{
  float widest = max(a.z, b.z);
  float run = b.z > a.z ? b.x - a.x : b.y - a.y;
  float foot = b.z > a.z ? a.x : a.y;
  if (abs(run) < 1e-6 * (sides.y - sides.x))
  {
    return vec2(widest);
  }
  vec2 widths = a.z + (sides - foot) * (b.z - a.z) / run;
  return run > 0.0 && widths.x + widths.y < 2.0 * widest ? widths : vec2(widest);
}

// Distance to the rounded cone from a point of the LC xy plane with y >= 0.
float coneDistance(vec2 p, float halfLength, float middleRadius, float slope)
{
  // the nearest ball: where the surface normal through p leaves the axis
  float ball = clamp(p.x - p.y * slope / sqrt(1.0 - slope * slope), -halfLength, halfLength);
  return length(p - vec2(ball, 0.0)) - (middleRadius - slope * ball);
}

// The quad, perpendicular to the plane of axis and eye.
struct Quad
{
  vec3 foot;    // where it is 0 across: on the middle ray, or in parallel projection the LC origin
  vec3 across;  // unit direction in the plane of axis and eye
  vec3 wide;    // unit direction perpendicular to it
  vec2 sides;   // the interval across
  vec2 widths;  // half widths at its ends
};

// In clip coordinates; corner (0, 0) to (1, 1). The hit points may lie on the other side of the near
// plane than the quad: clip at the eye only.
vec4 quadCorner(Quad quad, vec2 corner)
{
  float across = mix(quad.sides.x, quad.sides.y, corner.x);
  float aside = mix(quad.widths.x, quad.widths.y, corner.x) * (2.0 * corner.y - 1.0);
  vec4 position = VCDCMatrix * vec4(quad.foot + across * quad.across + aside * quad.wide, 1.0);
  return vec4(position.xy, 0.0, position.w);
}

#if SPRITES
// The pixels whose centres a quad in the view may cover
void drawSprite(Quad quad)
{
  vec2 low = viewportSize;
  vec2 high = vec2(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec4 position = quadCorner(quad, vec2(i & 1, i >> 1));
    vec2 pixel = (0.5 + 0.5 * position.xy / position.w) * viewportSize;
    low = min(low, pixel);
    high = max(high, pixel);
  }
  low = ceil(max(low, 0.0) - 0.5);
  high = floor(min(high, viewportSize) + 0.5);
  vec2 size = high - low;
  if (min(size.x, size.y) < 1.0)
  {
    startPlaneLC = NOTHING_PLANE;
    return;
  }
  // A square, shifted so that it touches as few blocks of 4 x 4 pixels as it can: software renderers
  // shade whole blocks.
  gl_PointSize = max(size.x, size.y);
  vec2 outside = mod(low + gl_PointSize, 4.0);
  low -= min(min(gl_PointSize - size, outside), mod(low, 4.0));
  // OpenGL drops points whose centre is outside the view.
  vec2 center = min(low + 0.5 * gl_PointSize, viewportSize);
  gl_Position = vec4(min(2.0 * center / viewportSize - 1.0, 1.0), 0.0, 1.0);
}
#endif

void main()
{
  // What is not drawn shrinks to a point, or a sprite of one pixel without a segment. Outside the view
  // it would be clipped, and Mesa's software driver clips all of a batch one by one if it has to clip any.
#if SPRITES
  int node = gl_VertexID;
  gl_Position = vec4(-1.0, -1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
#else
  int node = gl_VertexID >> 2;
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
#endif
  centerVC = vec3(0.0);
  axisVC = vec3(1.0, 0.0, 0.0);
  sideVC = vec3(0.0, 1.0, 0.0);
  coneShape = vec3(0.0);
  startPlaneLC = NOTHING_PLANE;
  endPlaneLC = NO_PLANE;
  startJointVC = vec3(0.0);
  endJointVC = vec3(0.0);
  beforeVC = vec3(0.0);
  afterVC = vec3(0.0);

  //VTK::DrawOrder::Impl

  vec4 node1 = fetchNode(node);
  vec4 node0 = fetchNode(max(node - 1, 0));
  bool joinedBefore = node > 0 && node0.w < 0.0;
  bool segment = node1.w < 0.0;
  if (joinedBefore && !segment)
  {
    return;
  }
  int last = segment ? node + 1 : node;
  vec4 node2 = fetchNode(last);
  bool joinedAfter = segment && node2.w < 0.0;
  int after = joinedAfter ? last + 1 : last;
  vec4 node3 = fetchNode(after);

  vec3 x1 = (nodeVCMatrix * vec4(node1.xyz, 1.0)).xyz;
  vec3 x2 = (nodeVCMatrix * vec4(node2.xyz, 1.0)).xyz;
  float r1 = abs(node1.w);
  float r2 = abs(node2.w);
  if (max(r1, r2) < 1e-37)
  {
    return;
  }
  for (int i = 0; i < 6; ++i)
  {
    float side1 = dot(frustumVC[i].xyz, x1) + frustumVC[i].w + r1;
    float side2 = dot(frustumVC[i].xyz, x2) + frustumVC[i].w + r2;
    if (max(side1, side2) < 0.0)
    {
      return;
    }
  }

  vec3 joint1 = x1;
  vec3 joint2 = x2;
  float len = length(x2 - x1);
  int firstBall = node;
  int lastBall = last;
  if (len <= abs(r1 - r2) * 1.0001)
  {
    // one ball contains the other
    firstBall = r1 > r2 ? node : last;
    lastBall = firstBall;
    x1 = r1 > r2 ? x1 : x2;
    x2 = x1;
    r1 = max(r1, r2);
    r2 = r1;
    len = 0.0;
  }

  //VTK::NodeValue::Impl

  //VTK::Exit::Impl

  //VTK::Picking::Impl

  centerVC = 0.5 * (x1 + x2);
  vec3 view = perspective > 0.5 ? centerVC : vec3(0.0, 0.0, -1.0);
  // as the neighbours compute it
  mat3 nodeVC = mat3(nodeVCMatrix);
  vec3 direction = normalize(nodeVC * (node2.xyz - node1.xyz));
  axisVC = len > 0.0 ? direction : anyNormal(view);
  vec3 wide = cross(axisVC, view);
  wide = dot(wide, wide) > 1e-10 * dot(view, view) ? normalize(wide) : anyNormal(axisVC);
  sideVC = cross(wide, axisVC);
  // xy of the way from the eye to the LC origin; parallel: view direction
  vec2 rayLC = vec2(dot(view, axisVC), dot(view, sideVC));
  float halfLength = 0.5 * len;
  float middleRadius = 0.5 * (r1 + r2);
  float slope = len > 0.0 ? (r1 - r2) / len : 0.0;
  coneShape = vec3(halfLength, middleRadius, slope);
  startPlaneLC = NO_PLANE;

  mat3 toLC = transpose(mat3(axisVC, sideVC, wide));
  if (joinedBefore)
  {
    startJointVC = joint1;
    beforeVC = normalize(nodeVC * (node1.xyz - node0.xyz));
    startPlaneLC = jointPlane(toLC * -bisector(beforeVC, direction), toLC * (joint1 - centerVC));
  }
  if (joinedAfter)
  {
    endJointVC = joint2;
    afterVC = normalize(nodeVC * (node3.xyz - node2.xyz));
    endPlaneLC = jointPlane(toLC * bisector(direction, afterVC), toLC * (joint2 - centerVC));
  }

  End end1 = End(-halfLength, r1, false);
  End end2 = End(halfLength, r2, false);
  if (len > 0.0)
  {
    end1 = makeEnd(-halfLength, -1.0, r1, startPlaneLC, middleRadius, slope);
    end2 = makeEnd(halfLength, 1.0, r2, endPlaneLC, middleRadius, slope);
  }

  // Everything below is in the LC xy plane, which holds the eye and the axis, seen from the eye.
  vec2 middle = rayLC;
  vec2 across;
  vec3 extent1;
  vec3 extent2;
  float planeDistance = 1.0;
  float foot = 0.0;
  bool whole = false;
  if (perspective > 0.5)
  {
    vec2 center1 = vec2(rayLC.x + end1.x, rayLC.y);
    vec2 center2 = vec2(rayLC.x + end2.x, rayLC.y);
    whole = coneDistance(vec2(-rayLC.x, abs(rayLC.y)), halfLength, middleRadius, slope) <
      WHOLE_VIEW * max(r1, r2);
    vec4 rays1 = touchingRays(end1, center1);
    vec4 rays2 = touchingRays(end2, center2);
    vec2 first = cross2(rays1.xy, rays2.xy) > 0.0 ? rays2.xy : rays1.xy;
    vec2 second = cross2(rays1.zw, rays2.zw) < 0.0 ? rays2.zw : rays1.zw;
    middle = first + second;
    // Beyond 180 degrees; the outermost rays of something tiny are the same but for rounding.
    whole = whole || dot(middle, middle) < 4.0 * WHOLE_VIEW * WHOLE_VIEW ||
      cross2(second, first) < -WHOLE_VIEW;
    middle = normalize(middle);
    across = vec2(middle.y, -middle.x);
    planeDistance = dot(rayLC, middle);
    foot = dot(rayLC, across);
    extent1 = perspectiveExtent(end1, center1, rays1, middle, across);
    extent2 = perspectiveExtent(end2, center2, rays2, middle, across);
    whole = whole || planeDistance <= 0.0 || min(extent1.z, extent2.z) < 0.0;
  }
  else
  {
    across = vec2(middle.y, -middle.x);
    extent1 = parallelExtent(end1, across);
    extent2 = parallelExtent(end2, across);
  }

#if !SPRITES
  if (whole)
  {
    // the quad is the view itself
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
    return;
  }
#endif
  vec2 sides = vec2(min(extent1.x, extent2.x), max(extent1.y, extent2.y));
  float eyeToPixels = perspective > 0.5 ? -pixelVCMatrix[3].z : 1.0;
  float margin = MARGIN * max(extent1.z, extent2.z) +
    MARGIN_PIXELS * max(length(pixelVCMatrix[0].xyz), length(pixelVCMatrix[1].xyz)) / eyeToPixels;
  vec2 widths = trapezoid(extent1, extent2, sides) + margin;
  sides += vec2(-margin, margin);
  vec3 acrossVC = across.x * axisVC + across.y * sideVC;
  Quad quad =
    Quad(centerVC - foot * acrossVC, acrossVC, wide, planeDistance * sides, planeDistance * widths);
#if SPRITES
  drawSprite(quad);
#else
  gl_Position = quadCorner(quad, corner);
#endif
}
