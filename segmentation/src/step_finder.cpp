// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "step_kernels.h"

#include <pcl/features/impl/row_ring.h>
#include <pcl/segmentation/impl/step_finder.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Errors jump by so much at an edge, and by so much in the mean of so many places or more
 * along a step. */
constexpr float min_edge = 1.f, min_jump = 1.4f;
constexpr std::size_t min_places = 4;
constexpr LineLimits limits{min_places * min_edge, min_jump, min_places};
/** Between the rows of the grid. More samples beside a place are not looked at, nor do vectors
 * reach farther. */
constexpr std::size_t margin = RowRing<float>::lanes;
/** The shift of the surface behind a step. */
constexpr double min_height = 1.6;
/** By how many samples the ends of a line are moved to where they fit best. */
constexpr float moves[] = {0.f, -1.f, -0.5f, 0.5f, 1.f};
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
  findExtent (samples);
  lines_.clear();
  for (const bool is_steep : {false, true}) {
    layOut (samples, is_steep);
    findEdges();
    findLines (is_steep);
  }
  if (lines_.empty())
    return false;
  fitSurface (samples);
  const double least = (1. - max_left * max_left) * squares_;
  double most = least;
  for (const GridLine& line : lines_)
    if (const double gain = shiftBehind (line, samples.size(), min_side).gain;
        gain > most) {
      most = gain;
      step = line;
    }
  return most > least && refine (step, samples.size(), min_side).isHigh();
}

std::size_t
StepFinder::place (int along, int across) const
{
  return margin + static_cast<std::size_t> (along) * stride_ +
         static_cast<std::size_t> (across);
}

void
StepFinder::findExtent (const std::vector<SampleError>& samples)
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
}

void
StepFinder::layOut (const std::vector<SampleError>& samples, bool is_steep)
{
  const int across = is_steep ? 0 : 1, along = 1 - across;
  width_ = last_[across] - first_[across] + 1;
  height_ = last_[along] - first_[along] + 1;
  stride_ = static_cast<std::size_t> (RowRing<float>::roundUp (width_)) + margin;
  const std::size_t end = margin + stride_ * static_cast<std::size_t> (height_);
  errors_.assign (end + margin, 0.f);
  own_.assign (end + margin, 0.f);
  jumps_.resize (end + margin);
  for (const SampleError& sample : samples) {
    const int at[] = {sample.u - first_[0], sample.v - first_[1]};
    errors_[place (at[along], at[across])] = sample.error;
    own_[place (at[along], at[across])] = 1.f;
  }
}

void
StepFinder::findEdges()
{
  const std::size_t end = margin + stride_ * static_cast<std::size_t> (height_);
  findJumps (errors_.data(), own_.data(), margin, end, jumps_.data());
  places_.resize (end);
  const std::size_t count =
      findPeaks (jumps_.data(), margin, end, min_edge, places_.data());
  edges_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t> (places_[i]);
    edges_.push_back ({static_cast<int> ((place - margin) / stride_),
                       static_cast<int> ((place - margin) % stride_),
                       jumps_[place]});
  }
}

/** Adds the lines with enough edges along which errors jump. */
void
StepFinder::findLines (bool is_steep)
{
  if (edges_.size() < min_places)
    return;
  const int length = edges_.back().along - edges_.front().along;
  const float middle =
      0.5f * static_cast<float> (edges_.front().along + edges_.back().along);
  const int slopes = length / 2 + 1;
  // Lines are numbered by where they cross the middle, from the first that may meet the grid.
  const int across = is_steep ? 0 : 1;
  const int height = height_; // not a member, which what is written might change
  const int first = first_[across] - height;
  const float origin = middle + static_cast<float> (first_[1 - across]);
  votes_.resize (
      static_cast<std::size_t> (RowRing<float>::roundUp (width_ + 2 * height_)));
  found_.resize (votes_.size());
  starts_.resize (static_cast<std::size_t> (height_));
  for (int k = -slopes; k <= slopes; ++k) {
    const float slope = static_cast<float> (k) / static_cast<float> (slopes);
    for (int along = 0; along < height; ++along) {
      const float at = slope * (static_cast<float> (along) - middle);
      starts_[static_cast<std::size_t> (along)] =
          2 * height - static_cast<int> (at + static_cast<float> (height));
    }
    std::fill (votes_.begin(), votes_.end(), 0.f);
    for (const Edge& edge : edges_) {
      const int line = edge.across + starts_[static_cast<std::size_t> (edge.along)];
      votes_[static_cast<std::size_t> (line)] += edge.jump;
    }
    const std::size_t count = rgbd_planes::findLines (jumps_.data() + margin,
                                                      width_,
                                                      stride_,
                                                      starts_,
                                                      votes_,
                                                      limits,
                                                      found_.data());
    for (std::size_t i = 0; i < count; ++i)
      lines_.push_back (
          {is_steep, slope, static_cast<float> (found_[i] + first) - slope * origin});
  }
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

/** Where the surface behind the line is shifted, and all of it fitted anew. */
StepFinder::Shift
StepFinder::shiftBehind (const GridLine& line,
                         std::size_t samples,
                         std::size_t min_side) const
{
  float sums[7];
  sumBehind (surface_, line, sums);
  const auto behind = static_cast<std::size_t> (sums[0]);
  if (behind < min_side || samples - behind < min_side)
    return {};
  const Eigen::Matrix<double, 7, 1> terms =
      Eigen::Map<Eigen::Matrix<float, 7, 1>> (sums).cast<double>();
  const double left = fitted_.dot (terms);
  const double free = sums[0] - terms.head<6>().dot (inverse_ * terms.head<6>());
  return free >= 1. ? Shift{left / free, left * left / free} : Shift{};
}

/** Moves the ends of a line, which was found to a sample, to where it explains most. */
StepFinder::Shift
StepFinder::refine (GridLine& line, std::size_t samples, std::size_t min_side) const
{
  const int along = line.is_steep ? 1 : 0;
  const auto first = static_cast<float> (first_[along]);
  const auto length = static_cast<float> (last_[along] - first_[along]);
  const GridLine found = line;
  Shift best;
  for (const float at_first : moves)
    for (const float at_last : moves) {
      const float turn = (at_last - at_first) / length;
      const GridLine moved{
          found.is_steep, found.slope + turn, found.offset + at_first - turn * first};
      const Shift shift = shiftBehind (moved, samples, min_side);
      if (shift.gain > best.gain) {
        best = shift;
        line = moved;
      }
    }
  return best;
}

bool
StepFinder::Shift::isHigh() const
{
  return std::abs (height) >= min_height;
}

} // namespace rgbd_planes
} // namespace pcl
