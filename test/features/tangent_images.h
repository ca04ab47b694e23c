// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/tangent_normals.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

/** Images of points for rgbd_planes::TangentNormals itself, which also takes images of one
 * row. */
namespace tangent_images {

using pcl::rgbd_planes::TangentNormalParameters;

struct Image {
  int width, height;
  /** x, y, z of each point. */
  std::vector<Eigen::Vector3f> points;

  Image (int columns, int rows)
  : width (columns)
  , height (rows)
  , points (static_cast<std::size_t> (columns * rows), Eigen::Vector3f::Zero())
  {}

  std::size_t
  index (int u, int v) const
  {
    return static_cast<std::size_t> (v * width + u);
  }

  Eigen::Vector3f&
  operator() (int u, int v)
  {
    return points[index (u, v)];
  }

  const Eigen::Vector3f&
  operator() (int u, int v) const
  {
    return points[index (u, v)];
  }
};

/** nx, ny, nz, curvature of each point. */
using ImageNormals = std::vector<Eigen::Vector4f>;

inline ImageNormals
compute (pcl::rgbd_planes::TangentNormals& estimator,
         const Image& image,
         const TangentNormalParameters& parameters)
{
  // Whatever is not written must not look like a normal.
  ImageNormals normals (image.points.size(), Eigen::Vector4f::Constant (7.f));
  estimator.compute ({image.points[0].data(), 3, image.width, image.height},
                     parameters,
                     {normals[0].data(), normals[0].data() + 3, 4});
  return normals;
}

inline ImageNormals
compute (const Image& image, const TangentNormalParameters& parameters = {})
{
  pcl::rgbd_planes::TangentNormals estimator;
  return compute (estimator, image, parameters);
}

/** The paper's estimator, with areas of this size in pixels. */
inline TangentNormalParameters
plain (int width, int height)
{
  TangentNormalParameters parameters;
  parameters.smoothing_width = static_cast<float> (width);
  parameters.smoothing_height = static_cast<float> (height);
  parameters.edge_aware = false;
  return parameters;
}

/** Where a camera with the field of view of a Kinect sees depth 1. */
inline Eigen::Vector3f
ray (const Image& image, int u, int v)
{
  const float f = 525.f / 640.f * static_cast<float> (std::max (image.width, 64));
  return {(static_cast<float> (2 * u - image.width) + 1.f) / (2.f * f),
          (static_cast<float> (2 * v - image.height) + 1.f) / (2.f * f),
          1.f};
}

/** Bent surfaces behind each other, with noise; one point in eight is missing, in every
 * way there is. Coordinates are in multiples of \a unit metres. */
inline Image
roughImage (int width, int height, unsigned seed, float unit = 1.f)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float inf = std::numeric_limits<float>::infinity();
  const Eigen::Vector3f missing[] = {
      {nan, nan, nan}, {0.f, 0.f, 0.f}, {0.f, -inf, 1.f}, {nan, 0.f, 1.f}};
  Image image (width, height);
  std::mt19937 generator (seed);
  std::uniform_real_distribution<float> random (-1.f, 1.f);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector3f r = ray (image, u, v);
      const bool is_near = (u / 13 + v / 9) % 2 == 1;
      const float depth = (is_near ? 1.f : 1.6f) + 0.8f * r.x() + 2.f * r.y() * r.y();
      const float noise = 0.004f * random (generator);
      image (u, v) = generator() % 8 == 0
                         ? missing[generator() % 4]
                         : Eigen::Vector3f (unit * (depth + noise) * r);
    }
  return image;
}

} // namespace tangent_images
