// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/normal_evaluation.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/angles.h>

#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr double bins_per_degree = 100.;
constexpr double considerable_degrees = 25.;

bool
isDirection (const Eigen::Vector3f& v)
{
  return v.allFinite() && !v.isZero (0.f);
}

} // namespace

bool
NormalDeviations::add (const pcl::Normal& reference, const pcl::Normal& normal)
{
  const Eigen::Vector3f a = reference.getNormalVector3fMap();
  const Eigen::Vector3f b = normal.getNormalVector3fMap();
  if (!isDirection (a))
    return false;
  ++reference_normals_;
  if (!isDirection (b))
    return false;
  ++both_normals_;
  const double degrees = pcl::rad2deg (std::atan2 (a.cross (b).norm(), a.dot (b)));
  sum_ += degrees;
  if (degrees > considerable_degrees)
    ++over_25_;
  histogram_.resize (static_cast<std::size_t> (180. * bins_per_degree) + 1);
  ++histogram_[static_cast<std::size_t> (degrees * bins_per_degree)];
  return true;
}

double
NormalDeviations::mean() const
{
  return sum_ / static_cast<double> (both_normals_);
}

double
NormalDeviations::median() const
{
  std::size_t below = 0;
  for (std::size_t bin = 0; bin < histogram_.size(); ++bin) {
    below += histogram_[bin];
    if (2 * below >= both_normals_)
      return (static_cast<double> (bin) + 0.5) / bins_per_degree;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double
NormalDeviations::over25Percent() const
{
  return percentOf (over_25_, both_normals_);
}

double
NormalDeviations::coveragePercent() const
{
  return percentOf (both_normals_, reference_normals_);
}

} // namespace rgbd_planes
} // namespace pcl
