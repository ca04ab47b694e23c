// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_images.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace tangent_images;

namespace {

/** Section 3 of the paper with tangents between neighbouring pixels, straight from the
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
  {}

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
    return n.dot (cellPoint (x, y)) > 0. ? (-n).normalized() : n.normalized();
  }

private:
  bool
  measured (int u, int v) const
  {
    return u < image_.width && v < image_.height && image_ (u, v).allFinite() &&
           !image_ (u, v).isZero (0.f);
  }

  Eigen::Vector3d
  point (int u, int v) const
  {
    return image_ (u, v).cast<double>();
  }

  /** The first point of the cell row by row; zero if all are missing. */
  Eigen::Vector3d
  cellPoint (int x, int y) const
  {
    for (int k = 0; k < step_ * step_; ++k)
      if (measured (x * step_ + k % step_, y * step_ + k / step_))
        return point (x * step_ + k % step_, y * step_ + k / step_);
    return Eigen::Vector3d::Zero();
  }

  double
  range (int u, int v) const
  {
    return measured (u, v) ? point (u, v).norm()
                           : std::numeric_limits<double>::infinity();
  }

  /** By how much more or less the range changes from the second to the third of four pixels than
   * before or behind. Of a cell of four: by how much more it changes from a pixel to its neighbour
   * than two pixels further on, in the mean of both rows or columns of the cell. */
  double
  stepBetween (int u, int v, int du, int dv) const
  {
    const auto change = [&] (int k) {
      return range (u + (k + 1) * du, v + (k + 1) * dv) -
             range (u + k * du, v + k * dv);
    };
    if (step_ == 1)
      return std::max (std::abs (change (1) - change (0)),
                       std::abs (change (1) - change (2)));
    double sum = 0.;
    for (const int line : {0, 1}) {
      const int x = du == 1 ? u : u / 2 * 2 + line, y = dv == 1 ? v : v / 2 * 2 + line;
      sum += range (x + du, y + dv) - range (x, y) -
             (range (x + 3 * du, y + 3 * dv) - range (x + 2 * du, y + 2 * dv));
    }
    return std::abs (sum) / 2.;
  }

  /** Of the pixel, or of the cell of four. */
  double
  nearest (int u, int v) const
  {
    if (step_ == 1)
      return range (u, v);
    const int x = u / 2 * 2, y = v / 2 * 2;
    return std::min (
        {range (x, y), range (x + 1, y), range (x, y + 1), range (x + 1, y + 1)});
  }

  /** From a pixel to its neighbour, if both see the same surface. */
  Eigen::Vector3d
  tangent (int u, int v, int du, int dv) const
  {
    if (!measured (u, v) || !measured (u + du, v + dv))
      return Eigen::Vector3d::Zero();
    const Eigen::Vector3d d = point (u + du, v + dv) - point (u, v);
    const double from = range (u, v), change = range (u + du, v + dv) - from;
    const double near = nearest (u, v);
    const double gate = 3.5 * (0.001 + 0.002 * near * near), slope = 4. * 4.;
    const bool is_one =
        (stepBetween (u, v, du, dv) <= gate ||
         (1. + slope) * change * change <= gate * gate + slope * d.squaredNorm()) &&
        std::abs (change) <= 2. * 0.02 * (from + 1.);
    return is_one ? d : Eigen::Vector3d::Zero();
  }

  /** Over the pixels of cells, where each cell is divided by the range of its point. */
  Eigen::Vector3d
  sum (int left, int right, int top, int bottom, int du) const
  {
    Eigen::Vector3d all = Eigen::Vector3d::Zero();
    for (int y = std::max (top, 0); y <= std::min (bottom, cells_v_ - 1); ++y)
      for (int x = std::max (left, 0); x <= std::min (right, cells_u_ - 1); ++x)
        for (int k = 0; k < step_ * step_; ++k) {
          const Eigen::Vector3d d =
              tangent (x * step_ + k % step_, y * step_ + k / step_, du, 1 - du);
          if (!d.isZero (0.))
            all += d / cellPoint (x, y).norm();
        }
    return all;
  }

  const Image& image_;
  int step_, half_width_, half_height_, cells_u_, cells_v_;
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

/** Images of 480 columns and more, with odd and even numbers of columns and rows. */
TEST (TangentNormalDefinition, OfCellsOfFourPixels)
{
  for (const auto& size : {std::pair (480, 2), {481, 1}, {500, 9}, {483, 12}}) {
    const Image image = roughImage (size.first, size.second, 6);
    for (const auto& half : {std::pair (2, 3), {4, 1}})
      expectTheDefinition (
          image, 2, half.first, std::min (half.second, (size.second + 1) / 2));
  }
}
