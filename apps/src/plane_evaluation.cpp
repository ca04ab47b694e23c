// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_evaluation.h>
#include <pcl/apps/statistics.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr double hoover_overlap = 0.8;

/** Counts the wholes that are covered by several parts, and marks both as explained.
 * \param[in] share (part, whole) the points of a part in a whole, 0 where it lies
 * outside
 */
template <typename Share>
std::size_t
countCovered (const std::vector<std::size_t>& whole_sizes,
              const Share& share,
              std::vector<bool>& whole_explained,
              std::vector<bool>& part_explained)
{
  std::size_t count = 0;
  for (std::size_t whole = 0; whole < whole_sizes.size(); ++whole) {
    std::vector<std::size_t> parts;
    std::size_t covered = 0;
    for (std::size_t part = 0; part < part_explained.size(); ++part)
      if (const std::size_t points = share (part, whole)) {
        parts.push_back (part);
        covered += points;
      }
    if (whole_explained[whole] || parts.size() < 2 ||
        static_cast<double> (covered) <
            hoover_overlap * static_cast<double> (whole_sizes[whole]))
      continue;
    ++count;
    whole_explained[whole] = true;
    for (const std::size_t part : parts)
      part_explained[part] = true;
  }
  return count;
}

} // namespace

/** Sizes of all regions and of their common parts, in measured points. */
struct PlaneEvaluation::Regions {
  std::size_t truths = 0, founds = 0;
  std::vector<std::size_t> truth_size, found_size, common;
  std::vector<bool> truth_counts, found_counts;

  std::size_t
  overlap (std::size_t truth, std::size_t found) const
  {
    return common[truth * founds + found];
  }

  bool
  truthInside (std::size_t truth, std::size_t found) const
  {
    return truth_counts[truth] && found_counts[found] &&
           static_cast<double> (overlap (truth, found)) >=
               hoover_overlap * static_cast<double> (truth_size[truth]);
  }

  bool
  foundInside (std::size_t found, std::size_t truth) const
  {
    return truth_counts[truth] && found_counts[found] &&
           static_cast<double> (overlap (truth, found)) >=
               hoover_overlap * static_cast<double> (found_size[found]);
  }

  double
  iou (std::size_t truth, std::size_t found) const
  {
    const std::size_t both = overlap (truth, found);
    return static_cast<double> (both) /
           static_cast<double> (truth_size[truth] + found_size[found] - both);
  }
};

void
PlaneEvaluation::add (const OrganizedPoints& points, const PlaneSet& found)
{
  planes_found += found.coefficients.size();
  addPoints (points, found);
}

void
PlaneEvaluation::addPoints (const OrganizedPoints& points, const PlaneSet& found)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float* p = points[i];
    if (!isMeasured (p))
      continue;
    ++measured_;
    if (found.labels[i] == unlabelled)
      continue;
    ++labelled_;
    const Eigen::Vector4f& plane = found.coefficients[found.labels[i]];
    const float distance = plane.dot (Eigen::Vector4f (p[0], p[1], p[2], 1.f));
    off_ += std::abs (distance) > 0.005f + 0.004f * p[2] * p[2];
  }
}

void
PlaneEvaluation::add (const OrganizedPoints& points,
                      const PlaneSet& found,
                      const PlaneSet& truth,
                      std::size_t min_points)
{
  addPoints (points, found);
  has_truth_ = true;
  Regions regions;
  regions.truths = truth.coefficients.size();
  regions.founds = found.coefficients.size();
  regions.truth_size.assign (regions.truths, 0);
  regions.found_size.assign (regions.founds, 0);
  regions.common.assign (regions.truths * regions.founds, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isMeasured (points[i]))
      continue;
    const std::uint32_t t = truth.labels[i], f = found.labels[i];
    if (t != unlabelled)
      ++regions.truth_size[t];
    if (f != unlabelled)
      ++regions.found_size[f];
    if (t != unlabelled && f != unlabelled)
      ++regions.common[t * regions.founds + f];
  }

  for (const std::size_t size : regions.truth_size)
    regions.truth_counts.push_back (size >= std::max (min_points, std::size_t{1}));
  for (std::size_t f = 0; f < regions.founds; ++f) {
    std::size_t not_asked_for = 0;
    for (std::size_t t = 0; t < regions.truths; ++t)
      if (!regions.truth_counts[t])
        not_asked_for += regions.overlap (t, f);
    regions.found_counts.push_back (2 * not_asked_for <= regions.found_size[f]);
  }
  countRegions (regions);
  matchPlanes (points, found, truth, regions);
}

void
PlaneEvaluation::countRegions (const Regions& regions)
{
  std::vector<bool> truth_explained (regions.truths, false);
  std::vector<bool> found_explained (regions.founds, false);
  for (std::size_t t = 0; t < regions.truths; ++t)
    for (std::size_t f = 0; f < regions.founds; ++f)
      if (regions.truthInside (t, f) && regions.foundInside (f, t)) {
        ++correct;
        truth_explained[t] = found_explained[f] = true;
      }

  over += countCovered (
      regions.truth_size,
      [&] (std::size_t f, std::size_t t) {
        return regions.foundInside (f, t) ? regions.overlap (t, f) : 0;
      },
      truth_explained,
      found_explained);
  under += countCovered (
      regions.found_size,
      [&] (std::size_t t, std::size_t f) {
        return regions.truthInside (t, f) ? regions.overlap (t, f) : 0;
      },
      found_explained,
      truth_explained);

  for (std::size_t t = 0; t < regions.truths; ++t)
    if (regions.truth_counts[t]) {
      ++planes_truth;
      missed += !truth_explained[t];
    }
  for (std::size_t f = 0; f < regions.founds; ++f)
    if (regions.found_counts[f]) {
      ++planes_found;
      ++found_with_truth_;
      noise += !found_explained[f];
    }
}

void
PlaneEvaluation::matchPlanes (const OrganizedPoints& points,
                              const PlaneSet& found,
                              const PlaneSet& truth,
                              const Regions& regions)
{
  for (std::size_t t = 0; t < regions.truths; ++t) {
    if (!regions.truth_counts[t])
      continue;
    double best = 0.;
    std::size_t match = 0;
    for (std::size_t f = 0; f < regions.founds; ++f)
      if (regions.found_counts[f] && regions.iou (t, f) > best) {
        best = regions.iou (t, f);
        match = f;
      }
    iou_sum_ += best;
    // Above one half, no other region can have as large an intersection over union.
    if (best <= 0.5)
      continue;
    ++pairs_;
    const Eigen::Vector4f& a = truth.coefficients[t];
    const Eigen::Vector4f& b = found.coefficients[match];
    const Eigen::Vector3f na = a.head<3>(), nb = b.head<3>();
    angles_.push_back (std::atan2 (na.cross (nb).norm(), std::abs (na.dot (nb))) *
                       180. / M_PI);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (truth.labels[i] == t && isMeasured (points[i]))
        sum += Eigen::Map<const Eigen::Vector3f> (points[i]).cast<double>();
    Eigen::Vector3d centroid = sum / static_cast<double> (regions.truth_size[t]);
    const Eigen::Vector4d true_plane = a.cast<double>(), found_plane = b.cast<double>();
    centroid -= true_plane.dot (centroid.homogeneous()) * true_plane.head<3>();
    distances_.push_back (1000. * std::abs (found_plane.dot (centroid.homogeneous())));
  }
}

double
PlaneEvaluation::f1() const
{
  return 2. * static_cast<double> (pairs_) /
         static_cast<double> (planes_truth + found_with_truth_);
}

double
PlaneEvaluation::meanIou() const
{
  return iou_sum_ / static_cast<double> (planes_truth);
}

double
PlaneEvaluation::coveragePercent() const
{
  return percentOf (labelled_, measured_);
}

double
PlaneEvaluation::offPercent() const
{
  return percentOf (off_, labelled_);
}

double
PlaneEvaluation::medianAngleDegrees() const
{
  return median (angles_);
}

double
PlaneEvaluation::medianDistanceMillimetres() const
{
  return median (distances_);
}

} // namespace rgbd_planes
} // namespace pcl
