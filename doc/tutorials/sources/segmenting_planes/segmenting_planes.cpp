// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

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

  // [normals]
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);
  // [/normals]

  // [segment]
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setMinInliers (5000);
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment (planes, inliers);
  // [/segment]

  // [print]
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& plane = planes[i].values;
    std::printf ("%5.2f x + %5.2f y + %5.2f z + %.2f = 0, %zu thousand points, "
                 "rms %.0f mm\n",
                 plane[0],
                 plane[1],
                 plane[2],
                 plane[3],
                 inliers[i].indices.size() / 1000,
                 1000. * segmentation.getRms()[i]);
  }
  // [/print]

  // [segments]
  std::vector<pcl::PointIndices> segments;
  std::vector<std::size_t> plane_of_segment;
  segmentation.getSegments (segments, plane_of_segment);
  for (std::size_t i = 0; i < segments.size(); ++i)
    std::printf ("segment of plane %zu: %zu thousand points\n",
                 plane_of_segment[i],
                 segments[i].indices.size() / 1000);
  // [/segments]
}
