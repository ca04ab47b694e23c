// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/object_clusters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Where a line of the image, on its way upwards, goes from one cluster to one behind. */
struct OcclusionStep {
  std::size_t line = 0;      /**< row or column */
  std::size_t front = 0;     /**< the cluster in front */
  std::size_t behind = 0;    /**< the cluster behind */
  std::uint32_t edge = 0;    /**< the last point in front */
  std::uint32_t lowest = 0;  /**< the first point behind */
  std::uint32_t highest = 0; /**< the last point behind */
  std::size_t skipped = 0;   /**< pixels between \a edge and \a lowest */
  float depth = 0.f;         /**< how much farther it is behind; metres */
};

/** \brief Finds which clusters are in front of others, along those lines of the image, rows or
 * columns, that run upwards. */
class PCL_RGBD_PLANES_EXPORTS OcclusionSteps {
public:
  /** \brief Finds the steps between clusters with up to a tenth of the width of the image between.
   * \param[in] clustering of the same points
   */
  void
  compute (const OrganizedPoints& points,
           const ObjectClusters& clustering,
           const std::vector<ObjectCluster>& clusters);

  /** \brief One pair of clusters after the other, those with the last front first, line by line. */
  const std::vector<OcclusionStep>&
  steps () const
  {
    return steps_;
  }

  /** \brief The lowest points of a cluster in the first and the last one of its lines. */
  std::array<std::uint32_t, 2>
  lowestAtEnds (std::size_t cluster) const
  {
    const Extent& extent = extents_[cluster];
    return {lowest_of_all_[extent.begin],
            lowest_of_all_[extent.begin + extent.lines - 1]};
  }

  /** \brief Calls use (point, down) for the lowest point of a cluster in each of its lines, with
   * the step from there to the next pixel below. */
  template <typename Use>
  void
  forEachLowest (std::size_t cluster, const Use& use) const
  {
    const Extent& extent = extents_[cluster];
    for (std::size_t k = extent.begin; k < extent.begin + extent.lines; ++k)
      if (lowest_of_all_[k] != no_pixel)
        use (lowest_of_all_[k], -extent.up);
  }

  /** \brief The cluster of a point, from 1 on, or 0. */
  std::uint32_t
  ownerOf (std::uint32_t point) const
  {
    return owner_[point];
  }

  /** \brief In how many lines a cluster is. */
  std::size_t
  linesOf (std::size_t cluster) const
  {
    return extents_[cluster].lines;
  }

  /** \brief A point of another cluster, and how many pixels without a cluster are before it. */
  struct Neighbour {
    std::uint32_t point = 0;
    std::size_t cluster = 0;
    std::size_t skipped = 0;
  };

  /** \brief What comes next on the way from a point of a cluster to the pixel \a step further,
   * and so on, if that is another cluster.
   * \param[in] pixels how many to look at
   */
  std::optional<Neighbour>
  nextCluster (std::uint32_t point, std::ptrdiff_t step, std::size_t pixels) const;

  /** \brief How many pixels there are, at most, between points that are next to each other, for
   * edges lack depth. */
  std::size_t
  maxGap () const;

  /** \brief Calls use (point) for the points in front of a step, from its edge downwards, up to
   * a gap of more than maxGap(). */
  template <typename Use>
  void
  forEachBelow (const OcclusionStep& step, const Use& use) const
  {
    const std::ptrdiff_t down = -extents_[step.behind].up;
    std::size_t skipped = 0;
    std::uint32_t i = step.edge;
    for (auto next = nextPixel (points_, i, down); next != i && skipped <= maxGap();
         next = nextPixel (points_, i, down)) {
      i = next;
      skipped = owner_[i] == owner_[step.edge] ? 0 : skipped + 1;
      if (skipped == 0)
        use (i);
    }
  }

private:
  /** \brief Of a cluster. */
  struct Extent {
    std::ptrdiff_t up = 0; // to the next point of a line
    std::size_t first_line = 0;
    std::size_t lines = 0;
    std::size_t begin = 0; // among the lowest points of all clusters
  };

  void
  own (const std::vector<ObjectCluster>& clusters);

  void
  findEnds (const ObjectCluster& cluster, Extent& extent);

  bool
  findFront (OcclusionStep& step) const;

  float
  rangeFrom (std::uint32_t i, std::ptrdiff_t step, bool farthest) const;

  OrganizedPoints points_;
  std::vector<std::uint32_t> owner_; // of each point: its cluster, from 1 on, or 0
  std::vector<PointRun> owned_;      // those that are of one
  std::vector<Extent> extents_;
  // Points in each line of a cluster, or no_pixel:
  std::vector<std::uint32_t> lowest_, highest_;
  std::vector<std::uint32_t> lowest_of_all_; // one cluster after the other
  std::vector<OcclusionStep> steps_;
};

} // namespace rgbd_planes
} // namespace pcl
