// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A sample of a plane: its column and row in the grid of samples, and how far it is
 * off the plane; about 1 for the noise of depth. */
struct SampleError {
  int u, v;
  float error;
  std::uint32_t sample;
};

/** \brief A straight line through the grid of samples: v = slope * u + offset, or
 * u = slope * v + offset. */
struct GridLine {
  bool is_steep = false;
  float slope = 0.f, offset = 0.f;

  bool
  isBehind (int u, int v) const
  {
    return is_steep ? static_cast<float> (u) > slope * static_cast<float> (v) + offset
                    : static_cast<float> (v) > slope * static_cast<float> (u) + offset;
  }
};

/** \brief Finds steps in the errors of a plane: straight lines at which two surfaces meet
 * of which one lies behind the other.
 *
 * The errors of a warped surface are smooth, and noise averages out. So a step is a line
 * along which the mean errors of a few samples on both sides differ. Places where they do
 * vote for lines (Hough transform); of the lines with such places, the one counts with
 * which a surface of second order, and the same surface shifted behind the line, leave
 * the smallest errors.
 */
class PCL_RGBD_PLANES_EXPORTS StepFinder {
public:
  /** \brief Sets the size of the grid of samples. */
  void
  resize (int width, int height);

  /** \brief Finds the step that explains most.
   * \param[in] samples those of one plane, with 0 <= u < width and 0 <= v < height
   * \param[in] min_side the least number of samples on either side
   * \param[out] step where it is
   * \return whether there is one
   */
  bool
  find (const std::vector<SampleError>& samples, std::size_t min_side, GridLine& step);

private:
  /** Of a surface of second order, at a sample: 1, u, v, uu, uv, vv, the error that the
   * surface leaves, and 0; or sums of these. */
  using Terms = Eigen::Array<float, 8, 1>;
  static constexpr int left = 6;

  /** Places of the grid where errors jump, in coordinates along lines and across, and for
   * each where a line through it is. */
  struct Edges {
    std::vector<float> along, across, jump;
    std::vector<int> bin;

    std::size_t
    size () const
    {
      return jump.size();
    }
  };

  void
  layOut (const std::vector<SampleError>& samples);

  void
  findEdges (const std::vector<SampleError>& samples, bool is_steep);

  void
  findLines (bool is_steep);

  bool
  jumpsAlong (const GridLine& line) const;

  void
  fitSurface (const std::vector<SampleError>& samples);

  double
  gainOf (const std::vector<SampleError>& samples,
          const GridLine& line,
          std::size_t min_side) const;

  std::size_t
  place (int u, int v) const
  {
    return static_cast<std::size_t> ((v + margin) * stride_ + u + margin);
  }

  static constexpr int margin = 5;
  int stride_ = 0;
  /** For each place of the grid: the error, 1 where there is one, and the difference
   * between the means before a line behind that place and behind it; else 0. */
  std::vector<float> errors_, own_, jumps_;
  /** The first and last column and row of the samples. */
  int first_[2] = {0, 0}, last_[2] = {0, 0};
  Edges edges_;
  std::vector<float> votes_;
  std::vector<GridLine> lines_;
  /** Of the surface of second order: its terms at each sample, the sum of the squares of
   * the errors that it leaves, and the inverse of the sum of the products of the terms. */
  std::vector<Terms> terms_;
  double squares_ = 0.;
  Eigen::Matrix<double, 6, 6> inverse_ = Eigen::Matrix<double, 6, 6>::Zero();
};

} // namespace rgbd_planes
} // namespace pcl
