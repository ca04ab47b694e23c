// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "renderer.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

namespace {

using Eigen::Vector3f;

constexpr std::size_t cylinder_sides = 128;

#if RTC_VERSION_MAJOR == 3 // Embree 4 has both of these.
void
rtcIntersect1 (RTCScene scene, RTCRayHit* hit)
{
  RTCIntersectContext context;
  rtcInitIntersectContext (&context);
  ::rtcIntersect1 (scene, &context, hit);
}

void
rtcOccluded1 (RTCScene scene, RTCRay* ray)
{
  RTCIntersectContext context;
  rtcInitIntersectContext (&context);
  ::rtcOccluded1 (scene, &context, ray);
}
#endif

/** A scene in Embree, in the camera frame: geometry i is surface i. */
class RayTracer {
public:
  /** One instruction set, so that all processors get the same bytes. */
  explicit RayTracer (const std::vector<Surface>& surfaces)
  : device_ (rtcNewDevice ("threads=1,isa=sse2"), rtcReleaseDevice)
  , scene_ (rtcNewScene (device_.get()), rtcReleaseScene)
  {
    rtcSetSceneFlags (scene_.get(), RTC_SCENE_FLAG_ROBUST);
    for (const auto& surface : surfaces)
      attach (surface);
    rtcCommitScene (scene_.get());
    if (rtcGetDeviceError (device_.get()) != RTC_ERROR_NONE)
      throw std::runtime_error ("simulate: Embree could not build the scene");
  }

  /** The hit of the ray from the camera along \a direction; its geomID and tfar. */
  RTCRayHit
  trace (const Vector3f& direction) const
  {
    RTCRayHit hit{};
    hit.ray = ray (Vector3f::Zero(), direction);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1 (scene_.get(), &hit);
    return hit;
  }

  bool
  isHidden (const Vector3f& point, const Vector3f& from) const
  {
    RTCRay shadow = ray (from, point - from);
    shadow.tfar = 0.999f;
    rtcOccluded1 (scene_.get(), &shadow);
    return shadow.tfar < 0.f;
  }

private:
  static RTCRay
  ray (const Vector3f& origin, const Vector3f& direction)
  {
    RTCRay ray{};
    ray.org_x = origin.x();
    ray.org_y = origin.y();
    ray.org_z = origin.z();
    ray.dir_x = direction.x();
    ray.dir_y = direction.y();
    ray.dir_z = direction.z();
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0u;
    return ray;
  }

  void
  attach (const Surface& surface)
  {
    const bool is_sphere = surface.shape == Surface::Shape::sphere;
    std::unique_ptr<RTCGeometryTy, decltype (&rtcReleaseGeometry)> geometry (
        rtcNewGeometry (device_.get(),
                        is_sphere ? RTC_GEOMETRY_TYPE_SPHERE_POINT
                                  : RTC_GEOMETRY_TYPE_TRIANGLE),
        rtcReleaseGeometry);
    if (is_sphere)
      fillSphere (geometry.get(), surface);
    else if (surface.shape == Surface::Shape::cylinder)
      fillCylinder (geometry.get(), surface);
    else
      fillPolygon (geometry.get(), surface);
    rtcCommitGeometry (geometry.get());
    rtcAttachGeometry (scene_.get(), geometry.get());
  }

  template <typename Element>
  static Element*
  newBuffer (RTCGeometry geometry,
             RTCBufferType type,
             RTCFormat format,
             std::size_t size)
  {
    auto* buffer = static_cast<Element*> (
        rtcSetNewGeometryBuffer (geometry, type, 0, format, sizeof (Element), size));
    if (buffer == nullptr)
      throw std::bad_alloc();
    return buffer;
  }

  static void
  fillSphere (RTCGeometry geometry, const Surface& surface)
  {
    auto* sphere = newBuffer<std::array<float, 4>> (
        geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 1);
    const Vector3f& center = surface.points[0];
    *sphere = {{center.x(), center.y(), center.z(), surface.radius}};
  }

  static void
  fillPolygon (RTCGeometry geometry, const Surface& surface)
  {
    const auto& corners = surface.points;
    auto* vertices = newBuffer<std::array<float, 3>> (
        geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      vertices[i] = {{corners[i].x(), corners[i].y(), corners[i].z()}};
    auto* triangles = newBuffer<std::array<unsigned, 3>> (
        geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, corners.size() - 2);
    for (unsigned i = 0; i + 2 < corners.size(); ++i)
      triangles[i] = {{0, i + 1, i + 2}};
  }

  static void
  fillCylinder (RTCGeometry geometry, const Surface& surface)
  {
    const Vector3f axis = surface.points[1] - surface.points[0];
    const Vector3f across = axis.unitOrthogonal() * surface.radius;
    auto* vertices = newBuffer<std::array<float, 3>> (
        geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 2 * cylinder_sides);
    auto* triangles = newBuffer<std::array<unsigned, 3>> (
        geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 2 * cylinder_sides);
    for (std::size_t i = 0; i < cylinder_sides; ++i) {
      const float angle = 6.2831853f * static_cast<float> (i) / cylinder_sides;
      const Vector3f rim = Eigen::AngleAxisf (angle, axis.normalized()) * across;
      for (std::size_t end = 0; end < 2; ++end) {
        const Vector3f vertex = surface.points[end] + rim;
        vertices[2 * i + end] = {{vertex.x(), vertex.y(), vertex.z()}};
      }
      const auto here = static_cast<unsigned> (2 * i);
      const auto next = static_cast<unsigned> (2 * ((i + 1) % cylinder_sides));
      triangles[2 * i] = {{here, here + 1, next}};
      triangles[2 * i + 1] = {{next, here + 1, next + 1}};
    }
  }

  std::unique_ptr<RTCDeviceTy, decltype (&rtcReleaseDevice)> device_;
  std::unique_ptr<RTCSceneTy, decltype (&rtcReleaseScene)> scene_;
};

/** The outer normal at \a point; that of a polygon points to either side. */
Vector3f
normalAt (const Surface& surface, const Vector3f& point)
{
  const auto& p = surface.points;
  if (surface.shape == Surface::Shape::sphere)
    return (point - p[0]).normalized();
  if (surface.shape == Surface::Shape::cylinder) {
    const Vector3f axis = (p[1] - p[0]).normalized();
    const Vector3f radial = point - p[0];
    return (radial - axis * axis.dot (radial)).normalized();
  }
  const Vector3f& second = p[p.size() / 3];
  const Vector3f& third = p[2 * p.size() / 3];
  return (second - p[0]).cross (third - p[0]).normalized();
}

std::vector<Surface>
inCameraFrame (const Scene& scene)
{
  const Eigen::Affine3f base_to_camera = scene.camera_to_base.inverse();
  std::vector<Surface> surfaces = scene.surfaces;
  for (auto& surface : surfaces)
    for (auto& point : surface.points)
      point = base_to_camera * point;
  return surfaces;
}

Vector3f
colorAt (const Surface& surface, const Vector3f& point_in_base)
{
  for (const auto& decal : surface.decals)
    if (decal.region.contains (point_in_base))
      return decal.color;
  return surface.color;
}

} // namespace

std::vector<RenderedPixel>
render (const Scene& scene, const Camera& camera, const std::vector<Vector3f>& eyes)
{
  const std::vector<Surface> surfaces = inCameraFrame (scene);
  const RayTracer tracer (surfaces);
  std::vector<RenderedPixel> image;
  image.reserve (static_cast<std::size_t> (camera.width) * camera.height);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      RenderedPixel pixel;
      const Vector3f ray =
          rayThrough (camera, static_cast<float> (u), static_cast<float> (v));
      const RTCRayHit hit = tracer.trace (ray);
      if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        const Surface& surface = surfaces[hit.hit.geomID];
        pixel.surface = hit.hit.geomID;
        pixel.point = ray * hit.ray.tfar;
        pixel.normal = normalAt (surface, pixel.point);
        if (pixel.normal.dot (ray) > 0.f)
          pixel.normal = -pixel.normal;
        pixel.color = colorAt (surface, scene.camera_to_base * pixel.point);
        pixel.in_shadow = std::any_of (eyes.begin(), eyes.end(), [&] (const auto& eye) {
          return tracer.isHidden (pixel.point, eye);
        });
      }
      image.push_back (pixel);
    }
  return image;
}

} // namespace rgbd_planes
} // namespace pcl
