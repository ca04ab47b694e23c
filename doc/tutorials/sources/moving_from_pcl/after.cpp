// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <cstdio>

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
  estimation.setNormalEstimationMethod (Estimation::AVERAGE_3D_GRADIENT);
  estimation.setMaxDepthChangeFactor (0.02f);
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);

  Segmentation segmentation;
  segmentation.setMinInliers (1000);
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  segmentation.segmentAndRefine (regions);

  std::size_t points = 0;
  for (const auto& region : regions)
    points += region.getCount();
  std::printf ("%zu planes, %.0f %% of the image\n",
               regions.size(),
               100. * static_cast<double> (points) /
                   static_cast<double> (cloud->size()));
}
