// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace plane_clouds;

namespace {

/** The connected parts of the labels of planes, by first pixels. */
std::vector<pcl::Indices>
floodFill (const pcl::PointCloud<pcl::Label>& labels)
{
  const int width = static_cast<int> (labels.width);
  std::vector<bool> seen (labels.size(), false);
  std::vector<pcl::Indices> parts;
  for (std::size_t start = 0; start < labels.size(); ++start) {
    if (seen[start] || labels[start].label == Ours::unlabelled)
      continue;
    pcl::Indices part{static_cast<pcl::index_t> (start)};
    seen[start] = true;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) {
          const int u = part[i] % width + du, v = part[i] / width + dv;
          if (u < 0 || u >= width || v < 0 || v >= static_cast<int> (labels.height))
            continue;
          const auto pixel = static_cast<std::size_t> (v * width + u);
          if (!seen[pixel] && labels[pixel].label == labels[start].label) {
            seen[pixel] = true;
            part.push_back (static_cast<pcl::index_t> (pixel));
          }
        }
    std::sort (part.begin(), part.end());
    parts.push_back (part);
  }
  return parts;
}

} // namespace

TEST (PlaneSegments, AreTheConnectedPartsOfThePlanes)
{
  std::vector<Surface> surfaces = corner();
  surfaces.push_back (board (100, 104, 0, 240));
  surfaces.push_back (board (30, 34, 0, 240));
  const Scene scene = render (surfaces, 320, 240, kinectSigma);
  scene.cloud->header.frame_id = "camera";
  Ours segmentation;
  std::vector<pcl::PointIndices> segments;
  std::vector<std::size_t> planes;
  segmentation.getSegments (segments, planes);
  EXPECT_TRUE (segments.empty()) << "nothing was segmented";
  for (const unsigned min_inliers : {5000u, 1000u, 250u, 1u}) {
    segmentation.setMinInliers (min_inliers);
    Result result;
    segment (segmentation, scene.cloud, result);
    segmentation.getSegments (segments, planes);
    auto expected = floodFill (result.labels);
    expected.erase (std::remove_if (expected.begin(),
                                    expected.end(),
                                    [=] (const pcl::Indices& part) {
                                      return part.size() < min_inliers;
                                    }),
                    expected.end());
    ASSERT_EQ (segments.size(), expected.size());
    ASSERT_EQ (planes.size(), expected.size());
    EXPECT_GT (segments.size(), result.models.size() - (min_inliers == 5000u));
    for (std::size_t s = 0; s < segments.size(); ++s) {
      EXPECT_EQ (segments[s].header.frame_id, "camera");
      EXPECT_EQ (segments[s].indices, expected[s]);
      EXPECT_EQ (planes[s], result.labels[expected[s][0]].label);
    }
  }
}
