// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "table_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace table_objects;

TEST (ObjectInputs, MissingPoints)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float bad[3][3] = {{nan, nan, nan}, {inf, 0.f, inf}, {0.f, 0.f, 0.f}};
  std::mt19937 random (1);
  for (std::size_t i = 0; i < view.cloud->size(); ++i)
    if (random() % 20 == 0) {
      (*view.cloud)[i].getVector3fMap() =
          Eigen::Map<const Vector3f> (bad[random() % 3]);
      (*view.normals)[i].getNormalVector3fMap().setConstant (nan);
      view.box[i] = -1;
    }
  Extraction extraction;
  for (const bool split : {false, true}) {
    extraction.setSplitAtConcaveEdges (split);
    const Objects objects = extract (extraction, view);
    ASSERT_EQ (objects.size(), 1u);
    EXPECT_GT (iou (objects.front(), view, 2), 0.85);
    for (const auto i : objects.front().indices.indices)
      EXPECT_TRUE (pcl::rgbd_planes::isMeasured ((*view.cloud)[i].data));
  }
}

TEST (ObjectInputs, PlanesMayHaveAnySignAndLength)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const Objects expected = extract (view);
  ASSERT_EQ (expected.size(), 1u);
  for (auto& model : view.models)
    for (float& value : model.values)
      value *= -2.f;
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_EQ (objects[0].indices.indices, expected[0].indices.indices);
}

TEST (ObjectInputs, HonoursIndices)
{
  const View view = look ({floor_slab,
                           table,
                           onTable (1.f, 0.2f, {0.1f, 0.1f, 0.1f}),
                           onTable (1.f, -0.2f, {0.1f, 0.1f, 0.1f})});
  const auto kept = view.pixelsOf (3);
  Extraction extraction;
  extraction.setIndices (pcl::make_shared<pcl::Indices> (kept.begin(), kept.end()));
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 3), 0.85);

  extraction.setIndices (pcl::IndicesPtr()); // the whole cloud again
  EXPECT_EQ (extract (extraction, view).size(), 2u);
}

TEST (ObjectInputs, AnotherSizeAndACopy)
{
  const std::vector<Box> boxes{
      floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})};
  Camera small;
  small.width = 161;
  small.image_height = 121;
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  const View large_view = look (boxes), small_view = look (boxes, small);
  const Objects first = extract (extraction, large_view);
  EXPECT_EQ (extract (extraction, small_view).size(), 1u);
  Extraction copy = extraction;
  const Objects again = extract (copy, large_view);
  ASSERT_EQ (first.size(), 1u);
  ASSERT_EQ (again.size(), 1u);
  EXPECT_EQ (first.front().indices.indices, again.front().indices.indices);
  EXPECT_EQ (first.front().box_size, again.front().box_size);
}

TEST (ObjectInputs, NoAllocationsForFramesLikeThoseBefore)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  // With a strip of the wall, which becomes a cluster, but no object.
  const View view = wallBehindATable();
  for (const bool split : {false, true}) {
    Extraction extraction;
    extraction.setSplitAtConcaveEdges (split);
    extraction.setCameraToBase (view.camera_to_base);
    extraction.setInputCloud (view.cloud);
    extraction.setInputNormals (view.normals);
    Objects objects;
    // Planes are sorted, and with them their memory: some frames later each has enough.
    for (int frame = 0; frame < 5; ++frame) {
      const std::size_t before = allocations;
      extraction.extract (view.models, view.inliers, objects);
      const std::size_t count = allocations - before;
      EXPECT_FALSE (objects.empty());
      if (frame == 0) {
        EXPECT_GT (count, 0u) << "the counter sees nothing";
      }
      if (frame == 4) {
        EXPECT_EQ (count, 0u) << (split ? "split" : "whole");
      }
    }
  }
}

TEST (ObjectInputs, APoseThatNobodyGaveIsToldOnceInARow)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const auto warningOf = [&] (Extraction& extraction) {
    Objects objects;
    extraction.setInputCloud (view.cloud);
    testing::internal::CaptureStderr();
    extraction.extract (view.models, view.inliers, objects);
    return testing::internal::GetCapturedStderr();
  };
  Extraction extraction;
  EXPECT_NE (warningOf (extraction).find ("setCameraToBase"), std::string::npos);
  EXPECT_EQ (warningOf (extraction), "");
  extraction.setCameraToBase (view.camera_to_base);
  EXPECT_EQ (warningOf (extraction), "");
  extraction.setPlaneHeights (2., 3.);
  EXPECT_EQ (warningOf (extraction), "") << "none in sight is at that height";

  View no_planes = view;
  no_planes.models.clear();
  no_planes.inliers.clear();
  Extraction other;
  Objects objects;
  other.setInputCloud (view.cloud);
  testing::internal::CaptureStderr();
  other.extract (no_planes.models, no_planes.inliers, objects);
  EXPECT_EQ (testing::internal::GetCapturedStderr(), "") << "no pose makes some";
}

TEST (ObjectInputs, NormalsWithoutUnitLengthAreToldWhereTheySplit)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  const auto warningOf = [&] {
    testing::internal::CaptureStderr();
    extract (extraction, view);
    return testing::internal::GetCapturedStderr();
  };
  extraction.setSplitAtConcaveEdges (true);
  EXPECT_EQ (warningOf(), "");
  for (auto& normal : *view.normals)
    normal.getNormalVector3fMap() *= 2.f;
  EXPECT_NE (warningOf().find ("no normal has a length of 1"), std::string::npos);
  EXPECT_EQ (warningOf(), "");
  extraction.setSplitAtConcaveEdges (false);
  EXPECT_EQ (warningOf(), "");
}

TEST (ObjectInputs, LinesOfPixelsAreNoObjectsHoweverFewPointsTheseNeed)
{
  const View view = look ({floor_slab, table});
  const auto lift =
      [&] (std::uint32_t first, std::uint32_t columns, std::uint32_t rows) {
        const std::uint32_t middle = view.cloud->height / 2;
        for (std::uint32_t v = middle; v < middle + rows; ++v)
          for (std::uint32_t u = first; u < first + columns; ++u)
            view.cloud->at (u, v).getVector3fMap() *= 0.9f;
      };
  const std::uint32_t third = view.cloud->width / 3;
  lift (third, 1, 1);
  lift (third + 10, 5, 1);
  lift (third + 20, 1, 5);
  Extraction extraction;
  extraction.setMinPoints (1);
  EXPECT_TRUE (extract (extraction, view).empty());
  lift (third + 30, 4, 4);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_EQ (objects[0].indices.indices.size(), 16u);
}

TEST (ObjectInputs, IndicesCarryTheHeaderOfTheCloud)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  view.cloud->header.frame_id = "camera";
  view.cloud->header.stamp = 7;
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_EQ (objects[0].indices.header.frame_id, "camera");
  EXPECT_EQ (objects[0].indices.header.stamp, 7u);
}

TEST (ObjectInputs, RefusesBadInput)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  Objects objects (1);
  extraction.extract (view.models, view.inliers, objects); // no cloud
  EXPECT_TRUE (objects.empty());

  View unorganized = view;
  unorganized.cloud = pcl::make_shared<table_scenes::Cloud> (*view.cloud);
  unorganized.cloud->width = static_cast<std::uint32_t> (view.cloud->size());
  unorganized.cloud->height = 1;
  EXPECT_TRUE (extract (unorganized).empty());

  View fewer_inliers = view;
  fewer_inliers.inliers.pop_back();
  EXPECT_TRUE (extract (fewer_inliers).empty());
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  EXPECT_FALSE (extraction.getSupportPlanes().empty());
  EXPECT_TRUE (extract (extraction, fewer_inliers).empty());
  EXPECT_TRUE (extraction.getSupportPlanes().empty());

  const auto size = static_cast<pcl::index_t> (view.cloud->size());
  for (const pcl::index_t index :
       {size, 1000000, -1, std::numeric_limits<int>::min()}) {
    View other_cloud = view;
    other_cloud.inliers.front().indices.push_back (index);
    EXPECT_TRUE (extract (other_cloud).empty()) << index;
  }

  View short_model = view;
  short_model.models.front().values.pop_back();
  EXPECT_TRUE (extract (short_model).empty());

  View no_normals = view;
  no_normals.normals = nullptr;
  EXPECT_EQ (extract (no_normals).size(), 1u);
  Extraction split;
  split.setSplitAtConcaveEdges (true);
  EXPECT_TRUE (extract (split, no_normals).empty());
  View fewer_normals = view;
  fewer_normals.normals = pcl::make_shared<table_scenes::Normals> (*view.normals);
  fewer_normals.normals->points.pop_back();
  EXPECT_TRUE (extract (split, fewer_normals).empty());
  View other_shape = view;
  other_shape.normals = pcl::make_shared<table_scenes::Normals> (*view.normals);
  std::swap (other_shape.normals->width, other_shape.normals->height);
  EXPECT_TRUE (extract (split, other_shape).empty());
}

TEST (ObjectInputs, DefaultsAreThoseOfThePaper)
{
  const Extraction extraction;
  EXPECT_FLOAT_EQ (extraction.getHorizontalTolerance(), 0.26f);
  EXPECT_FLOAT_EQ (extraction.getClusterTolerance(), 1.f);
  EXPECT_FALSE (extraction.getSplitAtConcaveEdges());
  EXPECT_FLOAT_EQ (extraction.getMinPlaneHeight(), 0.f);
  EXPECT_FLOAT_EQ (extraction.getMaxPlaneHeight(), 1.2f);
  EXPECT_FLOAT_EQ (extraction.getMaxObjectHeight(), 0.3f);
  EXPECT_EQ (extraction.getMinPoints(), 50u);
  EXPECT_FLOAT_EQ (extraction.getMinGraspableSide(), 0.01f);
  EXPECT_FLOAT_EQ (extraction.getMaxGraspableSide(), 0.1f);
}

TEST (ObjectInputs, RefusesBadParameters)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Extraction extraction;
  extraction.setMaxObjectHeight (0.);
  EXPECT_FLOAT_EQ (extraction.getMaxObjectHeight(), 0.3f);
  extraction.setMinObjectHeight (nan);
  EXPECT_FLOAT_EQ (extraction.getMinObjectHeight(), 0.01f);
  extraction.setHullTolerance (-0.1);
  EXPECT_FLOAT_EQ (extraction.getHullTolerance(), 0.03f);
  extraction.setHullTolerance (0.);
  EXPECT_EQ (extraction.getHullTolerance(), 0.);
  extraction.setMaxOverhang (-0.1);
  EXPECT_FLOAT_EQ (extraction.getMaxOverhang(), 0.2f);
  extraction.setHorizontalTolerance (static_cast<float> (M_PI / 2.)); // above M_PI / 2
  EXPECT_FLOAT_EQ (extraction.getHorizontalTolerance(), static_cast<float> (M_PI / 2.));
  extraction.setHorizontalTolerance (0.26);
  extraction.setHorizontalTolerance (2.);
  EXPECT_FLOAT_EQ (extraction.getHorizontalTolerance(), 0.26f);
  extraction.setPlaneHeights (1., 0.5);
  EXPECT_FLOAT_EQ (extraction.getMaxPlaneHeight(), 1.2f);
  extraction.setPlaneHeights (-0.5, 1.2);
  EXPECT_FLOAT_EQ (extraction.getMinPlaneHeight(), -0.5f);
  extraction.setGraspableSides (nan, 0.5);
  extraction.setGraspableSides (-0.01, 0.5);
  EXPECT_FLOAT_EQ (extraction.getMaxGraspableSide(), 0.1f);
  extraction.setDepthNoise ({-0.001f, 0.002f});
  EXPECT_EQ (extraction.getDepthNoise().constant, 0.001f);
  extraction.setCameraToBase (Eigen::Affine3f (Eigen::Scaling (2.f)));
  EXPECT_TRUE (extraction.getCameraToBase().linear().isUnitary (1e-4f));
}
