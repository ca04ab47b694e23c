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

/** \brief Samples of a plane, as many as fill vectors: columns and rows, -infinity where there
 * is none, the same from -1 to 1 as u and v, and errors. */
struct SurfaceSamples {
  std::vector<float> columns, rows, u, v, errors;
};

/** \brief Finds steps in the errors of a plane: straight lines at which two surfaces meet
 * of which one lies behind the other.
 *
 * The errors of a warped surface are smooth, and noise averages out. So a step is a line
 * along which the mean errors of a few samples on both sides differ. Places where they do
 * vote for lines (Hough transform); of the lines with such places, the one counts with
 * which a surface of second order, and the same surface shifted behind the line, leave
 * the smallest errors. Votes know lines to a sample, so that one is moved to where it leaves
 * the smallest.
 */
class PCL_RGBD_PLANES_EXPORTS StepFinder {
public:
  /** \brief Finds the step that explains most.
   * \param[in] samples those of one plane
   * \param[in] min_side the least number of samples on either side
   * \param[out] step where it is
   * \param[in] max_left what it leaves of the root mean square of the errors, at most
   * \return whether there is one
   */
  bool
  find (const std::vector<SampleError>& samples,
        std::size_t min_side,
        GridLine& step,
        double max_left);

private:
  /** A place of the grid where errors jump, from its first row on and from the first place
   * in a row. */
  struct Edge {
    int along, across;
    float jump;
  };

  /** By how much the surface is shifted behind a line, and by how much less the sum of the
   * squares of the errors is then. */
  struct Shift {
    double height = 0., gain = 0.;

    bool
    isHigh () const;
  };

  void
  findExtent (const std::vector<SampleError>& samples);

  void
  layOut (const std::vector<SampleError>& samples, bool is_steep);

  void
  findEdges ();

  void
  findLines (bool is_steep);

  void
  fitSurface (const std::vector<SampleError>& samples);

  Shift
  shiftBehind (const GridLine& line, std::size_t samples, std::size_t min_side) const;

  Shift
  refine (GridLine& line, std::size_t samples, std::size_t min_side) const;

  std::size_t
  place (int along, int across) const;

  /** The first and last column and row of the samples. */
  int first_[2] = {0, 0}, last_[2] = {0, 0};
  /** Of the grid between these, whose rows lie across the lines: places in a row, rows, and from
   * one row to the next. */
  int width_ = 0, height_ = 0;
  std::size_t stride_ = 0;
  /** For each place of the grid: the error, 1 where there is one, and the difference
   * between the means before a line behind that place and behind it; else 0. */
  std::vector<float> errors_, own_, jumps_;
  std::vector<int> places_;
  std::vector<Edge> edges_;
  /** Of the lines of one slope: that of the first place in each row, the votes for each, and
   * those along which errors jump. */
  std::vector<int> starts_;
  std::vector<float> votes_;
  std::vector<int> found_;
  std::vector<GridLine> lines_;
  SurfaceSamples surface_;
  /** Of the surface of second order: the factors of 1, u, v, uu, uv, vv and the error with which
   * these add up to what it leaves of the error, the sum of the squares of that, and the inverse
   * of the sums of the products of the terms. */
  Eigen::Matrix<double, 7, 1> fitted_ = Eigen::Matrix<double, 7, 1>::Zero();
  double squares_ = 0.;
  Eigen::Matrix<double, 6, 6> inverse_ = Eigen::Matrix<double, 6, 6>::Zero();
};

} // namespace rgbd_planes
} // namespace pcl
