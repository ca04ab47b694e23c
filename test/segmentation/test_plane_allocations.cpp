// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "plane_clouds.h"

#include <gtest/gtest.h>

using namespace plane_clouds;

namespace {

struct Settings {
  const char* name;
  bool use_indices;
  pcl::rgbd_planes::NormalSpaceGrid grid;
};

class PlaneAllocations : public ::testing::TestWithParam<Settings> {};

/** Everything that the class gives. */
struct Outputs {
  Result result;
  Ours::Regions regions;
  Ours::PointCloudLPtr labels;
  std::vector<pcl::PointIndices> boundaries, segments;
  std::vector<std::size_t> plane_of_segment;

  void
  fill (Ours& segmentation)
  {
    segment (segmentation, result);
    segmentation.segmentAndRefine (regions);
    segmentation.segmentAndRefine (regions,
                                   result.models,
                                   result.inliers,
                                   labels,
                                   result.label_indices,
                                   boundaries);
    segmentation.getSegments (segments, plane_of_segment);
  }
};

} // namespace

TEST_P (PlaneAllocations, NoneForFramesLikeThoseBefore)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  std::vector<Cloud::ConstPtr> frames;
  std::vector<Normals::ConstPtr> normals;
  for (const float noise : {0.f, 0.5f, 1.f}) {
    const Scene scene = render (
        corner(), 320, 240, [noise] (float z) { return noise * kinectSigma (z); });
    scene.cloud->header.frame_id = "the optical frame of the depth camera";
    frames.push_back (scene.cloud);
    normals.push_back (estimateNormals (scene.cloud));
  }
  Ours segmentation;
  segmentation.setMinInliers (250);
  segmentation.setNormalSpaceGrid (GetParam().grid);
  if (GetParam().use_indices) {
    auto indices = pcl::make_shared<pcl::Indices>();
    for (pcl::index_t i = 0; i < 320 * 240; i += 2)
      indices->push_back (i);
    segmentation.setIndices (indices);
  }
  Outputs outputs;
  for (const bool first_round : {true, false})
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const std::size_t before = allocations;
      segmentation.setInputCloud (frames[i]);
      segmentation.setInputNormals (normals[i]);
      outputs.fill (segmentation);
      const std::size_t count = allocations - before;
      ASSERT_EQ (outputs.regions.size(), 3u);
      if (first_round && i == 0) {
        EXPECT_GT (count, 0u) << "the counter sees nothing";
      }
      if (!first_round) {
        EXPECT_EQ (count, 0u) << "frame " << i;
      }
    }
}

INSTANTIATE_TEST_SUITE_P (
    Settings,
    PlaneAllocations,
    ::testing::Values (
        Settings{"Voxels", false, pcl::rgbd_planes::NormalSpaceGrid::voxels},
        Settings{"Spherical", false, pcl::rgbd_planes::NormalSpaceGrid::spherical},
        Settings{"Indices", true, pcl::rgbd_planes::NormalSpaceGrid::voxels}),
    [] (const auto& setting) { return setting.param.name; });
