// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/features/depth_noise.h>
#include <pcl/filters/project_onto_planes.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

/** Squared distances at ranges of 3.5 to 6 m, away from edges. */
struct Residuals {
  double before = 0., after = 0.;

  double
  improvement () const
  {
    return std::sqrt (before / after);
  }
};

bool
counts (const pcl::rgbd_planes::TruthPoint& truth, const pcl::PointXYZ& point)
{
  const float range = truth.getVector3fMap().norm();
  return truth.label != 0 && truth.edge == 0 && range >= 3.5f && range <= 6.f &&
         std::isfinite (point.z);
}

/** A frame with the noise of a Kinect as DepthNoise has it, not correlated and without
 * the warp that calibration leaves, which moves planes as a whole. */
Cloud::Ptr
addNoise (const pcl::PointCloud<pcl::PointXYZRGB>& ideal)
{
  auto cloud = pcl::make_shared<Cloud>();
  pcl::copyPointCloud (ideal, *cloud);
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  for (auto& point : *cloud) {
    const float sigma = pcl::rgbd_planes::DepthNoise().sigmaAtSquare (
        point.getVector3fMap().squaredNorm());
    point.getVector3fMap() *= 1.f + sigma * gauss (generator) / point.z;
  }
  return cloud;
}

/** The plane of the least sum of squared distances. */
pcl::ModelCoefficients
fitPlane (const Cloud& cloud, const pcl::Indices& points)
{
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  pcl::computeMeanAndCovarianceMatrix (cloud, points, covariance, mean);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  const Eigen::Vector3d normal = solver.eigenvectors().col (0);
  Eigen::Vector4d plane;
  plane << normal, -normal.dot (mean.head<3>());
  pcl::ModelCoefficients model;
  model.values = {static_cast<float> (plane[0]),
                  static_cast<float> (plane[1]),
                  static_cast<float> (plane[2]),
                  static_cast<float> (plane[3])};
  return model;
}

} // namespace

TEST (ProjectedNoise, OfFarPlanesFallsFivefold)
{
  for (const std::string scene : {"corridor", "room"}) {
    const auto frame =
        pcl::rgbd_planes::simulate (scene, 1, pcl::rgbd_planes::Sensor::ideal);
    const auto cloud = addNoise (*frame.cloud);
    std::vector<pcl::PointIndices> inliers (frame.planes.size());
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if (const std::uint32_t label = (*frame.truth)[i].label)
        inliers[label - 1].indices.push_back (static_cast<pcl::index_t> (i));
    std::vector<pcl::ModelCoefficients> planes;
    for (const auto& plane : inliers)
      planes.push_back (fitPlane (*cloud, plane.indices));

    pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
    projection.setInputCloud (cloud);
    projection.setInputPlanes (planes, inliers);
    Cloud corrected;
    projection.filter (corrected);
    Residuals residuals;
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const auto& truth = (*frame.truth)[i];
      if (!counts (truth, (*cloud)[i]))
        continue;
      const Eigen::Vector4f& plane = frame.planes[truth.label - 1];
      const auto square = [&plane] (const pcl::PointXYZ& p) {
        const double distance = plane.head<3>().dot (p.getVector3fMap()) + plane[3];
        return distance * distance;
      };
      residuals.before += square ((*cloud)[i]);
      residuals.after += square (corrected[i]);
    }
    EXPECT_GE (residuals.improvement(), 5.) << scene;
  }
}
