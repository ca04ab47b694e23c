// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/step_finder.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Samples on either side of a line whose mean errors are compared, and how many of them
 * there must be: an edge of a table is only two or three samples thick. */
constexpr int depth = 4;
constexpr float min_in_depth = 2.f;
/** Errors jump by so much at an edge, and by so much in the mean of so many places or more
 * along a step. */
constexpr float min_edge = 1.f, min_jump = 1.4f;
constexpr int min_places = 4;
constexpr float min_votes = min_places * min_edge;
/** The shift of the surface behind a step, and what it leaves of the root mean square of
 * the errors. */
constexpr double min_height = 1.6, max_left = 0.95;

Eigen::Matrix<double, 6, 1>
surfaceTerms (const Eigen::Array<float, 8, 1>& terms)
{
  return terms.head<6>().cast<double>().matrix();
}

} // namespace

void
StepFinder::resize (int width, int height)
{
  const int stride = width + 2 * margin;
  const auto size = static_cast<std::size_t> (stride * (height + 2 * margin));
  if (stride == stride_ && size == errors_.size())
    return;
  stride_ = stride;
  for (auto* values : {&errors_, &own_, &jumps_})
    values->assign (size, 0.f);
}

bool
StepFinder::find (const std::vector<SampleError>& samples,
                  std::size_t min_side,
                  GridLine& step)
{
  layOut (samples);
  lines_.clear();
  for (const bool is_steep : {false, true}) {
    findEdges (samples, is_steep);
    findLines (is_steep);
    for (const SampleError& sample : samples)
      jumps_[place (sample.u, sample.v)] = 0.f;
  }
  for (const SampleError& sample : samples)
    errors_[place (sample.u, sample.v)] = own_[place (sample.u, sample.v)] = 0.f;
  if (lines_.empty())
    return false;
  fitSurface (samples);
  double most = 0.;
  for (const GridLine& line : lines_) {
    const double gain = gainOf (samples, line, min_side);
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
    errors_[place (sample.u, sample.v)] = sample.error;
    own_[place (sample.u, sample.v)] = 1.f;
  }
}

void
StepFinder::findEdges (const std::vector<SampleError>& samples, bool is_steep)
{
  const std::size_t across = is_steep ? 1 : static_cast<std::size_t> (stride_);
  for (const SampleError& sample : samples) {
    const std::size_t at = place (sample.u, sample.v);
    float before = 0.f, behind = 0.f, number_before = 0.f, number_behind = 0.f;
    for (std::size_t k = 0; k < depth; ++k) {
      before += errors_[at - k * across];
      number_before += own_[at - k * across];
      behind += errors_[at + (k + 1) * across];
      number_behind += own_[at + (k + 1) * across];
    }
    if (number_before >= min_in_depth && number_behind >= min_in_depth)
      jumps_[at] = before / number_before - behind / number_behind;
  }
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
  if (edges_.size() < static_cast<std::size_t> (min_places))
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
  const auto acrossAt = [&line] (int along) {
    return line.slope * static_cast<float> (along) + line.offset;
  };
  const auto isInside = [&,
                         first = static_cast<float> (first_[1 - k]),
                         end = static_cast<float> (last_[1 - k] + 1)] (int along) {
    return acrossAt (along) >= first && acrossAt (along) < end;
  };
  int begin = first_[k], end = last_[k] + 1;
  while (begin < end && !isInside (begin))
    ++begin;
  while (begin < end && !isInside (end - 1))
    --end;
  const std::ptrdiff_t along_step = line.is_steep ? stride_ : 1,
                       across_step = line.is_steep ? 1 : stride_;
  const float* jumps = &jumps_[place (0, 0)];
  float sum = 0.f;
  int places = 0;
  for (int along = begin; along < end; ++along) {
    const float jump =
        jumps[along * along_step + static_cast<int> (acrossAt (along)) * across_step];
    sum += jump;
    places += jump != 0.f;
  }
  return places >= min_places &&
         std::abs (sum) >= min_jump * static_cast<float> (places);
}

void
StepFinder::fitSurface (const std::vector<SampleError>& samples)
{
  terms_.resize (samples.size());
  const auto scaled = [this] (int value, int k) {
    return static_cast<float> (2 * value - first_[k] - last_[k]) /
           static_cast<float> (last_[k] - first_[k] + 1);
  };
  // Samples on a curve of second order determine no surface.
  Eigen::Matrix<double, 6, 6> products = 1e-6 * Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::Matrix<double, 6, 1> sums = Eigen::Matrix<double, 6, 1>::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float u = scaled (samples[i].u, 0), v = scaled (samples[i].v, 1);
    terms_[i] << 1.f, u, v, u * u, u * v, v * v, 0.f, 0.f;
    const Eigen::Matrix<double, 6, 1> terms = surfaceTerms (terms_[i]);
    products += terms * terms.transpose();
    sums += samples[i].error * terms;
  }
  inverse_ = products.inverse();
  Terms surface = Terms::Zero();
  surface.head<6>() = (inverse_ * sums).cast<float>();
  squares_ = 0.;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float error = samples[i].error - (surface * terms_[i]).sum();
    terms_[i][left] = error;
    squares_ += error * error;
  }
}

/** By how much the sum of the squares of the errors falls when the surface behind the
 * line is shifted, and all of it fitted anew; 0 where it is shifted by too little. */
double
StepFinder::gainOf (const std::vector<SampleError>& samples,
                    const GridLine& line,
                    std::size_t min_side) const
{
  Terms sums = Terms::Zero();
  std::size_t behind = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (line.isBehind (samples[i].u, samples[i].v)) {
      sums += terms_[i];
      ++behind;
    }
  if (behind < min_side || samples.size() - behind < min_side)
    return 0.;
  const Eigen::Matrix<double, 6, 1> t = surfaceTerms (sums);
  const double free = static_cast<double> (behind) - t.dot (inverse_ * t);
  const double height = sums[left] / free;
  return free >= 1. && std::abs (height) >= min_height ? sums[left] * height : 0.;
}

} // namespace rgbd_planes
} // namespace pcl
