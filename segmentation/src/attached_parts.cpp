// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/attached_parts.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Parts have so many times fewer points than the thing... */
constexpr std::size_t min_ratio = 10;
/** ... in so many places of them no farther than this from it, in metres. */
constexpr std::size_t min_contacts = 3;
constexpr float max_distance = 0.015f;
/** What stands on its plane has at least so many points lower than this many times the least
 * height of objects, below which points are the plane's. */
constexpr std::size_t min_low_points = 5;
constexpr float stands = 1.5f;
/** What is nowhere higher than so many times that, but for a tenth, is a foot. */
constexpr float foot = 2.f;
constexpr double low_share = 0.9;
/** What rests on a thing is not too flat for an object, and has its contacts lower, in parts of
 * its own height. */
constexpr float min_contact = 0.3f;
/** What is steeper, nothing rests on; cosine of the slope. */
constexpr float min_rest = 0.5f;
constexpr float sigmas = 3.f;

/** The value that \a number others are below, or the largest. */
float
valueAbove (std::vector<float>& values, std::size_t number)
{
  const auto place = values.begin() +
                     static_cast<std::ptrdiff_t> (std::min (number, values.size() - 1));
  std::nth_element (values.begin(), place, values.end());
  return *place;
}

bool
isNear (const float* p, const float* q)
{
  const Eigen::Map<const Eigen::Vector3f> from (p), to (q);
  return (from - to).norm() <= max_distance;
}

} // namespace

void
AttachedParts::find (const OrganizedPoints& points,
                     const OrganizedNormals& normals,
                     const OcclusionSteps& occlusions,
                     const SupportPlanes& supports,
                     const ObjectParameters& parameters,
                     const std::vector<ObjectCluster>& clusters,
                     DisjointSets& sets)
{
  points_ = points;
  normals_ = normals;
  occlusions_ = &occlusions;
  sizes_.resize (clusters.size());
  std::transform (clusters.begin(),
                  clusters.end(),
                  sizes_.begin(),
                  [] (const auto& cluster) { return pointsOf (cluster.runs); });
  const std::size_t largest =
      sizes_.empty() ? 0 : *std::max_element (sizes_.begin(), sizes_.end());
  contacts_with_.assign (clusters.size(), 0);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (min_ratio * sizes_[k] > largest)
      continue;
    const SupportSurface& support = supports.planes()[clusters[k].support];
    findContacts (clusters[k], support);
    std::size_t other = 0, most = 0; // the first one of those with the most contacts
    for (const Contact& contact : contacts_) {
      contacts_with_[contact.other] +=
          sizes_[contact.other] >= min_ratio * sizes_[k] &&
          clusters[contact.other].support == clusters[k].support;
      const std::size_t count = contacts_with_[contact.other];
      if (count > most || (count == most && contact.other < other)) {
        other = contact.other;
        most = count;
      }
    }
    for (const Contact& contact : contacts_)
      contacts_with_[contact.other] = 0;
    // A strip of the wall behind is no part.
    if (most >= min_contacts && isPart (clusters[k], support, other, parameters) &&
        !liesOnOneOf (
            supports.background(), points, clusters[k].runs, parameters.noise))
      sets.join (static_cast<std::uint32_t> (k), static_cast<std::uint32_t> (other));
  }
}

void
AttachedParts::findContacts (const ObjectCluster& cluster,
                             const SupportSurface& support)
{
  contacts_.clear();
  const std::size_t pixels = occlusions_->maxGap() + 1;
  for (const PointRun& run : cluster.runs)
    for (std::uint32_t i = run.first; i < run.first + run.length; ++i)
      for (const std::ptrdiff_t step : {std::ptrdiff_t{-points_.width},
                                        std::ptrdiff_t{-1},
                                        std::ptrdiff_t{1},
                                        std::ptrdiff_t{points_.width}}) {
        const bool is_in_run =
            step == -1 ? i > run.first : step == 1 && i + 1 < run.first + run.length;
        if (is_in_run)
          continue;
        const auto next = occlusions_->nextCluster (i, step, pixels);
        if (!next || !isNear (points_[i], points_[next->point]))
          continue;
        Contact contact{next->cluster, support.plane.distance (points_[i])};
        if (normals_.normal)
          contact.cosine = support.plane.normal.dot (
              Eigen::Map<const Eigen::Vector3f> (normals_[next->point]));
        contacts_.push_back (contact);
        break;
      }
}

/** Whether the other one is, where the cluster meets it. */
bool
AttachedParts::isSteep()
{
  return !contact_cosines_.empty() &&
         valueAbove (contact_cosines_, contact_cosines_.size() / 2) < min_rest;
}

/** Whether the cluster neither stands on its plane nor rests on the other one. */
bool
AttachedParts::isPart (const ObjectCluster& cluster,
                       const SupportSurface& support,
                       std::size_t other,
                       const ObjectParameters& parameters)
{
  heights_.clear();
  float squared_range = 0.f;
  for (const PointRun& run : cluster.runs)
    for (std::uint32_t i = run.first; i < run.first + run.length; ++i) {
      heights_.push_back (support.plane.distance (points_[i]));
      squared_range = std::max (squared_range, squaredRange (points_[i]));
    }
  contact_heights_.clear();
  contact_cosines_.clear();
  for (const Contact& contact : contacts_)
    if (contact.other == other) {
      contact_heights_.push_back (contact.height);
      if (std::isfinite (contact.cosine))
        contact_cosines_.push_back (contact.cosine);
    }
  const float low = valueAbove (heights_, min_low_points - 1);
  const float high = valueAbove (
      heights_,
      static_cast<std::size_t> (low_share * static_cast<double> (heights_.size())));
  const float least =
      std::max (parameters.min_object_height,
                sigmas * parameters.noise.sigmaAtSquare (squared_range));
  const bool stands_on_plane = low < stands * least && high > foot * least;
  const bool rests_on_other =
      high - low > least &&
      valueAbove (contact_heights_, contact_heights_.size() / 2) <
          low + min_contact * (high - low) &&
      !isSteep();
  return !stands_on_plane && !rests_on_other;
}

} // namespace rgbd_planes
} // namespace pcl
