// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/warped_plane_fit.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int cells_in_row = 80;
/** Planes with fewer are left alone. */
constexpr std::size_t min_cells = 20;
constexpr int max_half_periods = 7;
/** Waves need not be level at the border of the image, where cosines are: they are those of
 * an image that is larger by this part of the width on all sides. */
constexpr double margin = 0.1;
/** The standard deviation of the warp of inverse depth, in quadratic parts of the noise. */
constexpr double warp_in_noise = 2.;
constexpr double least_warp = 1e-6; // 1/m
/** The standard deviation of what planes change by, m of m * p = 1, in that of the warp:
 * large, for directions in which few points tell nothing. */
constexpr double change_in_warp = 10.;

double
warpDeviation (const DepthNoise& noise)
{
  return std::max (warp_in_noise * static_cast<double> (noise.quadratic), least_warp);
}

/** cos (i pi t) for all half periods i, t from 0 to 1 over the image and its margins, at
 * the middles of cells. */
void
fillCosines (int pixels, int cell_size, double margin_px, Eigen::MatrixXd& cosines)
{
  cosines.resize (max_half_periods + 1, pixels / cell_size);
  for (int cell = 0; cell < cosines.cols(); ++cell) {
    const double t = ((cell + 0.5) * cell_size + margin_px) / (pixels + 2. * margin_px);
    for (int i = 0; i <= max_half_periods; ++i)
      cosines (i, cell) = std::cos (i * M_PI * t);
  }
}

} // namespace

void
WarpedPlaneFit::compute (const OrganizedPoints& points,
                         const std::vector<std::uint32_t>& plane_of,
                         const DepthNoise& noise,
                         Planes& planes)
{
  prepareWaves (points.width, points.height);
  planes_.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k)
    planes_[k].m = -planes[k].head<3>().cast<double>() / planes[k][3];
  collectCells (points, plane_of, noise);
  sumUp (noise);
  solve (noise);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const PlaneSums& sums = planes_[k];
    if (sums.cells < min_cells)
      continue;
    const Eigen::Vector3d m =
        sums.m + sums.inverse * (sums.right - sums.waves * amplitudes_);
    Eigen::Vector4d plane;
    plane << m, -1.;
    plane /= planes[k][3] > 0.f ? -m.norm() : m.norm();
    planes[k] = plane.cast<float>();
  }
}

void
WarpedPlaneFit::prepareWaves (int width, int height)
{
  if (width == width_ && height == height_)
    return;
  width_ = width;
  height_ = height;
  cell_size_ = std::max (width / cells_in_row, 1);
  fillCosines (width, cell_size_, margin * width, row_cosines_);
  fillCosines (height, cell_size_, margin * width, column_cosines_);
  waves_.clear();
  double sum = 0.;
  for (int i = 0; i <= max_half_periods; ++i)
    for (int j = 0; j <= max_half_periods; ++j) {
      const double half_periods =
          std::hypot (i, static_cast<double> (j * width) / height);
      if (half_periods > max_half_periods)
        continue;
      waves_.push_back ({i, j, 1.});
      sum += (i ? 0.5 : 1.) * (j ? 0.5 : 1.); // the mean square of the cosines
    }
  for (Wave& wave : waves_)
    wave.variance /= sum;
}

void
WarpedPlaneFit::collectCells (const OrganizedPoints& points,
                              const std::vector<std::uint32_t>& plane_of,
                              const DepthNoise& noise)
{
  for (PlaneSums& sums : planes_)
    sums.cells = 0;
  cells_.clear();
  Cell cell;
  for (cell.row = 0; cell.row < column_cosines_.cols(); ++cell.row)
    for (cell.column = 0; cell.column < row_cosines_.cols(); ++cell.column)
      if (meanOf (points, plane_of, noise, cell)) {
        cells_.push_back (cell);
        ++planes_[cell.plane].cells;
      }
}

bool
WarpedPlaneFit::meanOf (const OrganizedPoints& points,
                        const std::vector<std::uint32_t>& plane_of,
                        const DepthNoise& noise,
                        Cell& cell) const
{
  int count = 0;
  cell.ray.setZero();
  cell.inverse_depth = 0.;
  for (int v = cell.row * cell_size_; v < (cell.row + 1) * cell_size_; ++v)
    for (int u = cell.column * cell_size_; u < (cell.column + 1) * cell_size_; ++u) {
      const std::size_t i =
          static_cast<std::size_t> (v) * static_cast<std::size_t> (width_) +
          static_cast<std::size_t> (u);
      const Eigen::Map<const Eigen::Vector3f> p (points[i]);
      if (!isMeasured (points[i]) || p.z() <= 0.f || p.norm() > noise.max_range)
        continue;
      if (count == 0)
        cell.plane = plane_of[i];
      if (plane_of[i] != cell.plane || cell.plane >= planes_.size())
        return false;
      cell.ray += p.cast<double>() / p.z();
      cell.inverse_depth += 1. / p.z();
      ++count;
    }
  if (2 * count < cell_size_ * cell_size_ || !planes_[cell.plane].m.allFinite())
    return false;
  cell.ray /= count;
  cell.inverse_depth /= count;
  return true;
}

void
WarpedPlaneFit::sumUp (const DepthNoise& noise)
{
  const auto count = static_cast<Eigen::Index> (waves_.size());
  cosines_.resize (count);
  right_.setZero (count);
  squares_.setZero (count, count);
  const double change = change_in_warp * warpDeviation (noise);
  for (PlaneSums& sums : planes_) {
    sums.squares = Eigen::Matrix3d::Identity() / (change * change);
    sums.right.setZero();
    sums.waves.setZero (3, count);
  }
  for (const Cell& cell : cells_) {
    PlaneSums& sums = planes_[cell.plane];
    if (sums.cells < min_cells)
      continue;
    for (Eigen::Index k = 0; k < count; ++k)
      cosines_[k] = row_cosines_ (waves_[k].along_row, cell.column) *
                    column_cosines_ (waves_[k].along_column, cell.row);
    // Errors of neighbours are alike: the mean of a cell is not much better than they are.
    const double s = cell.inverse_depth;
    const double sigma = noise.constant * s * s + noise.quadratic;
    const double weight = 1. / (sigma * sigma);
    squares_.selfadjointView<Eigen::Lower>().rankUpdate (cosines_, weight);
    const double error = s - sums.m.dot (cell.ray);
    right_ += weight * error * cosines_;
    sums.squares += weight * cell.ray * cell.ray.transpose();
    sums.right += weight * error * cell.ray;
    sums.waves.noalias() += weight * cell.ray * cosines_.transpose();
  }
}

/** Eliminates the planes, which leaves as many equations as waves. */
void
WarpedPlaneFit::solve (const DepthNoise& noise)
{
  const double warp = warpDeviation (noise);
  for (std::size_t k = 0; k < waves_.size(); ++k)
    squares_ (k, k) += 1. / (waves_[k].variance * warp * warp);
  for (PlaneSums& sums : planes_) {
    if (sums.cells < min_cells)
      continue;
    sums.inverse = sums.squares.inverse();
    weighed_.noalias() = sums.inverse * sums.waves;
    squares_.triangularView<Eigen::Lower>() -= sums.waves.transpose() * weighed_;
    right_.noalias() -= weighed_.transpose() * sums.right;
  }
  factors_.compute (squares_);
  amplitudes_ = right_;
  factors_.solveInPlace (amplitudes_);
}

} // namespace rgbd_planes
} // namespace pcl
