// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <algorithm>
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

  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment (planes, inliers);

  // [pose]
  const auto faces_up = [] (const pcl::ModelCoefficients& plane) {
    return plane.values[1] < -0.5f; // y points down in the camera frame
  };
  const auto table = std::find_if (planes.begin(), planes.end(), faces_up);
  if (table == planes.end()) {
    std::fprintf (stderr, "No table in sight.\n");
    return 1;
  }
  const Eigen::Affine3f camera_to_base =
      *pcl::rgbd_planes::cameraToBaseFromFloor (Eigen::Vector4f (table->values.data()));
  // [/pose]

  // [extract]
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
  extraction.setCameraToBase (camera_to_base);
  extraction.setSplitAtConcaveEdges (true);
  extraction.setInputCloud (cloud);
  extraction.setInputNormals (normals);
  std::vector<pcl::SupportedObject> objects;
  extraction.extract (planes, inliers, objects);
  // [/extract]

  // [print]
  for (const auto& object : objects) {
    const Eigen::Vector3f centre = camera_to_base * object.box_center;
    const Eigen::Vector3f cm = 100.f * object.box_size;
    std::printf ("%.0f x %.0f cm, %.0f cm high, %.2f m ahead, %.2f m to the left%s\n",
                 cm.x(),
                 cm.y(),
                 cm.z(),
                 centre.x(),
                 centre.y(),
                 object.graspable ? ", graspable" : "");
  }
  // [/print]
}
