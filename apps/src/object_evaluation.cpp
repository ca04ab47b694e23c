// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/object_evaluation.h>
#include <pcl/apps/statistics.h>

#include <Eigen/Geometry>

#include <map>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::size_t min_points = 50;
constexpr float max_range_m = 3.5f;
constexpr float min_height_m = 0.01f;
constexpr float max_height_m = 0.3f;
constexpr float apart_m = 0.02f;

/** The measured points of a true object. */
struct Region {
  const TrueObject* object = nullptr;
  std::vector<Eigen::Vector3f> positions;
  Eigen::AlignedBox3f bounds;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  /** With at least half of their points on it. */
  std::size_t clusters = 0;

  bool
  isAskedFor () const
  {
    const auto points = static_cast<float> (positions.size());
    return positions.size() >= min_points && (sum / points).norm() <= max_range_m &&
           (!object ||
            (object->size.z() >= min_height_m && object->size.z() <= max_height_m));
  }
};

using Regions = std::map<std::uint32_t, Region>;

Regions
collectRegions (const OrganizedPoints& points,
                const OrganizedPoints& positions,
                const ObjectTruth& truth)
{
  Regions regions;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (truth.ids[i] == 0 || !isMeasured (points[i]))
      continue;
    Region& region = regions[truth.ids[i]];
    const Eigen::Map<const Eigen::Vector3f> position (positions[i]);
    region.positions.emplace_back (position);
    region.bounds.extend (region.positions.back());
    region.sum += position;
  }
  for (const auto& object : truth.objects) {
    const auto region = regions.find (object.id);
    if (region != regions.end())
      region->second.object = &object;
  }
  return regions;
}

/** The points of \a region that may be near \a other. */
std::vector<Eigen::Vector3f>
pointsNear (const Region& region, const Region& other)
{
  std::vector<Eigen::Vector3f> near;
  for (const auto& p : region.positions)
    if (other.bounds.squaredExteriorDistance (p) <= apart_m * apart_m)
      near.push_back (p);
  return near;
}

bool
areApart (const Region& a, const Region& b)
{
  const auto near_a = pointsNear (a, b);
  const auto near_b = pointsNear (b, a);
  for (const auto& p : near_a)
    for (const auto& q : near_b)
      if ((p - q).squaredNorm() <= apart_m * apart_m)
        return false;
  return true;
}

/** The sides, the two horizontal ones by size. */
Eigen::Vector3f
sorted (Eigen::Vector3f size)
{
  if (size.x() > size.y())
    std::swap (size.x(), size.y());
  return size;
}

bool
isGraspable (const Eigen::Vector3f& size)
{
  return size.minCoeff() >= 0.01f && size.minCoeff() <= 0.1f;
}

/** How far off the sides of a box may be. */
Eigen::Array3f
tolerance (const Eigen::Vector3f& size)
{
  return (0.1f * size).array().max (0.01f);
}

bool
sidesAreRight (const Eigen::Vector3f& truth, const Eigen::Vector3f& found)
{
  const Eigen::Array3f error = (sorted (truth) - sorted (found)).array().abs();
  return (error <= tolerance (sorted (truth))).all();
}

/** Whether points of a box are spread over its sides, and up to its top. */
bool
isSeen (const TrueObject& box, const std::vector<Eigen::Vector3f>& positions)
{
  const Eigen::Affine3f to_box = box.pose.inverse();
  Eigen::AlignedBox3f seen;
  for (const auto& p : positions)
    seen.extend (to_box * p);
  const Eigen::Vector3f sides (seen.sizes().x(), seen.sizes().y(), seen.max().z());
  return ((box.size - sides).array() <= tolerance (box.size)).all();
}

} // namespace

std::vector<FoundObject>
foundObjects (const std::vector<pcl::SupportedObject>& objects)
{
  std::vector<FoundObject> found;
  for (const auto& object : objects)
    found.push_back ({object.indices.indices, object.box_size, object.graspable});
  return found;
}

ObjectCounts&
ObjectCounts::operator+= (const ObjectCounts& other)
{
  objects += other.objects;
  found_50 += other.found_50;
  found_80 += other.found_80;
  in_pieces += other.in_pieces;
  return *this;
}

void
lookAtFullSize (const OrganizedPoints& points,
                const OrganizedPoints& positions,
                ObjectTruth& truth)
{
  const Regions regions = collectRegions (points, positions, truth);
  for (auto a = regions.begin(); a != regions.end(); ++a) {
    if (a->second.isAskedFor())
      truth.full_size.insert (a->first);
    for (auto b = std::next (a); b != regions.end(); ++b)
      if ((!truth.touching.count (a->first) || !truth.touching.count (b->first)) &&
          !areApart (a->second, b->second))
        truth.touching.insert ({a->first, b->first});
  }
}

void
ObjectEvaluation::add (const OrganizedPoints& points,
                       const OrganizedPoints& positions,
                       const ObjectTruth& truth,
                       const std::vector<FoundObject>& found_objects)
{
  Regions regions = collectRegions (points, positions, truth);
  for (std::size_t i = 0; i < points.size(); ++i)
    measured_ += isMeasured (points[i]);

  std::set<std::uint32_t> taken;
  for (const auto& object : found_objects) {
    std::map<std::uint32_t, std::size_t> common;
    std::size_t on_objects = 0;
    for (const auto index : object.indices)
      if (const auto id = truth.ids[static_cast<std::size_t> (index)]) {
        ++common[id];
        ++on_objects;
      }
    ++found;
    if (2 * on_objects < object.indices.size()) {
      ++false_objects;
      false_points_ += object.indices.size();
    }
    for (const auto& [id, both] : common)
      regions[id].clusters += 2 * both >= object.indices.size();
    for (const auto& [id, both] : common) {
      const Region& region = regions[id];
      const double iou =
          static_cast<double> (both) /
          static_cast<double> (region.positions.size() + object.indices.size() - both);
      // Only at exactly one half could a second pair have either of the two.
      if (iou < 0.5 || !taken.insert (id).second)
        continue;
      full_size_found += truth.full_size.count (id);
      if (!region.isAskedFor())
        break;
      const bool is_apart = truth.touching.count (id) == 0;
      ObjectCounts& counts = is_apart ? apart : touching;
      ++counts.found_50;
      counts.found_80 += iou >= 0.8;
      if (is_apart && region.object)
        countSize (*region.object, region.positions, object);
      break;
    }
  }
  full_size_objects += truth.full_size.size();
  for (const auto& [id, region] : regions)
    if (region.isAskedFor()) {
      ObjectCounts& counts = truth.touching.count (id) ? touching : apart;
      ++counts.objects;
      counts.in_pieces += region.clusters > 1;
    }
}

void
ObjectEvaluation::countSize (const TrueObject& object,
                             const std::vector<Eigen::Vector3f>& positions,
                             const FoundObject& found_object)
{
  ++sized;
  graspable_right += isGraspable (object.size) == found_object.graspable;
  if (object.shape != TrueObject::Shape::box)
    return;
  ++boxes;
  const bool right = sidesAreRight (object.size, found_object.size);
  const bool seen = isSeen (object, positions);
  boxes_right += right;
  boxes_seen += seen;
  boxes_seen_right += seen && right;
}

ObjectCounts
ObjectEvaluation::all() const
{
  ObjectCounts sum = apart;
  sum += touching;
  return sum;
}

double
ObjectEvaluation::falsePointsPercent() const
{
  return percentOf (false_points_, measured_);
}

} // namespace rgbd_planes
} // namespace pcl
