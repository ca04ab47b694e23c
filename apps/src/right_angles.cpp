// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/right_angles.h>
#include <pcl/apps/statistics.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::size_t min_percent = 2;
constexpr double right_within_deg = 20.;
constexpr double good_within_deg = 2.;

struct BigPlane {
  Eigen::Vector3d normal;
  /** Mean of the rows that its points are in; the first row is at the top. */
  double row;
};

std::vector<BigPlane>
bigPlanes (const OrganizedPoints& points, const PlaneSet& found)
{
  std::vector<std::size_t> counts (found.coefficients.size(), 0), rows (counts);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (found.labels[i] != unlabelled) {
      ++counts[found.labels[i]];
      rows[found.labels[i]] += i / static_cast<std::size_t> (points.width);
    }
  std::vector<BigPlane> planes;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (100 * counts[k] >= min_percent * points.size())
      planes.push_back (
          {found.coefficients[k].head<3>().cast<double>(),
           static_cast<double> (rows[k]) / static_cast<double> (counts[k])});
  return planes;
}

double
degreesFromRight (const BigPlane& a, const BigPlane& b)
{
  const double sine = std::min (std::abs (a.normal.dot (b.normal)), 1.);
  return std::asin (sine) * 180. / M_PI;
}

} // namespace

void
RightAngles::add (const OrganizedPoints& points, const PlaneSet& found, Pairs pairs)
{
  auto planes = bigPlanes (points, found);
  // The floor is the first one of each pair.
  std::sort (planes.begin(), planes.end(), [] (const BigPlane& a, const BigPlane& b) {
    return a.row > b.row;
  });
  const std::size_t firsts =
      pairs == Pairs::all ? planes.size() : std::min (planes.size(), std::size_t{1});
  bool any = false, within = true;
  for (std::size_t i = 0; i < firsts; ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const double deviation = degreesFromRight (planes[i], planes[j]);
      if (deviation > right_within_deg)
        continue;
      deviations_.push_back (deviation);
      any = true;
      within = within && deviation <= good_within_deg;
    }
  frames_ += any;
  frames_within_ += any && within;
}

double
RightAngles::medianDegrees() const
{
  return median (deviations_);
}

double
RightAngles::pairsWithinPercent() const
{
  return percentUpTo (good_within_deg, deviations_);
}

double
RightAngles::framesWithinPercent() const
{
  return percentOf (frames_within_, frames_);
}

} // namespace rgbd_planes
} // namespace pcl
