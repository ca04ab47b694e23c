// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/depth_warp.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Along the longer side of the image. */
constexpr int cells_in_line = 80;
/** Planes with fewer tell nothing. */
constexpr std::size_t min_cells = 20;
constexpr int max_half_periods = 7;
/** Waves need not be level at the border of the image, where cosines are: they are those of
 * an image that is larger by this part of its longer side on all sides. */
constexpr double margin = 0.1;
/** The standard deviation of the warp of inverse depth, in quadratic parts of the noise. */
constexpr double warp_in_noise = 2.;
constexpr double least_warp = 1e-6; // 1/m
/** The standard deviation of what planes change by, m of m * p = 1, in that of the warp:
 * large, for directions in which few points tell nothing. */
constexpr double change_in_warp = 10.;
/** Cells so many standard deviations of noise and warp from their planes are of others. */
constexpr double far_off = 5.;
/** Planes at right angles are so to about this, radians. */
constexpr double right_angle_deviation = 0.5 * M_PI / 180.;
/** What the warp may tilt planes at right angles by, radians. */
constexpr double max_right_angle_error = 4. * M_PI / 180.;
/** Waves shorter than those of the warp make the errors of so many cells alike. */
constexpr double cells_alike = 30.;
/** Planes with fewer tell no angles: their edges tilt them. */
constexpr std::size_t min_cells_for_angles = 150;

double
warpDeviation (const DepthNoise& noise)
{
  return std::max (warp_in_noise * static_cast<double> (noise.quadratic), least_warp);
}

/** Errors of neighbours are alike: the mean of a cell is not much better than they are. */
double
inverseDepthDeviation (double inverse_depth, const DepthNoise& noise)
{
  return noise.constant * inverse_depth * inverse_depth + noise.quadratic;
}

/** cos (i pi t) of up to \a max_i half periods, t from 0 to 1 over the image and its
 * margins, at the middles of \a number squares of \a size pixels. */
Eigen::MatrixXd
cosines (int max_i, int number, int size, int pixels, double margin_px)
{
  Eigen::MatrixXd result (max_i + 1, number);
  for (int k = 0; k < number; ++k) {
    const double t = ((k + 0.5) * size + margin_px) / (pixels + 2. * margin_px);
    for (int i = 0; i <= max_i; ++i)
      result (i, k) = std::cos (i * M_PI * t);
  }
  return result;
}

} // namespace

void
DepthWarp::clear()
{
  frames_ = 0;
  known_ = false;
}

void
DepthWarp::setImage (const Eigen::MatrixXf& image)
{
  resize (static_cast<int> (image.rows()), static_cast<int> (image.cols()));
  image_ = image;
  frames_ = 0;
  known_ = true;
}

bool
DepthWarp::add (const OrganizedPoints& points,
                const std::vector<std::uint32_t>& plane_of,
                const PlaneVectors& planes,
                const DepthNoise& noise,
                bool right_angles)
{
  resize (points.width, points.height);
  collectCells (points, plane_of, planes, noise);
  if (!areNear (planes, noise))
    return false;
  const bool tells_nothing =
      std::all_of (planes_.begin(), planes_.end(), [] (const PlaneSums& sums) {
        return sums.cells < min_cells;
      });
  if (known_ && frames_ == 0 && tells_nothing) // the warp that was set stays
    return true;
  if (frames_ > 0 && (tells_nothing || isSameView (noise))) {
    ++frames_;
    return true;
  }
  try {
    addEquations (planes, noise, right_angles);
    solve (noise);
    view_ = cells_;
  }
  catch (...) { // without memory: half of the equations are wrong ones
    clear();
    throw;
  }
  return true;
}

void
DepthWarp::addEquations (const PlaneVectors& planes,
                         const DepthNoise& noise,
                         bool right_angles)
{
  if (frames_ == 0) {
    const auto count = static_cast<Eigen::Index> (waves_.size());
    squares_.setZero (count, count);
    right_.setZero (count);
  }
  ++frames_;
  sumUp (planes, noise);
  addProductsOfWaves();
  eliminatePlanes (planes);
  if (right_angles)
    addRightAngles();
}

void
DepthWarp::resize (int width, int height)
{
  if (width == width_ && height == height_)
    return;
  // Where there is no memory for another size, Eigen gives up the old memory twice.
  *this = DepthWarp();
  const int longer = std::max (width, height);
  cell_size_ = std::max (longer / cells_in_line, 1);
  const double margin_px = margin * longer;
  // Products of two waves have up to twice their half periods.
  const auto ofCells = [&] (int pixels) {
    return cosines (
        2 * max_half_periods, pixels / cell_size_, cell_size_, pixels, margin_px);
  };
  const auto ofPixels = [&] (int pixels) -> Eigen::MatrixXf {
    return cosines (max_half_periods, pixels, 1, pixels, margin_px).cast<float>();
  };
  row_cosines_ = ofCells (width);
  column_cosines_ = ofCells (height);
  pixel_row_cosines_ = ofPixels (width);
  pixel_column_cosines_ = ofPixels (height);
  waves_.clear();
  double sum = 0.;
  for (int i = 0; i <= max_half_periods; ++i)
    for (int j = 0; j <= max_half_periods; ++j) {
      const double half_periods =
          std::hypot (static_cast<double> (i * longer) / width,
                      static_cast<double> (j * longer) / height);
      if (half_periods > max_half_periods)
        continue;
      waves_.push_back ({i, j, 1.});
      sum += (i ? 0.5 : 1.) * (j ? 0.5 : 1.); // the mean square of the cosines
    }
  for (Wave& wave : waves_)
    wave.variance /= sum;
  width_ = width;
  height_ = height;
}

double
DepthWarp::errorOf (const Cell& cell, const PlaneVectors& planes)
{
  return cell.inverse_depth - inverseDistance (planes[cell.plane]).dot (cell.ray);
}

/** Whether most cells are, to their planes. */
bool
DepthWarp::areNear (const PlaneVectors& planes, const DepthNoise& noise) const
{
  const double warp = warpDeviation (noise);
  const auto near =
      std::count_if (cells_.begin(), cells_.end(), [&] (const Cell& cell) {
        const double sigma = inverseDepthDeviation (cell.inverse_depth, noise) + warp;
        return std::abs (errorOf (cell, planes)) <= far_off * sigma;
      });
  return 2 * static_cast<std::size_t> (near) >= cells_.size();
}

/** Whether most cells are as in the last view that was added. Once more, the same errors of planes
 * and right angles would seem to be certain. */
bool
DepthWarp::isSameView (const DepthNoise& noise) const
{
  const auto isBefore = [] (const Cell& a, const Cell& b) {
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  };
  std::size_t same = 0;
  auto seen = view_.begin();
  for (const Cell& cell : cells_) {
    seen = std::lower_bound (seen, view_.end(), cell, isBefore);
    if (seen == view_.end())
      break;
    same += !isBefore (cell, *seen) &&
            std::abs (cell.inverse_depth - seen->inverse_depth) <=
                inverseDepthDeviation (cell.inverse_depth, noise);
  }
  return 4 * same >= 3 * std::max (cells_.size(), view_.size());
}

void
DepthWarp::sumUp (const PlaneVectors& planes, const DepthNoise& noise)
{
  const auto count = static_cast<Eigen::Index> (waves_.size());
  const double change = change_in_warp * warpDeviation (noise);
  for (PlaneSums& sums : planes_) {
    sums.squares = Eigen::Matrix3d::Identity() / (change * change);
    sums.right.setZero();
    sums.waves.setZero (3, count);
  }
  weights_.setZero (column_cosines_.cols(), row_cosines_.cols());
  Eigen::VectorXd waves (count);
  for (const Cell& cell : cells_) {
    PlaneSums& sums = planes_[cell.plane];
    if (sums.cells < min_cells)
      continue;
    for (Eigen::Index k = 0; k < count; ++k)
      waves[k] = row_cosines_ (waves_[k].along_row, cell.column) *
                 column_cosines_ (waves_[k].along_column, cell.row);
    const double sigma = inverseDepthDeviation (cell.inverse_depth, noise);
    const double weight = 1. / (sigma * sigma);
    const double error = errorOf (cell, planes);
    weights_ (cell.row, cell.column) = weight;
    right_ += weight * error * waves;
    sums.squares += weight * cell.ray * cell.ray.transpose();
    sums.right += weight * error * cell.ray;
    sums.waves.noalias() += weight * cell.ray * waves.transpose();
  }
}

/** Products of cosines are sums of cosines, so the cosine transform of the weights has the
 * sums over all cells. */
void
DepthWarp::addProductsOfWaves()
{
  const Eigen::MatrixXd sums = column_cosines_ * weights_ * row_cosines_.transpose();
  for (std::size_t k = 0; k < waves_.size(); ++k)
    for (std::size_t l = 0; l <= k; ++l) {
      const Wave &a = waves_[k], &b = waves_[l];
      const int u = a.along_row + b.along_row, v = a.along_column + b.along_column,
                du = std::abs (a.along_row - b.along_row),
                dv = std::abs (a.along_column - b.along_column);
      squares_ (k, l) +=
          0.25 * (sums (v, u) + sums (v, du) + sums (dv, u) + sums (dv, du));
    }
}

/** Leaves as many equations as waves. */
void
DepthWarp::eliminatePlanes (const PlaneVectors& planes)
{
  normals_.clear();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const PlaneSums& sums = planes_[k];
    if (sums.cells < min_cells)
      continue;
    const Eigen::Matrix3d covariance = sums.squares.inverse();
    const Eigen::Matrix<double, 3, Eigen::Dynamic> weighed = covariance * sums.waves;
    squares_.triangularView<Eigen::Lower>() -= sums.waves.transpose() * weighed;
    right_.noalias() -= weighed.transpose() * sums.right;
    if (sums.cells < min_cells_for_angles)
      continue;
    const Eigen::Vector3d best = inverseDistance (planes[k]) + covariance * sums.right;
    const double norm = best.norm();
    normals_.push_back ({best / norm, covariance / (norm * norm), weighed / -norm});
  }
}

/** For each pair of normals the cosine that is to be 0, which is linear in the amplitudes of the
 * waves. */
void
DepthWarp::addRightAngles()
{
  const double max_cosine = std::sin (max_right_angle_error);
  const double variance = right_angle_deviation * right_angle_deviation;
  for (std::size_t k = 0; k < normals_.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      const Normal &a = normals_[k], &b = normals_[l];
      const double cosine = a.unit.dot (b.unit);
      if (!(std::abs (cosine) < max_cosine)) // NaN, too
        continue;
      const Eigen::VectorXd change =
          a.change.transpose() * b.unit + b.change.transpose() * a.unit;
      const double weight =
          1. / (variance + cells_alike * (b.unit.dot (a.covariance * b.unit) +
                                          a.unit.dot (b.covariance * a.unit)));
      squares_.selfadjointView<Eigen::Lower>().rankUpdate (change, weight);
      right_ -= weight * cosine * change;
    }
}

void
DepthWarp::solve (const DepthNoise& noise)
{
  const double warp = warpDeviation (noise);
  Eigen::MatrixXd squares = squares_;
  for (std::size_t k = 0; k < waves_.size(); ++k)
    squares (k, k) += 1. / (waves_[k].variance * warp * warp);
  const Eigen::VectorXd amplitudes =
      squares.selfadjointView<Eigen::Lower>().llt().solve (right_);
  constexpr int number = max_half_periods + 1;
  Eigen::MatrixXf spectrum = Eigen::MatrixXf::Zero (number, number);
  for (std::size_t k = 0; k < waves_.size(); ++k)
    spectrum (waves_[k].along_row, waves_[k].along_column) =
        static_cast<float> (amplitudes[k]);
  image_.noalias() = pixel_row_cosines_.transpose() * spectrum * pixel_column_cosines_;
  known_ = true;
}

} // namespace rgbd_planes
} // namespace pcl
