// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// The templates themselves, for point types that the library does not know.
#define PCL_NO_PRECOMPILE

#include "normal_clouds.h"
#include "vector_map.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/register_point_struct.h>

#include <gtest/gtest.h>

#include <cmath>

/** A measurement of a camera that knows how sure it is. */
struct EIGEN_ALIGN16 SensedPoint {
  float confidence;
  PCL_ADD_POINT4D
  std::uint32_t time;
};

/** A normal before its point, without the padding of PCL's types. */
struct Surfel {
  float radius;
  float normal_x, normal_y, normal_z;
  float curvature;
  float x, y, z;
  ADD_VECTOR_MAP
};

POINT_CLOUD_REGISTER_POINT_STRUCT (
    SensedPoint,
    (float,
     confidence,
     confidence) (float, x, x) (float, y, y) (float, z, z) (std::uint32_t, time, time))
POINT_CLOUD_REGISTER_POINT_STRUCT (
    Surfel,
    (float, radius, radius) (float, normal_x, normal_x) (float, normal_y, normal_y) (
        float, normal_z, normal_z) (float, curvature, curvature) (float, x, x) (
        float, y, y) (float, z, z))

using namespace normal_clouds;

namespace {

template <template <typename, typename> class Estimation>
void
expectNormalsOfPlane ()
{
  const auto plane = synthetic::tiltedPlane (1.f, 10.f, 20.f);
  const Cloud::Ptr image = synthetic::render ({plane}, 160, 120).cloud;
  const auto cloud = pcl::make_shared<pcl::PointCloud<SensedPoint>> (160, 120);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].getVector3fMap() = (*image)[i].getVector3fMap();
  (*cloud)[7].z = synthetic::nan;

  Estimation<SensedPoint, Surfel> estimation;
  estimation.setInputCloud (cloud);
  Surfel untouched{};
  untouched.radius = 5.f;
  pcl::PointCloud<Surfel> surfels (160, 120, untouched);
  estimation.compute (surfels);
  ASSERT_EQ (surfels.width, 160u);
  ASSERT_EQ (surfels.height, 120u);
  EXPECT_FALSE (surfels.is_dense);
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const Surfel& s = surfels[i];
    ASSERT_EQ (s.radius, 5.f);
    ASSERT_EQ (s.x, (*cloud)[i].x);
    ASSERT_EQ (s.y, (*cloud)[i].y);
    if (i == 7) {
      ASSERT_TRUE (std::isnan (s.z) && std::isnan (s.normal_x) &&
                   std::isnan (s.curvature));
      continue;
    }
    ASSERT_EQ (s.z, (*cloud)[i].z);
    const Eigen::Vector3f normal (s.normal_x, s.normal_y, s.normal_z);
    ASSERT_LE (synthetic::angleDegrees (normal, plane.normal), 0.1f) << i;
    ASSERT_NEAR (normal.norm(), 1.f, 1e-5f);
    ASSERT_NEAR (s.curvature, 0.f, 1e-5f);
  }
}

} // namespace

TEST (CustomPointNormals, IntegralImageTangentNormalEstimation)
{
  expectNormalsOfPlane<pcl::IntegralImageTangentNormalEstimation>();
}

TEST (CustomPointNormals, TwoRunNormalEstimation)
{
  expectNormalsOfPlane<pcl::TwoRunNormalEstimation>();
}
