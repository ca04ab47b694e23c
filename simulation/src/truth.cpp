// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
    if (surface.shape != Surface::Shape::polygon || surface.first_facet)
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

/** Finds the pixels that have one of another surface near them. */
class EdgeMarker {
public:
  EdgeMarker (const Scene& scene,
              const std::vector<RenderedPixel>& image,
              pcl::PointCloud<TruthPoint>& truth)
  : truth_ (truth)
  , width_ (static_cast<int> (truth.width))
  , height_ (static_cast<int> (truth.height))
  {
    surfaces_.reserve (image.size());
    for (const auto& pixel : image)
      surfaces_.push_back (wholeSurface (scene, pixel.surface));
  }

  void
  mark ()
  {
    for (int v = 0; v < height_; ++v)
      for (int u = 0; u < width_; ++u)
        if (isAtBorder (u, v))
          markAround (u, v);
  }

private:
  /** The same for all facets of a curved surface. */
  static std::uint32_t
  wholeSurface (const Scene& scene, std::uint32_t surface)
  {
    if (surface == RenderedPixel::no_surface)
      return surface;
    return scene.surfaces[surface].first_facet.value_or (surface);
  }

  /** Not on one surface, nor on two that continue each other. */
  bool
  differ (int u, int v, int other_u, int other_v) const
  {
    const std::size_t i = v * width_ + u;
    const std::size_t j = other_v * width_ + other_u;
    return surfaces_[i] != surfaces_[j] &&
           (truth_[i].label == 0 || truth_[i].label != truth_[j].label);
  }

  bool
  isAtBorder (int u, int v) const
  {
    return (u > 0 && differ (u, v, u - 1, v)) || (v > 0 && differ (u, v, u, v - 1)) ||
           (u + 1 < width_ && differ (u, v, u + 1, v)) ||
           (v + 1 < height_ && differ (u, v, u, v + 1));
  }

  void
  markAround (int u, int v)
  {
    for (int y = std::max (v - edge_px, 0); y <= std::min (v + edge_px, height_ - 1);
         ++y)
      for (int x = std::max (u - edge_px, 0); x <= std::min (u + edge_px, width_ - 1);
           ++x)
        if (differ (u, v, x, y))
          truth_ (x, y).edge = 1;
  }

  std::vector<std::uint32_t> surfaces_;
  pcl::PointCloud<TruthPoint>& truth_;
  int width_;
  int height_;
};

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
  EdgeMarker (scene, image, *frame.truth).mark();
}

} // namespace rgbd_planes
} // namespace pcl
