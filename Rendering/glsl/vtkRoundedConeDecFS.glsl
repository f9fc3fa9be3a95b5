// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Declarations for the fragment shader of rounded cones: the flat description of one segment that
// vtkRoundedConeVS.glsl writes (see there), and the intersection with the view ray.

uniform mat4 VCDCMatrix;
uniform mat4 pixelVCMatrix;  // window coordinates to VC
uniform float perspective;
flat in vec3 centerVC;
flat in vec3 axisVC;
flat in vec3 sideVC;
flat in vec3 coneShape;
flat in vec4 startPlaneLC;
flat in vec4 endPlaneLC;
flat in vec3 startJointVC;
flat in vec3 beforeVC;
flat in vec3 endJointVC;
flat in vec3 afterVC;

const float JOINT_BAND = 0.004;  // in radii; far more than what segments differ by

//VTK::NodeValue::Dec

// A view ray in LC, started where it passes the axis, and the quadratic
// k.z t^2 + 2 k.y t + k.x that is negative inside the double cone around the segment.
struct ConeRay
{
  vec3 origin;
  vec3 direction;
  vec3 k;
  float root;  // square root of the discriminant; negative: the ray misses
};

vec3 viewToSegment(vec3 v)
{
  return vec3(dot(v, axisVC), dot(v, sideVC), dot(v, cross(axisVC, sideVC)));
}

// The direction of the pixel's view ray in VC, with z = -1.
vec3 pixelDirection()
{
  vec4 pixel = pixelVCMatrix * vec4(gl_FragCoord.xy, 0.0, 1.0);
  return vec3(perspective > 0.5 ? pixel.xy / -pixel.z : vec2(0.0), -1.0);
}

// Where the ray passes the plane z = point.z, as seen from there, in VC.
vec3 pixelOrigin(vec3 direction, vec3 point)
{
  vec4 pixel = pixelVCMatrix * vec4(gl_FragCoord.xy, 0.0, 1.0);
  return vec3((perspective > 0.5 ? direction.xy * -point.z : pixel.xy) - point.xy, 0.0);
}

// From the centre of the pixel: what a quad has there depends on where OpenGL rounds its corners to.
ConeRay viewRay()
{
  float slope = coneShape.z;
  ConeRay ray;
  vec3 directionVC = pixelDirection();
  vec3 point = viewToSegment(pixelOrigin(directionVC, centerVC));
  ray.direction = normalize(viewToSegment(directionVC));
  vec2 aside = ray.direction.yz;
  float a = dot(aside, aside);
  ray.origin = point - dot(point.yz, aside) / max(a, 1e-6) * ray.direction;
  float c2 = 1.0 - slope * slope;
  float f = coneShape.y - slope * ray.origin.x;
  ray.k = vec3(c2 * dot(ray.origin.yz, ray.origin.yz) - f * f,
    c2 * dot(ray.origin.yz, aside) + slope * ray.direction.x * f,
    c2 * a - slope * slope * ray.direction.x * ray.direction.x);
  float h = ray.k.y * ray.k.y - ray.k.z * ray.k.x;
  ray.root = h < 0.0 && ray.k.z > 0.0 ? -1.0 : sqrt(max(h, 0.0));
  return ray;
}

// The hit: xyz in LC, and in w the position on the axis of the ball that the point lies on.
// `side` is -1 for the entry, +1 for the exit. False: the ray misses.
bool hitCone(ConeRay ray, float side, out vec4 hit)
{
  float slope = coneShape.z;
  // of the two forms of the root the one without cancellation
  float k1 = side * ray.k.y;
  float k2 = abs(ray.k.z) < 1e-20 ? 1e-20 : ray.k.z;
  float t = side * (k1 < 0.0 ? (ray.root - k1) / k2 : -ray.k.x / max(ray.root + k1, 1e-30));
  vec3 point = ray.origin + t * ray.direction;
  float ball = (point.x - slope * coneShape.y) / (1.0 - slope * slope);
  if (!(abs(ball) < coneShape.x))
  {
    // On the mirrored nappe: a ray inside the double cone comes from, or goes to, the wide end.
    bool mirrored = coneShape.y - slope * ball <= 0.0;
    if (mirrored && ray.k.z > 0.0)
    {
      return false;
    }
    ball = (mirrored ? slope < 0.0 : ball > 0.0) ? coneShape.x : -coneShape.x;
    vec3 start = ray.origin - vec3(ball, 0.0, 0.0);
    float middle = dot(start, ray.direction);
    vec3 nearest = start - middle * ray.direction;
    float radius = coneShape.y - slope * ball;
    float h = radius * radius - dot(nearest, nearest);
    if (h < 0.0)
    {
      return false;
    }
    point = nearest + side * sqrt(h) * ray.direction + vec3(ball, 0.0, 0.0);
  }
  hit = vec4(point, ball);
  return true;
}

vec3 segmentToView(vec3 v)
{
  return v.x * axisVC + v.y * sideVC + v.z * cross(axisVC, sideVC);
}

// Two segments compute the point where the ray hits them at their joint with different rounding: by
// the points, both or none of them may own it. So near a joint plane the side (by the sign; negative:
// that of the segment before) follows from values that both compute in the same way, from joint,
// directions and pixel. A ray that crosses the plane inside the tube enters the tube before and
// leaves it after. One that crosses outside of a segment, which is convex, hits it on the side where
// the ray is nearest to the ball that is nearest to the crossing. On the outside of a bend that is
// the joint's, for both segments; on the inside the ray may hit both of them.
float sideOfJoint(bool atEnd, float side)
{
  vec3 joint = atEnd ? endJointVC : startJointVC;
  vec3 before = atEnd ? axisVC : beforeVC;
  vec3 after = atEnd ? afterVC : axisVC;
  vec3 normal = before + after;
  vec3 direction = pixelDirection();
  vec3 origin = pixelOrigin(direction, joint);
  float climb = dot(normal, direction);
  if (climb == 0.0)
  {
    return dot(normal, origin);
  }
  vec3 crossing = origin - dot(normal, origin) / climb * direction;

  // In the plane the two axes lie opposite to each other.
  float inward = 0.5 * dot(crossing, after - before);
  float aside = sqrt(max(dot(crossing, crossing) - inward * inward, 0.0));
  float slope = atEnd ? -coneShape.z : coneShape.z;
  float radius = coneShape.y + slope * coneShape.x;
  float ball = clamp(
    inward - aside * slope * inversesqrt(1.0 - slope * slope), 0.0, 2.0 * coneShape.x);
  vec2 way = vec2(inward - ball, aside);
  float reach = radius - slope * ball;
  vec3 fromBall = origin - ball * (atEnd ? -axisVC : axisVC);
  float nearest =
    dot(normal, origin) * dot(direction, direction) - dot(fromBall, direction) * climb;
  return dot(way, way) <= reach * reach ? side * climb : nearest;
}

// Is the hit on the segment's side of its two joint planes?
bool betweenJoints(vec3 point, float side)
{
  float start = dot(startPlaneLC, vec4(point, 1.0));
  float end = dot(endPlaneLC, vec4(point, 1.0));
  bool atEnd = abs(end) < abs(start);
  if (min(abs(start), abs(end)) < JOINT_BAND * coneShape.y && coneShape.x > 0.0)
  {
    float height = sideOfJoint(atEnd, side);
    start = atEnd ? start : -height;
    end = atEnd ? height : end;
  }
  return start <= 0.0 && end < 0.0;
}

//VTK::Exit::Dec
