// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "normal_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>

#include <gtest/gtest.h>

#include <cstddef>

using namespace normal_clouds;

namespace {

struct Settings {
  const char* name;
  bool edge_aware;
  bool use_indices;
  unsigned int threads;
};

class TangentNormalAllocations : public ::testing::TestWithParam<Settings> {};

} // namespace

TEST_P (TangentNormalAllocations, NoneAfterTheFirstFrame)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  // The first frame is the simplest: no holes, no creases, no noise.
  const std::vector<Cloud::ConstPtr> frames{
      synthetic::render ({synthetic::tiltedPlane (1.f, 0.f, 0.f)}, 160, 120).cloud,
      makeHoles(),
      synthetic::render (twoWalls(), 160, 120, [] (float) { return 0.01f; }).cloud};
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setEdgeAware (GetParam().edge_aware);
  estimation.setNumberOfThreads (GetParam().threads);
  if (GetParam().use_indices)
    estimation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{5, 3, 1000}));
  Normals normals;
  std::vector<std::size_t> counts;
  counts.reserve (frames.size());
  for (const auto& frame : frames) {
    const std::size_t before = allocations;
    estimation.setInputCloud (frame);
    estimation.compute (normals);
    counts.push_back (allocations - before);
  }
  EXPECT_GT (counts[0], 0u) << "the counter sees nothing";
  EXPECT_EQ (counts[1], 0u);
  EXPECT_EQ (counts[2], 0u);
}

INSTANTIATE_TEST_SUITE_P (Settings,
                          TangentNormalAllocations,
                          ::testing::Values (Settings{"Default", true, false, 1},
                                             Settings{"Plain", false, false, 1},
                                             Settings{"Indices", true, true, 1},
                                             Settings{"TwoThreads", true, false, 2}),
                          [] (const auto& setting) { return setting.param.name; });
