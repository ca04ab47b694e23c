// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/euclidean_cluster_comparator.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/organized_connected_component_segmentation.h>

#include <algorithm>
#include <cstdio>
#include <set>

using Estimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;
using Segmentation =
    pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;

int
main (int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf (stderr, "Usage: %s CLOUD.pcd\n", argv[0]);
    return 1;
  }
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile (argv[1], *cloud) != 0 || !cloud->isOrganized()) {
    std::fprintf (stderr, "%s is no organized cloud.\n", argv[1]);
    return 1;
  }

  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  Estimation estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);

  Segmentation segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  segmentation.segmentAndRefine (
      regions, models, inliers, labels, label_indices, boundaries);

  // [labels]
  auto clustered = pcl::make_shared<std::set<std::uint32_t>>();
  for (std::uint32_t i = 0; i < label_indices.size(); ++i)
    if (label_indices[i].indices.size() < 10000)
      clustered->insert (i);
  clustered->insert (Segmentation::unlabelled); // new: what is on no plane

  auto comparator = pcl::make_shared<pcl::EuclideanClusterComparator<pcl::PointXYZ>>();
  comparator->setInputCloud (cloud);
  comparator->setLabels (labels);
  comparator->setExcludeLabels (clustered);
  // [/labels]
  comparator->setDistanceThreshold (0.01f, false);
  pcl::OrganizedConnectedComponentSegmentation<pcl::PointXYZ, pcl::Label> components (
      comparator);
  components.setInputCloud (cloud);
  pcl::PointCloud<pcl::Label> component_labels;
  std::vector<pcl::PointIndices> clusters;
  components.segment (component_labels, clusters);
  const auto large = std::count_if (
      clusters.begin(), clusters.end(), [] (const pcl::PointIndices& cluster) {
        return cluster.indices.size() > 1000;
      });
  std::printf ("%td clusters of more than 1000 points\n", large);
}
