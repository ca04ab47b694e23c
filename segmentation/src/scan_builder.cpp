// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "row_bits.h"
#include "scan_kernels.h"

#include <pcl/segmentation/impl/scan_builder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float turn = 6.2831853f;

/** Angles that are a multiple of the increment but for their rounding are so. */
std::size_t
wholeSteps (float angle, float increment)
{
  return static_cast<std::size_t> (angle / increment + 0.01f);
}

} // namespace

void
ScanBuilder::start (const ScanLimits& limits, std::size_t columns, VirtualScan& scan)
{
  const float span = limits.angle_max - limits.angle_min;
  // Rounded up, the last direction could be the first one again.
  const std::size_t sectors =
      std::max<std::size_t> (wholeSteps (turn, limits.angle_increment), 1);
  const std::size_t directions =
      std::min (wholeSteps (span, limits.angle_increment) + 1, sectors);
  if (sectors_.size() != sectors + 1 || limits.angle_min != limits_.angle_min ||
      limits.angle_increment != limits_.angle_increment) {
    sectors_.assign (sectors + 1, {});
    for (std::size_t i = 0; i < sectors; ++i) {
      const float right =
          limits.angle_min + (static_cast<float> (i) - 0.5f) * limits.angle_increment;
      const float left =
          limits.angle_min + (static_cast<float> (i) + 0.5f) * limits.angle_increment;
      sectors_[i] = {
          std::cos (right), std::sin (right), std::cos (left), std::sin (left)};
    }
  }
  // Columns that kept their sectors would round other sums than in a new object.
  column_sectors_.assign (columns, noSector());
  const std::size_t padded = columns + PointRow::block_size;
  for (auto* values :
       {&columns_.right_x, &columns_.right_y, &columns_.left_x, &columns_.left_y})
    values->assign (padded, 0.f);
  columns_.squares.assign (padded, infinity);
  columns_.x.resize (padded);
  columns_.y.resize (padded);
  columns_.in_range.assign (wordsFor (columns), 0);
  columns_.strays.assign (wordsFor (columns), 0);
  gaps_.assign (wordsFor (columns), 0);
  limits_ = limits;
  squares_.assign (sectors + 1, infinity);

  scan.angle_min = limits.angle_min;
  scan.angle_max =
      limits.angle_min + static_cast<float> (directions - 1) * limits.angle_increment;
  scan.angle_increment = limits.angle_increment;
  scan.range_min = limits.range_min;
  scan.range_max = limits.range_max;
  scan.ranges.resize (directions);
  scan_ = &scan;
}

void
ScanBuilder::add (const PointRow& row,
                  const Eigen::Affine3f& camera_to_base,
                  const Eigen::Vector4f& floor,
                  const std::vector<ScanRun>& runs)
{
  if (runs.empty())
    return;
  std::fill (columns_.in_range.begin(), columns_.in_range.end(), 0);
  scanRuns (row, camera_to_base, floor, limits_, runs, columns_);
  for (std::size_t k = 0; k < columns_.strays.size(); ++k) {
    forEachBit (columns_.strays[k], [&] (std::size_t bit) {
      const std::size_t u = k * bits_in_word + bit;
      const float x = columns_.x[u], y = columns_.y[u];
      turnColumn (u, find (x, y, u));
      columns_.squares[u] = x * x + y * y;
    });
    columns_.strays[k] = 0;
  }
  for (const ScanRun& run : runs)
    closeGaps (run);
}

void
ScanBuilder::closeGaps (const ScanRun& run)
{
  const auto isInRange = [&] (std::size_t u) {
    return (columns_.in_range[u / bits_in_word] >> u % bits_in_word & 1) != 0;
  };
  const std::size_t last = run.end - 1;
  for (std::size_t u = nextBit (gaps_, run.begin); u < last; u = nextBit (gaps_, u + 1))
    if (isInRange (u) && isInRange (u + 1))
      fillBetween (u);
}

void
ScanBuilder::fillBetween (std::size_t column)
{
  std::size_t a = column_sectors_[column], b = column_sectors_[column + 1];
  float at_a = columns_.squares[column], at_b = columns_.squares[column + 1];
  if ((a > b) != (2 * (std::max (a, b) - std::min (a, b)) > noSector())) {
    std::swap (a, b);
    std::swap (at_a, at_b);
  }
  if (a > b) // the short way leads from the last direction of a turn to the first one
    b += noSector();
  for (std::size_t k = a + 1; k < b; ++k) {
    float& square = squares_[k < noSector() ? k : k - noSector()];
    square = std::min (square, k - a <= b - k ? at_a : at_b);
  }
}

/** Keeps what a column found, and gives it another sector. */
void
ScanBuilder::turnColumn (std::size_t column, std::size_t sector)
{
  float& square = squares_[column_sectors_[column]];
  square = std::min (square, columns_.squares[column]);
  column_sectors_[column] = sector;
  columns_.squares[column] = infinity;
  columns_.right_x[column] = sectors_[sector].right_x;
  columns_.right_y[column] = sectors_[sector].right_y;
  columns_.left_x[column] = sectors_[sector].left_x;
  columns_.left_y[column] = sectors_[sector].left_y;
  if (column > 0)
    noteGap (column - 1);
  if (column + 1 < column_sectors_.size())
    noteGap (column);
}

void
ScanBuilder::noteGap (std::size_t column)
{
  const auto [a, b] =
      std::minmax (column_sectors_[column], column_sectors_[column + 1]);
  const std::uint64_t bit = std::uint64_t{1} << column % bits_in_word;
  std::uint64_t& word = gaps_[column / bits_in_word];
  word = b - a > 1 && b != noSector() ? word | bit : word & ~bit;
}

std::size_t
ScanBuilder::find (float x, float y, std::size_t column) const
{
  const std::size_t last = column_sectors_[column];
  const std::size_t beside = column_sectors_[column > 0 ? column - 1 : 0];
  for (const std::size_t near : {last + 1, last - 1, beside, beside + 1, beside - 1})
    if (near < sectors_.size() && sectors_[near].contains (x, y))
      return near;
  const float steps_in_turn = turn / limits_.angle_increment;
  float steps =
      (std::atan2 (y, x) - limits_.angle_min) / limits_.angle_increment + 0.5f;
  steps -= steps_in_turn * std::floor (steps / steps_in_turn);
  const auto sector = static_cast<std::size_t> (steps);
  if (sector < noSector() || scan_->ranges.size() < noSector())
    return std::min (sector, noSector());
  // Between the last direction of a turn and the first one may be more than one increment.
  const float middle = 0.5f * (static_cast<float> (noSector()) + steps_in_turn);
  return steps < middle ? noSector() - 1 : 0;
}

void
ScanBuilder::finish()
{
  for (std::size_t u = 0; u < column_sectors_.size(); ++u)
    turnColumn (u, column_sectors_[u]);
  const float nearest = limits_.range_min * limits_.range_min;
  for (std::size_t i = 0; i < scan_->ranges.size(); ++i)
    scan_->ranges[i] = squares_[i] < nearest ? -infinity : std::sqrt (squares_[i]);
}

} // namespace rgbd_planes
} // namespace pcl
