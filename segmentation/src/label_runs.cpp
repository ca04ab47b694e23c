// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"

#include <pcl/segmentation/impl/label_runs.h>

#include <algorithm>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

void
LabelRuns::find (std::vector<std::uint32_t>& labels,
                 std::size_t width,
                 const std::vector<std::uint32_t>& numbers)
{
  width_ = width;
  runs_.clear();
  rows_.clear();
  pixels_.assign (numbers.size(), 0);
  for (std::size_t row = 0; row < labels.size(); row += width) {
    rows_.push_back (runs_.size());
    for (std::size_t begin = row, end; begin < row + width; begin = end) {
      const std::uint32_t label = labels[begin];
      end = begin + lengthOfRun (&labels[begin], row + width - begin);
      if (label == unlabelled)
        continue;
      const std::uint32_t number = numbers[label];
      if (number != label)
        std::fill (&labels[begin], labels.data() + end, number);
      if (number == unlabelled)
        continue;
      runs_.push_back (
          {number, static_cast<index_t> (begin), static_cast<index_t> (end)});
      pixels_[number] += end - begin;
    }
  }
  rows_.push_back (runs_.size());
}

} // namespace rgbd_planes
} // namespace pcl
