// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_images.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace tangent_images;

namespace {

/** Section 3 of the paper with tangents between neighbouring cells, straight from the
 * definition, in double: no integral images, no vectors, no rounding. */
class BruteForce {
public:
  BruteForce (const Image& image, int step, int half_width, int half_height)
  : image_ (image)
  , step_ (step)
  , half_width_ (half_width)
  , half_height_ (half_height)
  , cells_u_ ((image.width + step - 1) / step)
  , cells_v_ ((image.height + step - 1) / step)
  {
    for (int y = 0; y < cells_v_; ++y)
      for (int x = 0; x < cells_u_; ++x)
        cells_.push_back (makeCell (x, y));
  }

  /** The normal of a pixel; NaN if there is none. */
  Eigen::Vector3d
  normal (int u, int v) const
  {
    const Eigen::Vector3d none =
        Eigen::Vector3d::Constant (std::numeric_limits<double>::quiet_NaN());
    if (!measured (u, v))
      return none;
    const int x = u / step_, y = v / step_;
    const Eigen::Vector3d horizontal = sum (
        x - half_width_, x + half_width_ - 1, y - half_height_, y + half_height_, 1);
    const Eigen::Vector3d vertical = sum (
        x - half_width_, x + half_width_, y - half_height_, y + half_height_ - 1, 0);
    const Eigen::Vector3d n = horizontal.cross (vertical);
    if (n.norm() <= 1e-4 * horizontal.norm() * vertical.norm())
      return none;
    return n.dot (cell (x, y).point) > 0. ? (-n).normalized() : n.normalized();
  }

private:
  struct Cell {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double range = std::numeric_limits<double>::infinity();
  };

  bool
  measured (int u, int v) const
  {
    return u < image_.width && v < image_.height && image_ (u, v).allFinite() &&
           !image_ (u, v).isZero (0.f);
  }

  static double
  gate (double range)
  {
    return 3.5 * (0.001 + 0.002 * range * range);
  }

  /** The mean of the pixels that are no further behind the nearest one than noise explains. */
  Cell
  makeCell (int x, int y) const
  {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < step_ * step_; ++k)
      if (measured (x * step_ + k % step_, y * step_ + k / step_))
        points.push_back (
            image_ (x * step_ + k % step_, y * step_ + k / step_).cast<double>());
    Cell nearest, sum{Eigen::Vector3d::Zero(), 0.};
    for (const auto& point : points)
      nearest.range = std::min (nearest.range, point.norm());
    double number = 0.;
    for (const auto& point : points)
      if (point.norm() - nearest.range < gate (nearest.range)) {
        sum.point += point;
        sum.range += point.norm();
        ++number;
      }
    return number > 0. ? Cell{sum.point / number, sum.range / number} : nearest;
  }

  Cell
  cell (int x, int y) const
  {
    return x < cells_u_ && y < cells_v_
               ? cells_[static_cast<std::size_t> (y * cells_u_ + x)]
               : Cell();
  }

  /** By how much more or less the range changes from the first to the second of four cells than
   * between the next ones. */
  double
  stepBetween (int x, int y, int dx, int dy) const
  {
    const auto change = [&] (int k) {
      return cell (x + (k + 1) * dx, y + (k + 1) * dy).range -
             cell (x + k * dx, y + k * dy).range;
    };
    return std::max (std::abs (change (1) - change (0)),
                     std::abs (change (1) - change (2)));
  }

  /** From a cell to its neighbour, if both see the same surface. */
  Eigen::Vector3d
  tangent (int x, int y, int dx, int dy) const
  {
    const Cell from = cell (x, y), to = cell (x + dx, y + dy);
    if (std::isinf (from.range) || std::isinf (to.range))
      return Eigen::Vector3d::Zero();
    const Eigen::Vector3d d = to.point - from.point;
    const double change = to.range - from.range;
    const double noise = gate (from.range), slope = 4. * 4.;
    const bool is_one =
        (stepBetween (x, y, dx, dy) <= noise ||
         (1. + slope) * change * change <= noise * noise + slope * d.squaredNorm()) &&
        std::abs (change) <= 2. * step_ * 0.02 * (from.range + 1.);
    return is_one ? d : Eigen::Vector3d::Zero();
  }

  /** Each tangent is divided by the range of its cell. */
  Eigen::Vector3d
  sum (int left, int right, int top, int bottom, int dx) const
  {
    Eigen::Vector3d all = Eigen::Vector3d::Zero();
    for (int y = std::max (top, 0); y <= std::min (bottom, cells_v_ - 1); ++y)
      for (int x = std::max (left, 0); x <= std::min (right, cells_u_ - 1); ++x)
        if (const Eigen::Vector3d d = tangent (x, y, dx, 1 - dx); !d.isZero (0.))
          all += d / cell (x, y).range;
    return all;
  }

  const Image& image_;
  int step_, half_width_, half_height_, cells_u_, cells_v_;
  std::vector<Cell> cells_;
};

/** How many points have a normal. */
int
expectTheDefinition (const Image& image, int step, int half_width, int half_height)
{
  const ImageNormals normals =
      compute (image, plain (2 * step * half_width, 2 * step * half_height));
  const BruteForce oracle (image, step, half_width, half_height);
  int valid = 0;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const Eigen::Vector3f n = normals[image.index (u, v)].head<3>();
      const Eigen::Vector3f expected = oracle.normal (u, v).cast<float>();
      const bool agree =
          expected.hasNaN() ? n.array().isNaN().all() : (n - expected).norm() <= 1e-4f;
      EXPECT_TRUE (agree) << "at " << u << ", " << v << " of " << image.width << " x "
                          << image.height << ", areas " << half_width << ", "
                          << half_height << ": " << n.transpose() << " and not "
                          << expected.transpose();
      valid += !expected.hasNaN();
    }
  return valid;
}

} // namespace

TEST (TangentNormalDefinition, OfPixels)
{
  for (const auto& size : {std::pair (1, 1),
                           {1, 2},
                           {2, 1},
                           {2, 2},
                           {3, 5},
                           {2, 40},
                           {41, 2},
                           {31, 23},
                           {67, 8},
                           {67, 67}}) {
    const auto [width, height] = size;
    const Image image = roughImage (width, height, 5);
    for (const auto& half : {std::pair (2, 4), {5, 1}, {3, 3}}) {
      const int valid = expectTheDefinition (
          image, 1, std::min (half.first, width), std::min (half.second, height));
      if (std::min (width, height) == 1) {
        EXPECT_EQ (valid, 0);
      }
      else if (width * height > 40) {
        EXPECT_GT (valid, width * height / 2) << width << " x " << height;
      }
    }
  }
}

/** Images of 480 x 96 pixels and more, with odd and even numbers of columns and rows. */
TEST (TangentNormalDefinition, OfCellsOfFourPixels)
{
  for (const auto& size : {std::pair (480, 96), {97, 481}, {483, 99}}) {
    const Image image = roughImage (size.first, size.second, 6);
    for (const auto& half : {std::pair (2, 3), {4, 1}})
      expectTheDefinition (
          image, 2, half.first, std::min (half.second, (size.second + 1) / 2));
  }
}
