// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/concave_split.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

using ConstMap = Eigen::Map<const Eigen::Vector3f>;

/** How far from a pixel the two points are that are compared. */
constexpr float reach_m = 0.006f;
constexpr int max_reach_px = 5;
/** A point is above the tangent plane of another one when it rises by this part of their
 * distance, 17 degrees, and by more than noise: that many standard deviations of depth. */
constexpr float min_rise = 0.3f;
constexpr float min_rise_sigmas = 2.f;
/** Parts have so many times the least number of points of an object. */
constexpr unsigned min_part = 2;

} // namespace

void
ConcaveSplit::compute (const OrganizedPoints& points,
                       const OrganizedNormals& normals,
                       float pixel_angle,
                       const std::vector<SegmentedPlane>& planes,
                       const std::vector<SupportPlane>& supports,
                       const ObjectParameters& parameters,
                       std::vector<ObjectCluster>& clusters)
{
  points_ = points;
  normals_ = normals;
  pixel_angle_ = pixel_angle;
  parameters_ = parameters;
  markOwners (clusters);
  markCuts (clusters);
  joinUncut (clusters);
  startParts (clusters);
  growParts();
  collect (clusters);
  settle (planes, supports, clusters);
}

void
ConcaveSplit::markOwners (const std::vector<ObjectCluster>& clusters)
{
  owner_.assign (points_.size(), 0);
  for (std::size_t k = 0; k < clusters.size(); ++k)
    for (const auto i : clusters[k].indices)
      owner_[static_cast<std::size_t> (i)] = static_cast<std::uint32_t> (k + 1);
}

void
ConcaveSplit::markCuts (const std::vector<ObjectCluster>& clusters)
{
  cut_.resize (points_.size());
  for (const auto& cluster : clusters)
    for (const auto index : cluster.indices) {
      const auto i = static_cast<std::uint32_t> (index);
      cut_[i] = isCut (i);
    }
}

bool
ConcaveSplit::isCut (std::uint32_t i) const
{
  const float pixel_m = pixel_angle_ * ConstMap (points_[i]).norm();
  const auto reach = static_cast<int> (
      std::lround (std::min (reach_m / pixel_m, float{max_reach_px})));
  const int far = std::max (reach, 1);
  const int near =
      std::max (static_cast<int> (std::lround (0.7f * static_cast<float> (far))), 1);
  const int steps[4][2] = {{far, 0}, {0, far}, {near, near}, {near, -near}};
  const int u = static_cast<int> (i) % points_.width;
  const int v = static_cast<int> (i) / points_.width;
  return std::any_of (std::begin (steps), std::end (steps), [&] (const int (&step)[2]) {
    const int left = u - step[0], right = u + step[0];
    const int top = v - step[1], bottom = v + step[1];
    if (left < 0 || right >= points_.width || std::min (top, bottom) < 0 ||
        std::max (top, bottom) >= points_.height)
      return false;
    const auto a = static_cast<std::uint32_t> (top * points_.width + left);
    const auto b = static_cast<std::uint32_t> (bottom * points_.width + right);
    return owner_[a] == owner_[i] && owner_[b] == owner_[i] &&
           (isStep (a, b) || isStep (b, a));
  });
}

/** Whether point j lies above the tangent plane of point i. */
bool
ConcaveSplit::isStep (std::uint32_t i, std::uint32_t j) const
{
  const ConstMap normal (normals_.normal + i * normals_.stride);
  const Eigen::Vector3f difference = ConstMap (points_[j]) - ConstMap (points_[i]);
  const float rise = normal.dot (difference);
  const float noise =
      min_rise_sigmas * parameters_.noise.sigma (ConstMap (points_[i]).squaredNorm());
  return rise > noise && rise * rise > min_rise * min_rise * difference.squaredNorm();
}

template <typename Visit>
void
ConcaveSplit::visitNeighbours (std::uint32_t i, const Visit& visit) const
{
  const auto width = static_cast<std::uint32_t> (points_.width);
  const auto visitOwn = [&] (std::uint32_t j) {
    if (owner_[j] == owner_[i])
      visit (j);
  };
  if (i >= width)
    visitOwn (i - width);
  if (i % width > 0)
    visitOwn (i - 1);
  if (i % width + 1 < width)
    visitOwn (i + 1);
  if (i + width < points_.size())
    visitOwn (i + width);
}

void
ConcaveSplit::joinUncut (const std::vector<ObjectCluster>& clusters)
{
  sets_.resize (points_.size());
  patch_size_.resize (points_.size());
  for (const auto& cluster : clusters) {
    for (const auto index : cluster.indices) {
      const auto i = static_cast<std::uint32_t> (index);
      patch_size_[i] = 0;
      if (cut_[i])
        continue;
      sets_.add (i);
      visitNeighbours (i, [&] (std::uint32_t j) {
        if (j < i && !cut_[j])
          sets_.join (i, j);
      });
    }
    for (const auto index : cluster.indices)
      if (!cut_[static_cast<std::size_t> (index)])
        ++patch_size_[sets_.root (static_cast<std::uint32_t> (index))];
  }
}

/** Makes a part of each large patch; a cluster without any is one part. */
void
ConcaveSplit::startParts (const std::vector<ObjectCluster>& clusters)
{
  part_.resize (points_.size());
  part_support_.clear();
  queue_.clear();
  for (const auto& cluster : clusters) {
    const std::size_t before = part_support_.size();
    for (const auto index : cluster.indices) {
      const auto i = static_cast<std::uint32_t> (index);
      part_[i] = 0;
      if (cut_[i])
        continue;
      const std::uint32_t root = sets_.root (i);
      if (patch_size_[root] < min_part * parameters_.min_points)
        continue;
      if (root == i)
        part_support_.push_back (cluster.support);
      part_[i] =
          root == i ? static_cast<std::uint32_t> (part_support_.size()) : part_[root];
      queue_.push_back (i);
    }
    if (part_support_.size() > before)
      continue;
    part_support_.push_back (cluster.support);
    queue_.push_back (static_cast<std::uint32_t> (cluster.indices.front()));
    part_[queue_.back()] = static_cast<std::uint32_t> (part_support_.size());
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
ConcaveSplit::collect (std::vector<ObjectCluster>& clusters)
{
  clusters.resize (part_support_.size());
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    clusters[k].indices.clear();
    clusters[k].support = part_support_[k];
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (owner_[i] != 0)
      clusters[part_[i] - 1].indices.push_back (static_cast<pcl::index_t> (i));
}

/** The part that most of a plane belongs to, from 1 on, or 0. */
std::uint32_t
ConcaveSplit::partWithPlane (const pcl::Indices& inliers)
{
  plane_points_.assign (part_support_.size() + 1, 0);
  for (const auto index : inliers) {
    const auto i = static_cast<std::size_t> (index);
    ++plane_points_[owner_[i] != 0 ? part_[i] : 0];
  }
  const auto most = std::max_element (plane_points_.begin() + 1, plane_points_.end());
  constexpr double nearly_all = 0.8;
  if (most == plane_points_.end() ||
      static_cast<double> (*most) < nearly_all * static_cast<double> (inliers.size()))
    return 0;
  return static_cast<std::uint32_t> (most - plane_points_.begin());
}

void
ConcaveSplit::settle (const std::vector<SegmentedPlane>& planes,
                      const std::vector<SupportPlane>& supports,
                      std::vector<ObjectCluster>& clusters)
{
  for (std::size_t k = supports.size(); k-- > 0;) { // the highest one counts
    if (!supports[k].is_on_object)
      continue;
    const std::uint32_t part = partWithPlane (*planes[supports[k].index].inliers);
    for (std::size_t c = 0; part != 0 && c < clusters.size(); ++c)
      if (c + 1 != part &&
          liesAbove (points_, clusters[c].indices, supports[k], parameters_))
        clusters[c].support = k;
  }
}

} // namespace rgbd_planes
} // namespace pcl
