// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "truth.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int edge_px = 5;

bool
isSamePlane (const Eigen::Vector4f& a, const Eigen::Vector4f& b)
{
  constexpr float max_angle = 1e-3f;
  constexpr float max_offset_m = 1e-4f;
  return (a.head<3>() - b.head<3>()).norm() < max_angle &&
         std::fabs (a[3] - b[3]) < max_offset_m;
}

/** Numbers the planes that are seen; labels[i] is the plane of surface i. */
class PlaneLabels {
public:
  explicit PlaneLabels (std::size_t surfaces) : labels_ (surfaces, unknown) {}

  std::uint32_t
  labelOf (const Surface& surface,
           const RenderedPixel& pixel,
           std::vector<Eigen::Vector4f>& planes)
  {
    if (surface.shape != Surface::Shape::polygon)
      return 0;
    std::uint32_t& label = labels_[pixel.surface];
    if (label != unknown)
      return label;
    Eigen::Vector4f plane;
    plane << pixel.normal, -pixel.normal.dot (pixel.point);
    const auto known = std::find_if (planes.begin(), planes.end(), [&] (const auto& p) {
      return isSamePlane (p, plane);
    });
    label = static_cast<std::uint32_t> (known - planes.begin()) + 1;
    if (known == planes.end())
      planes.push_back (plane);
    return label;
  }

private:
  static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> labels_;
};

/** Surfaces meet between two pixels: they differ and do not continue each other. */
bool
isEdge (const RenderedPixel& a,
        const TruthPoint& truth_a,
        const RenderedPixel& b,
        const TruthPoint& truth_b)
{
  return a.surface != b.surface &&
         (truth_a.label == 0 || truth_a.label != truth_b.label);
}

void
markAround (pcl::PointCloud<TruthPoint>& truth, int u, int v)
{
  const int width = static_cast<int> (truth.width);
  const int height = static_cast<int> (truth.height);
  for (int y = std::max (v - edge_px, 0); y <= std::min (v + edge_px, height - 1); ++y)
    for (int x = std::max (u - edge_px, 0); x <= std::min (u + edge_px, width - 1); ++x)
      truth (x, y).edge = 1;
}

/** Marks what has a pixel beyond an edge in its (2 edge_px + 1)^2 neighbourhood. */
void
markEdges (const std::vector<RenderedPixel>& image, pcl::PointCloud<TruthPoint>& truth)
{
  const int width = static_cast<int> (truth.width);
  const int height = static_cast<int> (truth.height);
  const auto mark = [&] (int u, int v, int other_u, int other_v) {
    const std::size_t i = v * width + u;
    const std::size_t j = other_v * width + other_u;
    if (!isEdge (image[i], truth[i], image[j], truth[j]))
      return;
    markAround (truth, u, v);
    markAround (truth, other_u, other_v);
  };
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      if (u + 1 < width)
        mark (u, v, u + 1, v);
      if (v + 1 < height)
        mark (u, v, u, v + 1);
    }
}

} // namespace

void
fillTruth (const Scene& scene,
           const Camera& camera,
           const std::vector<RenderedPixel>& image,
           SimulatedFrame& frame)
{
  frame.planes.clear();
  frame.truth.reset (new pcl::PointCloud<TruthPoint> (camera.width, camera.height));
  frame.truth->is_dense = true;
  PlaneLabels labels (scene.surfaces.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const RenderedPixel& pixel = image[i];
    TruthPoint& point = (*frame.truth)[i];
    point.getVector3fMap() = pixel.point;
    point.getNormalVector3fMap() = pixel.normal;
    if (pixel.surface == RenderedPixel::no_surface) {
      frame.truth->is_dense = false;
      continue;
    }
    const Surface& surface = scene.surfaces[pixel.surface];
    point.label = labels.labelOf (surface, pixel, frame.planes);
    point.object = surface.object;
    point.obstacle = surface.obstacle ? 1 : 0;
  }
  markEdges (image, *frame.truth);
}

} // namespace rgbd_planes
} // namespace pcl
