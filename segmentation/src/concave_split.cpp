// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "cut_kernels.h"
#include "plane_levels.h"
#include <hwy/cache_control.h>

#include <pcl/segmentation/impl/concave_split.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Parts have so many cells at least: of fewer, most are pieces that noise cuts off. */
constexpr unsigned min_part_cells = 20;
/** Normals are fetched before so many runs. */
constexpr std::size_t runs_ahead = 4;

} // namespace

void
ClusterImage::resize (int width, int height)
{
  constexpr std::uint32_t max_columns = 480;
  width_ = static_cast<std::uint32_t> (width);
  for (shift_ = 0; width_ >> shift_ >= max_columns;)
    ++shift_;
  // The margin to the right of a row is that to the left of the next one.
  const std::uint32_t columns = (width_ >> shift_) + 1;
  stride_ = (columns + margin + block_size - 1) / block_size * block_size;
  first_ = margin * stride_ + block_size;
  rows_ = (static_cast<std::uint32_t> (height) >> shift_) + 1;
  const std::size_t size =
      std::size_t{rows_ + 2 * margin} * stride_ + 2 * std::size_t{block_size};
  for (auto* values : {&x, &y, &z, &normal_x, &normal_y, &normal_z})
    values->resize (size);
  owner.assign (size, 0);
}

void
ConcaveSplit::compute (const OrganizedPoints& points,
                       const OrganizedNormals& normals,
                       float pixel_angle,
                       const std::vector<SegmentedPlane>& planes,
                       const std::vector<SupportSurface>& supports,
                       const ObjectParameters& parameters,
                       const std::vector<ObjectCluster>& clusters)
{
  parameters_ = parameters;
  layOut (points, normals, clusters);
  findPatches (pixel_angle);
  countParts (clusters.size());
  startParts();
  growParts();
  collect (clusters);
  settle (points, planes, supports);
}

void
ConcaveSplit::layOut (const OrganizedPoints& points,
                      const OrganizedNormals& normals,
                      const std::vector<ObjectCluster>& clusters)
{
  image_.resize (points.width, points.height);
  part_.resize (image_.owner.size());
  // They have left the cache since they were computed, and runs are too short for it to see
  // which come next.
  const auto isFirstInCells = [&] (const PointRun& run) {
    return run.first / static_cast<std::uint32_t> (points.width) % image_.step() == 0;
  };
  const auto prefetchNormals = [&] (const PointRun& run) {
    for (std::uint32_t i = run.first; i < run.first + run.length; i += image_.step())
      hwy::Prefetch (normals[i]);
  };
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const auto addCell = [&] (const PointRun& part, std::uint32_t i) {
      if (image_.owner[i] != 0)
        return;
      const float* p = points[part.first];
      const float* normal = normals[part.first];
      image_.owner[i] = static_cast<std::uint32_t> (k + 1);
      image_.x[i] = p[0];
      image_.y[i] = p[1];
      image_.z[i] = p[2];
      image_.normal_x[i] = normal[0];
      image_.normal_y[i] = normal[1];
      image_.normal_z[i] = normal[2];
      part_[i] = 0;
    };
    const auto& runs = clusters[k].runs;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      if (r + runs_ahead < runs.size() && isFirstInCells (runs[r + runs_ahead]))
        prefetchNormals (runs[r + runs_ahead]);
      image_.forEachCell (runs[r], addCell);
    }
  }
}

void
ConcaveSplit::findPatches (float pixel_angle)
{
  const float cell_angle = pixel_angle * static_cast<float> (image_.step());
  runs_.start (image_.stride());
  for (std::uint32_t row = image_.begin(); row < image_.end(); row += image_.stride()) {
    findUncut (image_, row, cell_angle, parameters_.noise, runs_.bits());
    runs_.addRow (row);
  }
  patches_.assign (runs_.runs().size(), {});
  for (std::uint32_t k = 0; k < patches_.size(); ++k)
    patches_[runs_.root (k)].cells += runs_.runs()[k].length;
}

/** Each large patch becomes a part; a cluster without any is one part. */
void
ConcaveSplit::countParts (std::size_t clusters)
{
  const std::uint32_t min_cells = std::max (
      parameters_.min_points / (image_.step() * image_.step()), min_part_cells);
  first_part_.assign (clusters + 1, 0);
  for (std::uint32_t k = 0; k < patches_.size(); ++k)
    if (runs_.root (k) == k && patches_[k].cells >= min_cells)
      patches_[k].part = ++first_part_[image_.owner[runs_.runs()[k].first]];
  first_part_[0] = 1;
  for (std::size_t k = 1; k <= clusters; ++k)
    first_part_[k] = first_part_[k - 1] + std::max (first_part_[k], 1u);
}

void
ConcaveSplit::startParts()
{
  queue_.clear();
  for (std::uint32_t k = 0; k < patches_.size(); ++k) {
    const PointRun& run = runs_.runs()[k];
    const std::size_t cluster = image_.owner[run.first] - 1;
    const std::uint32_t part = patches_[runs_.root (k)].part;
    if (!isSplit (cluster) || part == 0)
      continue;
    for (std::uint32_t i = run.first; i < run.first + run.length; ++i) {
      part_[i] = first_part_[cluster] + part - 1;
      queue_.push_back (i);
    }
  }
}

/** All other cells of the clusters that are split join the nearest part. */
void
ConcaveSplit::growParts()
{
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t i = queue_[next];
    for (const std::uint32_t j :
         {i - image_.stride(), i - 1, i + 1, i + image_.stride()}) {
      if (image_.owner[j] != image_.owner[i] || part_[j] != 0)
        continue;
      part_[j] = part_[i];
      queue_.push_back (j);
    }
  }
}

void
ConcaveSplit::collect (const std::vector<ObjectCluster>& clusters)
{
  parts_.resize (first_part_.back() - 1);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (std::uint32_t part = first_part_[k]; part < first_part_[k + 1]; ++part) {
      parts_[part - 1].runs.clear();
      parts_[part - 1].support = clusters[k].support;
    }
    if (!isSplit (k)) {
      parts_[first_part_[k] - 1].runs = clusters[k].runs;
      continue;
    }
    for (const PointRun& run : clusters[k].runs)
      image_.forEachCell (run, [&] (const PointRun& in_cell, std::uint32_t i) {
        // Cells without a part have none near them, or are of another cluster.
        const bool has_part = image_.owner[i] == k + 1 && part_[i] != 0;
        auto& runs = parts_[(has_part ? part_[i] : first_part_[k]) - 1].runs;
        if (in_cell.first > run.first && !runs.empty() &&
            runs.back().first + runs.back().length == in_cell.first)
          runs.back().length += in_cell.length;
        else
          runs.push_back (in_cell);
      });
  }
}

/** The part of the cell at place \a i, from 1 on, or 0. */
std::uint32_t
ConcaveSplit::partAt (std::uint32_t i) const
{
  if (image_.owner[i] == 0)
    return 0;
  const std::size_t cluster = image_.owner[i] - 1;
  return isSplit (cluster) ? part_[i] : first_part_[cluster];
}

/** How many points of a plane are of each part, from 1 on, and of none. */
void
ConcaveSplit::countPlanePoints (const pcl::Indices& inliers)
{
  plane_points_.assign (parts_.size() + 1, 0);
  for (const auto index : inliers)
    ++plane_points_[partAt (image_.placeOf (static_cast<std::uint32_t> (index)))];
}

void
ConcaveSplit::settle (const OrganizedPoints& points,
                      const std::vector<SegmentedPlane>& planes,
                      const std::vector<SupportSurface>& supports)
{
  constexpr double few = 0.2;
  for (std::size_t k = supports.size(); k-- > 0;) { // the highest one counts
    if (!supports[k].is_on_object)
      continue;
    const auto& inliers = *planes[supports[k].index].inliers;
    const double max_few = few * static_cast<double> (inliers.size());
    countPlanePoints (inliers);
    const auto isFew = [&] (std::size_t part) {
      return static_cast<double> (plane_points_[part]) <= max_few;
    };
    if (!isFew (0))
      continue;
    // Tops of equal height are one plane, of several parts. What stands between them is on none.
    for (std::uint32_t part = 1; part <= parts_.size(); ++part) {
      if (isFew (part))
        continue;
      on_top_.clear();
      for (const auto index : inliers) {
        const auto i = static_cast<std::uint32_t> (index);
        if (partAt (image_.placeOf (i)) == part)
          on_top_.push_back (supports[k].project (points[i]));
      }
      top_.compute (on_top_, parameters_.hull_tolerance);
      const auto isOverTop = [&] (const float* p) {
        return top_.contains (supports[k].project (p));
      };
      for (std::size_t c = 0; c < parts_.size(); ++c)
        if (isFew (c + 1) &&
            liesAbove (points, parts_[c].runs, supports[k], parameters_) &&
            isShareAtLeast (few, points, parts_[c].runs, isOverTop))
          parts_[c].support = k;
    }
  }
}

} // namespace rgbd_planes
} // namespace pcl
