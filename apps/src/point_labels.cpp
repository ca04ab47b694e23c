// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/point_labels.h>
#include <pcl/type_traits.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

bool
hasField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  return std::any_of (cloud.fields.begin(),
                      cloud.fields.end(),
                      [&] (const auto& field) { return field.name == name; });
}

/** The values of a field; none where it is of another type. */
template <typename Value>
std::vector<Value>
valuesOf (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  std::vector<Value> values;
  for (const auto& field : cloud.fields)
    if (field.name == name && field.datatype == pcl::traits::asEnum<Value>::value &&
        field.offset + sizeof (Value) <= cloud.point_step) {
      values.resize (cloud.data.size() / cloud.point_step);
      for (std::size_t i = 0; i < values.size(); ++i)
        std::memcpy (&values[i],
                     cloud.data.data() + i * cloud.point_step + field.offset,
                     sizeof (Value));
    }
  return values;
}

bool
areObjectsOfMosd (const std::vector<std::uint32_t>& labels)
{
  const auto isTable = [] (std::uint32_t label) { return label >= 1 && label <= 9; };
  const auto isUnknown = [] (std::uint32_t label) {
    return label >= 10 && label <= 19;
  };
  return std::any_of (labels.begin(), labels.end(), isTable) &&
         std::none_of (labels.begin(), labels.end(), isUnknown);
}

/** Whole numbers, several ones, mostly with their like beside them. */
bool
arePlanes (const std::vector<float>& intensities)
{
  constexpr float max_label = 1e6f;
  std::size_t alike = 0;
  for (std::size_t i = 1; i < intensities.size(); ++i)
    alike += intensities[i] == intensities[i - 1];
  return 2 * alike >= intensities.size() && alike + 1 < intensities.size() &&
         std::all_of (intensities.begin(), intensities.end(), [] (float intensity) {
           return intensity >= 0.f && intensity <= max_label &&
                  std::floor (intensity) == intensity;
         });
}

template <typename Value>
PointLabels
makeLabels (PointLabels::Kind kind,
            const std::vector<Value>& values,
            const pcl::PCLPointCloud2& cloud)
{
  PointLabels labels{kind, {cloud.width, cloud.height}};
  for (std::size_t i = 0; i < values.size(); ++i)
    labels.points[i].label = static_cast<std::uint32_t> (values[i]);
  return labels;
}

} // namespace

PointLabels
readPointLabels (const pcl::PCLPointCloud2& cloud)
{
  if (hasField (cloud, "label") == hasField (cloud, "intensity") ||
      hasField (cloud, "normal_x"))
    return {};
  const auto objects = valuesOf<std::uint32_t> (cloud, "label");
  if (areObjectsOfMosd (objects))
    return makeLabels (PointLabels::Kind::objects, objects, cloud);
  const auto planes = valuesOf<float> (cloud, "intensity");
  if (arePlanes (planes))
    return makeLabels (PointLabels::Kind::planes, planes, cloud);
  return {};
}

} // namespace rgbd_planes
} // namespace pcl
