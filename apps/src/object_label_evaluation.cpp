// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/object_label_evaluation.h>
#include <pcl/apps/statistics.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <algorithm>
#include <limits>
#include <map>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The parts of an object, and those of the table, make one group. */
std::uint32_t
groupOf (std::uint32_t label)
{
  return label / 10;
}

constexpr std::uint32_t table = 0;

double
bestIou (std::size_t table_points,
         const std::vector<std::size_t>& plane_points,
         const std::vector<std::size_t>& common)
{
  double best = 0.;
  for (std::size_t k = 0; k < plane_points.size(); ++k)
    best =
        std::max (best,
                  static_cast<double> (common[k]) /
                      static_cast<double> (table_points + plane_points[k] - common[k]));
  return best;
}

} // namespace

void
ObjectLabelEvaluation::add (const OrganizedPoints& points,
                            const PlaneSet& found,
                            const pcl::PointCloud<pcl::Label>& labels)
{
  std::size_t table_points = 0;
  std::vector<std::size_t> plane_points (found.coefficients.size(), 0);
  std::vector<std::map<std::uint32_t, std::size_t>> groups (plane_points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels[i].label == 0 || !isMeasured (points[i]))
      continue;
    const std::uint32_t group = groupOf (labels[i].label);
    table_points += group == table;
    if (found.labels[i] == unlabelled)
      continue;
    ++plane_points[found.labels[i]];
    ++groups[found.labels[i]][group];
  }

  std::vector<std::size_t> common (plane_points.size(), 0);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    std::size_t largest = 0;
    for (const auto& [group, count] : groups[k])
      largest = std::max (largest, count);
    majority_ += largest;
    in_planes_ += plane_points[k];
    common[k] = groups[k][table];
  }
  if (table_points > 0)
    table_ious_.push_back (bestIou (table_points, plane_points, common));
}

double
ObjectLabelEvaluation::tableIou() const
{
  return mean (table_ious_);
}

double
ObjectLabelEvaluation::worstTableIou() const
{
  return table_ious_.empty()
             ? std::numeric_limits<double>::quiet_NaN()
             : *std::min_element (table_ious_.begin(), table_ious_.end());
}

double
ObjectLabelEvaluation::purityPercent() const
{
  return percentOf (majority_, in_planes_);
}

} // namespace rgbd_planes
} // namespace pcl
