// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/ransac_sample.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int trials = 30;

/** The plane through three points; its normal is NaN where they lie on a line. */
Plane
through (const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c)
{
  const Eigen::Vector3f cross = (b - a).cross (c - a);
  Plane plane{cross / cross.norm(), 0.f};
  plane.d = -plane.normal.dot (a);
  if (plane.d < 0.f)
    plane = {-plane.normal, -plane.d};
  return plane;
}

} // namespace

void
RansacSample::clear()
{
  for (auto* values : {&x_, &y_, &z_, &tolerance_})
    values->clear();
}

void
RansacSample::add (const Eigen::Vector3f& p, float tolerance)
{
  x_.push_back (p.x());
  y_.push_back (p.y());
  z_.push_back (p.z());
  tolerance_.push_back (tolerance);
}

Eigen::Vector3f
RansacSample::mean() const
{
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < size(); ++i)
    mean += (*this)[i] / static_cast<float> (size());
  return mean;
}

Plane
RansacSample::planeOfMost (const Plane& plane) const
{
  Plane best = plane;
  std::size_t most = countAgreeing (best);
  std::minstd_rand random;
  const auto draw = [&] { return (*this)[random() % size()]; };
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::Vector3f a = draw(), b = draw(), c = draw();
    const Plane other = through (a, b, c);
    const std::size_t agreeing = countAgreeing (other);
    if (agreeing > most) {
      most = agreeing;
      best = other;
    }
  }
  return best;
}

std::size_t
RansacSample::countAgreeing (const Plane& plane) const
{
  unsigned count = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const float p[3] = {x_[i], y_[i], z_[i]};
    count += std::fabs (plane.distance (p)) < tolerance_[i];
  }
  return count;
}

} // namespace rgbd_planes
} // namespace pcl
