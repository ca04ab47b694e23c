// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "object_kernels.h"

#include <pcl/segmentation/concave_split.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Parts have so many times the least number of points of an object. */
constexpr unsigned min_part = 2;

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
  const std::size_t rows =
      (static_cast<std::size_t> (height) >> shift_) + 1 + 2 * margin;
  const std::size_t size = rows * stride_ + 2 * block_size;
  for (auto* values : {&x, &y, &z, &normal_x, &normal_y, &normal_z})
    values->resize (size);
  owner.assign (size, 0);
}

void
ConcaveSplit::compute (const OrganizedPoints& points,
                       const OrganizedNormals& normals,
                       float pixel_angle,
                       const std::vector<SegmentedPlane>& planes,
                       const std::vector<SupportPlane>& supports,
                       const ObjectParameters& parameters,
                       const std::vector<ObjectCluster>& clusters)
{
  parameters_ = parameters;
  layOut (points, normals, clusters);
  markCuts (
      image_, pixel_angle * static_cast<float> (image_.step()), parameters.noise, cut_);
  joinUncut();
  startParts (clusters);
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
  places_.clear();
  first_place_.clear();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    first_place_.push_back (places_.size());
    image_.forEachPlace (
        clusters[k].indices, [&] (std::uint32_t point, std::uint32_t i) {
          if (image_.owner[i] != 0)
            return;
          const float* p = points[point];
          const float* normal = normals.normal + point * normals.stride;
          places_.push_back (i);
          image_.owner[i] = static_cast<std::uint32_t> (k + 1);
          image_.x[i] = p[0];
          image_.y[i] = p[1];
          image_.z[i] = p[2];
          image_.normal_x[i] = normal[0];
          image_.normal_y[i] = normal[1];
          image_.normal_z[i] = normal[2];
        });
  }
  first_place_.push_back (places_.size());
}

template <typename Visit>
void
ConcaveSplit::visitNeighbours (std::uint32_t i, const Visit& visit) const
{
  for (const std::uint32_t j : {i - image_.stride(), i - 1, i + 1, i + image_.stride()})
    if (image_.owner[j] == image_.owner[i])
      visit (j);
}

void
ConcaveSplit::joinUncut()
{
  sets_.resize (image_.size());
  patch_size_.resize (image_.size());
  const std::uint32_t stride = image_.stride();
  for (const std::uint32_t i : places_) {
    patch_size_[i] = 0;
    sets_.add (i);
  }
  for (const std::uint32_t i : places_) {
    if (cut_[i])
      continue;
    const auto isOfPatch = [&] (std::uint32_t j) {
      return image_.owner[j] == image_.owner[i] && !cut_[j];
    };
    const bool left = isOfPatch (i - 1), above = isOfPatch (i - stride);
    if (left)
      sets_.join (i - 1, i);
    if (above && !(left && isOfPatch (i - stride - 1))) // by which they are joined
      sets_.join (i - stride, i);
  }
  for (const std::uint32_t i : places_)
    if (!cut_[i])
      ++patch_size_[sets_.root (i)];
}

/** Makes a part of each large patch; a cluster without any is one part. */
void
ConcaveSplit::startParts (const std::vector<ObjectCluster>& clusters)
{
  const std::uint32_t min_cells =
      min_part * parameters_.min_points / (image_.step() * image_.step());
  part_.resize (image_.size());
  part_support_.clear();
  first_part_.clear();
  queue_.clear();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const std::size_t before = part_support_.size();
    first_part_.push_back (static_cast<std::uint32_t> (before + 1));
    for (std::size_t place = first_place_[k]; place < first_place_[k + 1]; ++place) {
      const std::uint32_t i = places_[place];
      part_[i] = 0;
      if (cut_[i] || sets_.root (i) != i || patch_size_[i] < min_cells)
        continue;
      part_support_.push_back (clusters[k].support);
      part_[i] = static_cast<std::uint32_t> (part_support_.size());
    }
    if (part_support_.size() == before)
      part_support_.push_back (clusters[k].support);
  }
  for (const std::uint32_t i : places_) {
    part_[i] = cut_[i] ? 0 : part_[sets_.root (i)];
    if (part_[i] != 0)
      queue_.push_back (i);
  }
}

void
ConcaveSplit::growParts()
{
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t i = queue_[next];
    visitNeighbours (i, [&] (std::uint32_t j) {
      if (part_[j] != 0)
        return;
      part_[j] = part_[i];
      queue_.push_back (j);
    });
  }
}

void
ConcaveSplit::collect (const std::vector<ObjectCluster>& clusters)
{
  parts_.resize (part_support_.size());
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    parts_[k].indices.clear();
    parts_[k].support = part_support_[k];
  }
  for (std::size_t k = 0; k < clusters.size(); ++k)
    image_.forEachPlace (
        clusters[k].indices, [&] (std::uint32_t point, std::uint32_t i) {
          // Cells without a part have none near them, or are of another cluster.
          const bool has_part = image_.owner[i] == k + 1 && part_[i] != 0;
          parts_[(has_part ? part_[i] : first_part_[k]) - 1].indices.push_back (
              static_cast<pcl::index_t> (point));
        });
}

/** The part that most of a plane belongs to, from 1 on, or 0. */
std::uint32_t
ConcaveSplit::partWithPlane (const pcl::Indices& inliers)
{
  plane_points_.assign (part_support_.size() + 1, 0);
  image_.forEachPlace (inliers, [&] (std::uint32_t, std::uint32_t i) {
    ++plane_points_[image_.owner[i] != 0 ? part_[i] : 0];
  });
  const auto most = std::max_element (plane_points_.begin() + 1, plane_points_.end());
  constexpr double nearly_all = 0.8;
  if (most == plane_points_.end() ||
      static_cast<double> (*most) < nearly_all * static_cast<double> (inliers.size()))
    return 0;
  return static_cast<std::uint32_t> (most - plane_points_.begin());
}

void
ConcaveSplit::settle (const OrganizedPoints& points,
                      const std::vector<SegmentedPlane>& planes,
                      const std::vector<SupportPlane>& supports)
{
  for (std::size_t k = supports.size(); k-- > 0;) { // the highest one counts
    if (!supports[k].is_on_object)
      continue;
    const std::uint32_t part = partWithPlane (*planes[supports[k].index].inliers);
    for (std::size_t c = 0; part != 0 && c < parts_.size(); ++c)
      if (c + 1 != part &&
          liesAbove (points, parts_[c].indices, supports[k], parameters_))
        parts_[c].support = k;
  }
}

} // namespace rgbd_planes
} // namespace pcl
