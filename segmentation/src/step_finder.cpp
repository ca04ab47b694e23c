// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "step_kernels.h"

#include <pcl/features/row_ring.h>
#include <pcl/segmentation/step_finder.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Errors jump by so much at an edge, and by so much in the mean of so many places or more
 * along a step. */
constexpr float min_edge = 1.f, min_jump = 1.4f;
constexpr std::size_t min_places = 4;
constexpr float min_votes = min_places * min_edge;
/** The shift of the surface behind a step. */
constexpr double min_height = 1.6;
/** Where samples that fill up a vector are: behind no line. */
constexpr float nowhere = -std::numeric_limits<float>::infinity();

using Products = Eigen::Matrix<double, 6, 6>;

} // namespace

bool
StepFinder::find (const std::vector<SampleError>& samples,
                  std::size_t min_side,
                  GridLine& step,
                  double max_left)
{
  if (samples.size() < min_places)
    return false;
  layOut (samples);
  lines_.clear();
  for (const bool is_steep : {false, true}) {
    findEdges (samples, is_steep);
    findLines (is_steep);
  }
  if (lines_.empty())
    return false;
  fitSurface (samples);
  double most = 0.;
  for (const GridLine& line : lines_) {
    const double gain = gainOf (line, samples.size(), min_side);
    if (gain > most) {
      most = gain;
      step = line;
    }
  }
  return most > (1. - max_left * max_left) * squares_;
}

void
StepFinder::layOut (const std::vector<SampleError>& samples)
{
  for (const int k : {0, 1}) {
    first_[k] = std::numeric_limits<int>::max();
    last_[k] = -1;
  }
  for (const SampleError& sample : samples) {
    const int at[] = {sample.u, sample.v};
    for (const int k : {0, 1}) {
      first_[k] = std::min (first_[k], at[k]);
      last_[k] = std::max (last_[k], at[k]);
    }
  }
  stride_ = last_[0] - first_[0] + 1 + 2 * margin;
  const int rows = last_[1] - first_[1] + 1 + 2 * margin;
  for (auto* values : {&errors_, &own_, &jumps_})
    values->assign (static_cast<std::size_t> (stride_ * rows) + RowRing<float>::lanes,
                    0.f);
  for (const SampleError& sample : samples) {
    errors_[place (sample.u, sample.v)] = sample.error;
    own_[place (sample.u, sample.v)] = 1.f;
  }
}

void
StepFinder::findEdges (const std::vector<SampleError>& samples, bool is_steep)
{
  const std::size_t across = is_steep ? 1 : static_cast<std::size_t> (stride_);
  findJumps (errors_.data(),
             own_.data(),
             place (first_[0], first_[1]),
             place (last_[0], last_[1]) + 1,
             across,
             jumps_.data());
  for (auto* values : {&edges_.along, &edges_.across, &edges_.jump})
    values->clear();
  for (const SampleError& sample : samples) {
    const std::size_t at = place (sample.u, sample.v);
    const float jump = std::abs (jumps_[at]);
    if (jump >= min_edge && jump >= std::abs (jumps_[at - across]) &&
        jump > std::abs (jumps_[at + across])) {
      edges_.along.push_back (static_cast<float> (is_steep ? sample.v : sample.u));
      edges_.across.push_back (static_cast<float> (is_steep ? sample.u : sample.v));
      edges_.jump.push_back (jumps_[at]);
    }
  }
}

/** Adds the lines with enough edges along which errors jump. */
void
StepFinder::findLines (bool is_steep)
{
  if (edges_.size() < min_places)
    return;
  const auto ends = std::minmax_element (edges_.along.begin(), edges_.along.end());
  const float middle = 0.5f * (*ends.first + *ends.second);
  const auto length = static_cast<int> (*ends.second - *ends.first);
  const int across = is_steep ? 0 : 1;
  const int first_bin = first_[across] - length;
  votes_.assign (static_cast<std::size_t> (last_[across] - first_bin + length + 2),
                 0.f);
  edges_.bin.resize (edges_.size());
  const int slopes = length / 2 + 1;
  for (int k = -slopes; k <= slopes; ++k) {
    const float slope = static_cast<float> (k) / static_cast<float> (slopes);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      // Where a line through the edge is in the middle, rounded up.
      const float at_middle = edges_.across[i] - static_cast<float> (first_bin) -
                              slope * (edges_.along[i] - middle);
      const auto whole = static_cast<int> (at_middle);
      edges_.bin[i] = whole + (at_middle > static_cast<float> (whole) ? 1 : 0);
    }
    float most = 0.f;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      float& votes = votes_[static_cast<std::size_t> (edges_.bin[i])];
      votes += edges_.jump[i];
      most = std::max (most, std::abs (votes));
    }
    if (most < min_votes) {
      std::fill (votes_.begin(), votes_.end(), 0.f);
      continue;
    }
    for (const int bin : edges_.bin) {
      const float votes = std::exchange (votes_[static_cast<std::size_t> (bin)], 0.f);
      if (!(std::abs (votes) >= min_votes))
        continue;
      const GridLine line{
          is_steep, slope, static_cast<float> (bin + first_bin) - slope * middle};
      if (jumpsAlong (line))
        lines_.push_back (line);
    }
  }
}

bool
StepFinder::jumpsAlong (const GridLine& line) const
{
  const int k = line.is_steep ? 1 : 0;
  const auto first = static_cast<float> (first_[1 - k]),
             last = static_cast<float> (last_[1 - k] + 1);
  const auto acrossAt = [&line] (int along) {
    return line.slope * static_cast<float> (along) + line.offset;
  };
  const auto isInside = [&] (int along) {
    return acrossAt (along) >= first && acrossAt (along) < last;
  };
  int begin = first_[k], end = last_[k] + 1;
  if (line.slope != 0.f) { // The line enters and leaves the grid here, or beside.
    const auto [enters, leaves] = std::minmax (
        {(first - line.offset) / line.slope, (last - line.offset) / line.slope});
    begin = std::max (begin, static_cast<int> (enters) - 1);
    end = std::min (end, static_cast<int> (leaves) + 2);
  }
  while (begin < end && !isInside (begin))
    ++begin;
  while (begin < end && !isInside (end - 1))
    --end;
  const int along_step = line.is_steep ? stride_ : 1,
            across_step = line.is_steep ? 1 : stride_;
  const int origin = (margin - first_[1]) * stride_ + margin - first_[0];
  float sum = 0.f;
  int places = 0;
  for (int along = begin; along < end; ++along) {
    const int across = static_cast<int> (acrossAt (along));
    const float jump = jumps_[static_cast<std::size_t> (origin + along * along_step +
                                                        across * across_step)];
    sum += jump;
    places += jump != 0.f;
  }
  return places >= static_cast<int> (min_places) &&
         std::abs (sum) >= min_jump * static_cast<float> (places);
}

void
StepFinder::fitSurface (const std::vector<SampleError>& samples)
{
  const auto size = static_cast<std::size_t> (
      RowRing<float>::roundUp (static_cast<int> (samples.size())));
  surface_.columns.assign (size, nowhere);
  surface_.rows.assign (size, nowhere);
  for (auto* values : {&surface_.u, &surface_.v, &surface_.errors})
    values->assign (size, 0.f);
  const auto scaled = [this] (int value, int k) {
    return static_cast<float> (2 * value - first_[k] - last_[k]) /
           static_cast<float> (last_[k] - first_[k] + 1);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    surface_.columns[i] = static_cast<float> (samples[i].u);
    surface_.rows[i] = static_cast<float> (samples[i].v);
    surface_.u[i] = scaled (samples[i].u, 0);
    surface_.v[i] = scaled (samples[i].v, 1);
    surface_.errors[i] = samples[i].error;
  }
  float sums[7][7];
  sumProducts (surface_, sums);
  const Eigen::Matrix<double, 7, 7> products =
      Eigen::Map<Eigen::Matrix<float, 7, 7>> (*sums).cast<double>();
  // Samples on a curve of second order determine no surface.
  inverse_ = (products.topLeftCorner<6, 6>() + 1e-6 * Products::Identity()).inverse();
  fitted_ << -inverse_ * products.topRightCorner<6, 1>(), 1.;
  squares_ = fitted_.dot (products * fitted_);
}

/** By how much the sum of the squares of the errors falls when the surface behind the
 * line is shifted, and all of it fitted anew; 0 where it is shifted by too little. */
double
StepFinder::gainOf (const GridLine& line,
                    std::size_t samples,
                    std::size_t min_side) const
{
  float sums[7];
  sumBehind (surface_, line, sums);
  const auto behind = static_cast<std::size_t> (sums[0]);
  if (behind < min_side || samples - behind < min_side)
    return 0.;
  const Eigen::Matrix<double, 7, 1> terms =
      Eigen::Map<Eigen::Matrix<float, 7, 1>> (sums).cast<double>();
  const double left = fitted_.dot (terms);
  const double free = sums[0] - terms.head<6>().dot (inverse_ * terms.head<6>());
  const double height = left / free;
  return free >= 1. && std::abs (height) >= min_height ? left * height : 0.;
}

} // namespace rgbd_planes
} // namespace pcl
