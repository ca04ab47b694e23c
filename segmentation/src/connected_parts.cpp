// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/connected_parts.h>

namespace pcl {
namespace rgbd_planes {

void
ConnectedParts::find (const LabelRuns& image)
{
  const auto& runs = image.runs();
  sets_.start (runs.size());
  for (std::size_t row = 1; row + 1 < image.rows().size(); ++row)
    unite (image, row);

  parts_.clear();
  part_of_run_.resize (runs.size());
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    const std::uint32_t first = sets_.root (i);
    if (first == i) {
      part_of_run_[i] = static_cast<std::uint32_t> (parts_.size());
      parts_.push_back ({runs[i].label, runs[i].begin, 0});
    }
    part_of_run_[i] = part_of_run_[first];
    parts_[part_of_run_[i]].pixels += runs[i].size();
  }
}

/** Unites the runs of a row with those of the row above that they touch. */
void
ConnectedParts::unite (const LabelRuns& image, std::size_t row)
{
  const auto& runs = image.runs();
  const auto width = static_cast<index_t> (image.width());
  std::size_t above = image.rows()[row - 1];
  const std::size_t first = image.rows()[row], last = image.rows()[row + 1];
  for (std::size_t run = first; run < last; ++run) {
    while (above < first && runs[above].end + width < runs[run].begin)
      ++above;
    for (std::size_t other = above;
         other < first && runs[other].begin + width <= runs[run].end;
         ++other) {
      if (runs[other].label == runs[run].label)
        sets_.join (static_cast<std::uint32_t> (other),
                    static_cast<std::uint32_t> (run));
    }
  }
}

} // namespace rgbd_planes
} // namespace pcl
