// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/common/point_tests.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <gtest/gtest.h>

#include <vector>

namespace plane_clouds {

using synthetic::Cloud;
using synthetic::render;
using synthetic::Scene;
using synthetic::Surface;
using synthetic::tiltedPlane;
using Normals = pcl::PointCloud<pcl::Normal>;
using Ours = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;

/** The outputs, of the types that OrganizedMultiPlaneSegmentation takes. */
struct Result {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> centroids;
  std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>> covariances;
  pcl::PointCloud<pcl::Label> labels;

  Eigen::Vector3f
  normal (std::size_t k) const
  {
    return Eigen::Vector3f (models[k].values.data());
  }
};

inline Normals::Ptr
estimateNormals (const Cloud::ConstPtr& cloud)
{
  auto normals = pcl::make_shared<Normals>();
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);
  return normals;
}

/** The true normals of what each pixel sees. */
inline Normals::Ptr
trueNormals (const Scene& scene, const std::vector<Surface>& surfaces)
{
  auto normals = pcl::make_shared<Normals> (scene.cloud->width, scene.cloud->height);
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (scene.surface[i] >= 0)
      (*normals)[i].getNormalVector3fMap() =
          surfaces[static_cast<std::size_t> (scene.surface[i])].normal;
  return normals;
}

/** What is found with the noise of a Kinect. */
inline pcl::rgbd_planes::PlaneExtraction
extract (const Cloud& cloud,
         const Normals& normals,
         const pcl::rgbd_planes::PlaneAdditions& additions)
{
  pcl::rgbd_planes::PlaneExtractionParameters parameters;
  parameters.additions = additions;
  parameters.noise = pcl::rgbd_planes::DepthNoise();
  pcl::rgbd_planes::PlaneExtraction extraction;
  extraction.compute (pcl::rgbd_planes::viewPoints (cloud),
                      {&normals[0].normal_x,
                       &normals[0].curvature,
                       sizeof (pcl::Normal) / sizeof (float)},
                      {},
                      parameters);
  return extraction;
}

template <typename Segmentation>
void
segment (Segmentation& segmentation, Result& result)
{
  segmentation.segment (result.models,
                        result.inliers,
                        result.centroids,
                        result.covariances,
                        result.labels,
                        result.label_indices);
}

/** Sets the input of \a segmentation and runs it. */
template <typename Segmentation>
void
segment (Segmentation& segmentation, const Cloud::ConstPtr& cloud, Result& result)
{
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (estimateNormals (cloud));
  segment (segmentation, result);
}

inline void
expectSame (const Result& a, const Result& b)
{
  ASSERT_EQ (a.models.size(), b.models.size());
  ASSERT_EQ (a.inliers.size(), b.inliers.size());
  ASSERT_EQ (a.centroids.size(), b.centroids.size());
  ASSERT_EQ (a.covariances.size(), b.covariances.size());
  ASSERT_EQ (a.label_indices.size(), b.label_indices.size());
  for (std::size_t k = 0; k < a.models.size(); ++k) {
    EXPECT_EQ (a.models[k].values, b.models[k].values);
    EXPECT_EQ (a.inliers[k].indices, b.inliers[k].indices);
    EXPECT_EQ (a.label_indices[k].indices, b.label_indices[k].indices);
  }
  ASSERT_EQ (a.labels.width, b.labels.width);
  ASSERT_EQ (a.labels.height, b.labels.height);
  for (std::size_t i = 0; i < a.labels.size(); ++i)
    ASSERT_EQ (a.labels[i].label, b.labels[i].label) << i;
}

/** The points of planes, in percent of the measured points. */
inline double
coveredPercent (const Result& result, const Cloud& cloud)
{
  std::size_t measured = 0, covered = 0;
  for (const auto& point : cloud)
    measured += pcl::isFinite (point) && point.z != 0.f;
  for (const auto& inliers : result.inliers)
    covered += inliers.indices.size();
  return 100. * static_cast<double> (covered) / static_cast<double> (measured);
}

inline float
kinectSigma (float z)
{
  return 0.001f + 0.002f * z * z;
}

/** Two walls that meet, above a floor. */
inline const std::vector<Surface>&
corner ()
{
  static const std::vector<Surface> surfaces{tiltedPlane (2.f, 0.f, 50.f),
                                             tiltedPlane (2.2f, 0.f, -40.f),
                                             {{0.f, -1.f, 0.f}, 0.7f}};
  return surfaces;
}

/** A board at 1 m that covers columns u0 ... u1 - 1, rows v0 ... v1 - 1. */
inline Surface
board (int u0, int u1, int v0, int v1)
{
  return {{0.f, 0.f, -1.f}, 1.f, [=] (int u, int v) {
            return u >= u0 && u < u1 && v >= v0 && v < v1;
          }};
}

} // namespace plane_clouds
