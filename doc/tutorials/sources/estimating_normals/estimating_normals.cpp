// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstdio>

int
main (int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf (stderr, "Usage: %s CLOUD.pcd\n", argv[0]);
    return 1;
  }
  // [load]
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  if (pcl::io::loadPCDFile (argv[1], *cloud) != 0 || !cloud->isOrganized()) {
    std::fprintf (stderr, "%s is no organized cloud.\n", argv[1]);
    return 1;
  }
  // [/load]

  // [estimate]
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute (normals);
  // [/estimate]

  // [use]
  std::size_t points = 0, with_normal = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    points += std::isfinite ((*cloud)[i].z);
    with_normal += std::isfinite (normals[i].normal_x);
  }
  std::printf ("%u x %u pixels, %.0f %% of the points have a normal\n",
               normals.width,
               normals.height,
               100. * static_cast<double> (with_normal) / static_cast<double> (points));

  const pcl::Normal& centre = normals (cloud->width / 2, cloud->height / 2);
  std::printf ("in the middle of the image: %.2f %.2f %.2f, curvature %.2f\n",
               centre.normal_x,
               centre.normal_y,
               centre.normal_z,
               centre.curvature);
  // [/use]
}
