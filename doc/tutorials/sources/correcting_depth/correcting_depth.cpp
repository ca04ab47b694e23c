// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/filters/project_onto_planes.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <cmath>
#include <cstdio>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

// [planes]
struct Planes {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
};

Planes
findPlanes (const Cloud::ConstPtr& cloud, bool is_corrected)
{
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  if (is_corrected) {
    segmentation.setDepthNoise (pcl::rgbd_planes::DepthNoise::kinectV1Corrected());
    segmentation.setDistanceThreshold (0.007);
    segmentation.setMinimumNearNormals (0.4);
  }
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  Planes planes;
  segmentation.segment (planes.models, planes.inliers);
  return planes;
}
// [/planes]

// [angles]
void
printAngles (const char* when, const Planes& planes)
{
  std::printf ("%s:", when);
  for (std::size_t i = 0; i < planes.models.size() && i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Eigen::Map<const Eigen::Vector3f> a (planes.models[i].values.data()),
          b (planes.models[k].values.data());
      std::printf (" %.1f", std::acos (a.dot (b)) * 180. / M_PI);
    }
  std::printf (" degrees\n");
}
// [/angles]

int
main (int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf (stderr, "Usage: %s FRAME_OF_A_CAMERA.pcd...\n", argv[0]);
    return 1;
  }
  std::vector<Cloud::Ptr> clouds;
  for (int i = 1; i < argc; ++i) {
    clouds.push_back (pcl::make_shared<Cloud>());
    if (pcl::io::loadPCDFile (argv[i], *clouds.back()) != 0 ||
        !clouds.back()->isOrganized()) {
      std::fprintf (stderr, "%s is no organized cloud.\n", argv[i]);
      return 1;
    }
  }

  // [rough]
  pcl::DepthWarpCorrection<pcl::PointXYZ> rough;
  for (const auto& cloud : clouds) {
    const Planes planes = findPlanes (cloud, false);
    rough.addFrame (cloud, planes.models, planes.inliers);
  }
  // [/rough]

  // [fine]
  pcl::DepthWarpCorrection<pcl::PointXYZ> fine;
  auto corrected = pcl::make_shared<Cloud>();
  for (const auto& cloud : clouds) {
    rough.setInputCloud (cloud);
    rough.filter (*corrected);
    const Planes planes = findPlanes (corrected, true);
    fine.addFrame (cloud, planes.models, planes.inliers);
  }
  // [/fine]

  // [correct]
  fine.setInputCloud (clouds.front());
  fine.filter (*corrected);
  const Planes planes = findPlanes (corrected, true);
  printAngles ("before", findPlanes (clouds.front(), false));
  printAngles ("after", planes);
  // [/correct]

  // [keep]
  pcl::io::savePCDFileBinaryCompressed ("warp.pcd", fine.getWarp());
  // [/keep]

  // [project]
  pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
  projection.setInputCloud (corrected);
  projection.setInputPlanes (planes.models, planes.inliers);
  Cloud smooth;
  projection.filter (smooth);
  pcl::io::savePCDFileBinaryCompressed ("corrected.pcd", smooth);
  // [/project]
}
