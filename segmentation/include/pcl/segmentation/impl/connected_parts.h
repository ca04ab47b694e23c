// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The connected parts of each label of an image: pixels of equal label that
 * touch by a side or a corner (8-connected).
 *
 * Runs of neighbouring rows that touch are united in a forest of disjoint sets, whose
 * number of steps is in practice linear in the number of runs.
 */
class PCL_RGBD_PLANES_EXPORTS ConnectedParts {
public:
  /** \brief A connected part of the pixels of one label. */
  struct Part {
    std::uint32_t label = 0;
    /** The first pixel of the part, row by row. */
    index_t first = 0;
    std::size_t pixels = 0;
  };

  void
  find (const LabelRuns& image);

  /** \brief All parts, ordered by their first pixels. */
  const std::vector<Part>&
  parts () const
  {
    return parts_;
  }

  /** \brief The number of the part of each run. */
  const std::vector<std::uint32_t>&
  partOfRun () const
  {
    return part_of_run_;
  }

private:
  void
  unite (const LabelRuns& image, std::size_t row);

  DisjointSets sets_; // of runs
  std::vector<std::uint32_t> part_of_run_;
  std::vector<Part> parts_;
};

} // namespace rgbd_planes
} // namespace pcl
