// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/supported_object_extraction.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace plane_clouds;
using pcl::rgbd_planes::Sensor;
using pcl::rgbd_planes::SimulatedFrame;

namespace {

struct Counts {
  std::size_t things = 0, found = 0, others = 0;
};

/** Adds the things of 200 measured points and more, how many of them an object has most of its
 * points on, and the objects that have not on any. */
void
count (const SimulatedFrame& frame, Counts& counts)
{
  auto cloud = pcl::make_shared<Cloud>();
  pcl::copyPointCloud (*frame.cloud, *cloud);
  Ours segmentation;
  Result result;
  plane_clouds::segment (segmentation, cloud, result);
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
  extraction.setCameraToBase (frame.camera_to_base);
  extraction.setInputCloud (cloud);
  std::vector<pcl::SupportedObject> objects;
  extraction.extract (result.models, result.inliers, objects);

  std::map<std::uint32_t, std::size_t> points;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    points[(*frame.truth)[i].object] += pcl::isFinite ((*cloud)[i]);
  std::set<std::uint32_t> found;
  for (const auto& object : objects) {
    std::map<std::uint32_t, std::size_t> of_thing;
    for (const auto i : object.indices.indices)
      ++of_thing[(*frame.truth)[static_cast<std::size_t> (i)].object];
    const auto most = std::max_element (
        of_thing.begin(), of_thing.end(), [] (const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (most->first == 0)
      ++counts.others;
    else if (2 * most->second > points[most->first])
      found.insert (most->first);
  }
  for (const auto& [thing, size] : points)
    if (thing != 0 && size >= 200) {
      ++counts.things;
      counts.found += found.count (thing);
    }
}

} // namespace

TEST (Shelves, ThingsOnAllBoardsAreObjectsAndSidePanelsAreNone)
{
  Counts counts;
  for (unsigned seed = 1; seed <= 10; ++seed)
    count (pcl::rgbd_planes::simulate ("shelf", seed, Sensor::kinect), counts);
  EXPECT_GE (counts.things, 120u);
  EXPECT_GE (counts.found * 100, counts.things * 95)
      << counts.found << " of " << counts.things;
  EXPECT_LE (counts.others, 4u);
}
