// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/common/angles.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/camera_to_base.h>
#include <pcl/filters/obstacle_filter.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>

#include <cmath>
#include <cstdio>

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
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);

  // [planes]
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  segmentation.segment (planes, inliers, *labels);
  // [/planes]

  // [pose]
  pcl::CameraToBase<pcl::PointXYZ> to_base;
  if (planes.empty() || !to_base.estimateFromFloor (planes.front())) {
    std::fprintf (stderr, "No floor in sight.\n");
    return 1;
  }
  // [/pose]

  // [detect]
  pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection;
  detection.setCameraToBase (to_base.getTransform());
  detection.setInputCloud (cloud);
  detection.setInputNormals (normals);
  detection.setInputPlanes (planes, labels);
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  auto classes = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  detection.detect (obstacles, *classes);
  // [/detect]

  // [print]
  for (const auto& obstacle : obstacles)
    std::printf ("%s %.1f m away, %+.0f degrees\n",
                 obstacle.kind == pcl::rgbd_planes::Obstacle::Kind::drop_off
                     ? "drop-off"
                     : "obstacle",
                 obstacle.distance,
                 pcl::rad2deg (obstacle.direction));
  // [/print]

  // [scan]
  const auto& scan = detection.getScan();
  const auto ahead =
      static_cast<std::size_t> (std::lround (-scan.angle_min / scan.angle_increment));
  std::printf ("free straight ahead: %.1f m\n", scan.ranges[ahead]);
  // [/scan]

  // [filter]
  pcl::ObstacleFilter<pcl::PointXYZ> filter;
  filter.setInputCloud (cloud);
  filter.setClasses (classes);
  pcl::PointCloud<pcl::PointXYZ> obstacle_points;
  filter.filter (obstacle_points);
  // [/filter]
  std::printf ("%zu thousand points of obstacles\n", obstacle_points.size() / 1000);
}
