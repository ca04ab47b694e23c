// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/fit_camera.h>
#include <pcl/apps/object_pictures.h>
#include <pcl/apps/scene_lines.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Draws lines between points in space. */
class LineDrawer {
public:
  LineDrawer (const Intrinsics& camera, Picture& picture)
  : camera_ (camera)
  , picture_ (picture)
  {}

  void
  draw (const ColouredLine& line)
  {
    for (std::size_t k = 1; k < line.points.size(); ++k)
      draw (line.points[k - 1], line.points[k], line.colour);
  }

private:
  void
  draw (const Eigen::Vector3f& from, const Eigen::Vector3f& to, const pcl::RGB& colour)
  {
    constexpr float nearest_m = 0.05f;
    if (!(from.z() > nearest_m && to.z() > nearest_m))
      return;
    const Eigen::Vector2f a = project (from), b = project (to);
    const float length = (b - a).cwiseAbs().maxCoeff();
    const auto steps = static_cast<int> (std::min (length, 10000.f)) + 1;
    for (int k = 0; k <= steps; ++k)
      set (a + (b - a) * (static_cast<float> (k) / static_cast<float> (steps)), colour);
  }

  Eigen::Vector2f
  project (const Eigen::Vector3f& p) const
  {
    return {camera_.fx * p.x() / p.z() + camera_.cx,
            camera_.fy * p.y() / p.z() + camera_.cy};
  }

  void
  set (const Eigen::Vector2f& at, const pcl::RGB& colour)
  {
    const float u = std::round (at.x()), v = std::round (at.y());
    if (u >= 0.f && v >= 0.f && u < static_cast<float> (picture_.width) &&
        v < static_cast<float> (picture_.height))
      picture_ (static_cast<int> (u), static_cast<int> (v)) = colour;
  }

  Intrinsics camera_;
  Picture& picture_;
};

} // namespace

Picture
objectsPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                const std::vector<ObjectSummary>& objects,
                const std::vector<pcl::SupportPlane>& supports)
{
  Picture picture = depthPicture (cloud);
  for (auto& pixel : picture) {
    const auto grey = static_cast<std::uint8_t> ((pixel.r + pixel.g + pixel.b) / 3);
    pixel = {grey, grey, grey};
  }
  for (std::size_t k = 0; k < objects.size(); ++k)
    for (const auto i : objects[k].object.indices.indices)
      picture[static_cast<std::size_t> (i)] =
          planeColour (static_cast<std::uint32_t> (k + 1)); // 0 is red, as lines are
  LineDrawer lines (fitCamera (cloud), picture);
  for (const auto& support : supports)
    if (!support.is_on_object)
      lines.draw (
          hullLine (support, planeColour (static_cast<std::uint32_t> (support.index))));
  for (const auto& summary : objects)
    for (const auto& edge : boxLines (summary.object))
      lines.draw (edge);
  return picture;
}

} // namespace rgbd_planes
} // namespace pcl
