// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_correction.h>
#include <pcl/apps/statistics.h>
#include <pcl/features/depth_noise.h>
#include <pcl/filters/project_onto_planes.h>
#include <pcl/segmentation/impl/label_runs.h>
#include <pcl/segmentation/impl/plane_moments.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float min_range_m = 3.5f;
constexpr float max_range_m = 6.f;
constexpr std::size_t min_wall_percent = 2;
constexpr float max_rise_of_wall_normal = 0.1f;
constexpr float max_cosine_of_pair = 0.866f;
constexpr double good_within_deg = 1.;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Projection = pcl::ProjectOntoPlanes<pcl::PointXYZ>;

/** A frame and its true planes. */
struct TrueFrame {
  const Cloud& cloud;
  const PlaneSet& truth;
  const pcl::PointCloud<TruthPoint>& pixels;
  /** The measured points of each true plane. */
  std::vector<std::size_t> points;

  bool
  isInside (std::size_t i) const
  {
    return truth.labels[i] != unlabelled && pixels[i].edge == 0 &&
           isMeasured (&cloud[i].x);
  }
};

std::vector<std::size_t>
countPoints (const Cloud& cloud, const PlaneSet& truth)
{
  std::vector<std::size_t> points (truth.coefficients.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (truth.labels[i] != unlabelled && isMeasured (&cloud[i].x))
      ++points[truth.labels[i]];
  return points;
}

Cloud
project (const Cloud::ConstPtr& cloud,
         const PlaneSet& planes,
         Projection::Direction direction)
{
  std::vector<pcl::ModelCoefficients> models (planes.coefficients.size());
  for (std::size_t k = 0; k < models.size(); ++k)
    models[k].values.assign (planes.coefficients[k].data(),
                             planes.coefficients[k].data() + 4);
  const auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  for (const std::uint32_t label : planes.labels) {
    labels->emplace_back();
    labels->back().label = label;
  }
  Projection projection;
  projection.setDirection (direction);
  projection.setInputCloud (cloud);
  projection.setInputPlanes (models, labels);
  Cloud result;
  projection.filter (result);
  return result;
}

PlaneSet
fitPlanes (const TrueFrame& frame)
{
  std::vector<PlaneMoments> moments (frame.truth.coefficients.size());
  for (std::size_t i = 0; i < frame.cloud.size(); ++i)
    if (frame.isInside (i)) {
      const pcl::PointXYZ& point = frame.cloud[i];
      const float squared_range = point.getVector3fMap().squaredNorm();
      const float sigma = DepthNoise().sigmaAtSquare (squared_range);
      moments[frame.truth.labels[i]].add (&point.x, squared_range / (sigma * sigma));
    }
  PlaneSet fits{{}, frame.truth.labels};
  for (const PlaneMoments& sums : moments) {
    const Plane plane = planeOf (sums.inverseDistance());
    fits.coefficients.emplace_back (
        plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.d);
  }
  return fits;
}

void
addResiduals (const TrueFrame& frame,
              const Cloud& corrected,
              std::size_t min_points,
              Residuals& residuals)
{
  for (std::size_t i = 0; i < frame.cloud.size(); ++i) {
    const float range = frame.cloud[i].getVector3fMap().norm();
    if (!frame.isInside (i) || range < min_range_m || range > max_range_m ||
        frame.points[frame.truth.labels[i]] < min_points)
      continue;
    const double residual = frame.truth.coefficients[frame.truth.labels[i]].dot (
        corrected[i].getVector4fMap());
    residuals.squares += residual * residual;
    ++residuals.points;
  }
}

/** For each true plane the one of \a found that at least half of its points are on;
 * unlabelled where there is none. */
std::vector<std::uint32_t>
matchPlanes (const TrueFrame& frame, const PlaneSet& found)
{
  const std::size_t founds = found.coefficients.size();
  std::vector<std::size_t> common (frame.points.size() * founds, 0);
  for (std::size_t i = 0; i < frame.cloud.size(); ++i)
    if (frame.truth.labels[i] != unlabelled && found.labels[i] != unlabelled &&
        isMeasured (&frame.cloud[i].x))
      ++common[frame.truth.labels[i] * founds + found.labels[i]];
  std::vector<std::uint32_t> matches (frame.points.size(), unlabelled);
  for (std::size_t t = 0; t < matches.size(); ++t)
    for (std::size_t f = 0; f < founds; ++f)
      if (2 * common[t * founds + f] >= frame.points[t])
        matches[t] = static_cast<std::uint32_t> (f);
  return matches;
}

double
degreesBetween (const Eigen::Vector4f& a, const Eigen::Vector4f& b)
{
  const double cosine = a.head<3>().cast<double>().dot (b.head<3>().cast<double>());
  return std::acos (std::clamp (cosine, -1., 1.)) * 180. / M_PI;
}

void
addWalls (const TrueFrame& frame,
          const PlaneSet& found,
          const Eigen::Vector3f& up,
          WallAngles& angles)
{
  const auto matches = matchPlanes (frame, found);
  const auto& truth = frame.truth.coefficients;
  std::vector<std::size_t> walls;
  for (std::size_t t = 0; t < truth.size(); ++t)
    if (100 * frame.points[t] >= min_wall_percent * frame.cloud.size() &&
        std::abs (truth[t].head<3>().dot (up)) <= max_rise_of_wall_normal)
      walls.push_back (t);
  for (const std::size_t a : walls)
    for (const std::size_t b : walls) {
      if (b <= a ||
          std::abs (truth[a].head<3>().dot (truth[b].head<3>())) > max_cosine_of_pair)
        continue;
      double error = std::numeric_limits<double>::infinity();
      if (matches[a] != unlabelled && matches[b] != unlabelled)
        error = std::abs (degreesBetween (found.coefficients[matches[a]],
                                          found.coefficients[matches[b]]) -
                          degreesBetween (truth[a], truth[b]));
      angles.errors.push_back (error);
    }
}

} // namespace

double
Residuals::rmsMillimetres() const
{
  return 1000. * std::sqrt (squares / static_cast<double> (points));
}

double
WallAngles::medianDegrees() const
{
  return median (errors);
}

double
WallAngles::withinPercent() const
{
  return percentUpTo (good_within_deg, errors);
}

void
PlaneCorrection::add (const Cloud::ConstPtr& cloud,
                      const FoundPlanes& found,
                      const PlaneSet& truth,
                      const pcl::PointCloud<TruthPoint>& pixels,
                      const Eigen::Vector3f& up,
                      std::size_t min_points)
{
  const TrueFrame frame{*cloud, truth, pixels, countPoints (*cloud, truth)};
  const PlaneSet fits = fitPlanes (frame);
  using Direction = Projection::Direction;
  const auto addProjected = [&] (const Cloud::ConstPtr& points,
                                 const PlaneSet& planes,
                                 Direction direction,
                                 Residuals& residuals) {
    addResiduals (frame, project (points, planes, direction), min_points, residuals);
  };
  addResiduals (frame, *cloud, min_points, before);
  addProjected (found.cloud, found, Direction::viewing_ray, along_ray);
  addProjected (found.cloud, found, Direction::normal, along_normal);
  addProjected (cloud, fits, Direction::viewing_ray, fits_along_ray);
  addWalls (frame, found, up, walls);
  addWalls (frame, fits, up, fits_walls);
}

} // namespace rgbd_planes
} // namespace pcl
