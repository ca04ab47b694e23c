// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/camera_pose.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/floor_plane.h>
#include <pcl/segmentation/obstacle.h>
#include <pcl/segmentation/obstacle_clusters.h>
#include <pcl/segmentation/obstacle_points.h>
#include <pcl/segmentation/scan_builder.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct ObstacleParameters {
  Eigen::Affine3f camera_to_base = defaultCameraToBase();
  /** Largest angle between the normal of the floor and z of the base frame; radians. */
  float floor_angle = 0.17f;
  /** Largest mean height of the points of the floor in the base frame; metres. */
  float floor_height = 0.05f;
  /** Smaller clusters are specks; 0 for one point in 20000 of the image, at least 2. */
  unsigned min_cluster_size = 0;
  ObstaclePointParameters points;
  ScanLimits scan;
};

/** \brief Obstacles, drop-offs and a virtual scan from the planes of a frame (Holz et al.
 * 2011, section 5.1). */
class PCL_RGBD_PLANES_EXPORTS ObstacleExtraction {
public:
  /** \brief Looks at a frame.
   * \param[in] points in the camera frame
   * \param[in] normals one for each point
   * \param[in] selected not 0 for the points to look at, one for each; null for all
   * \param[in] excluded points of an object that is to be grasped; null for none
   * \param[out] obstacles by increasing distance
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const LabelledPlanes& planes,
           const std::uint8_t* selected,
           const pcl::Indices* excluded,
           const ObstacleParameters& parameters,
           std::vector<Obstacle>& obstacles);

  const FloorPlane&
  floor () const
  {
    return floor_;
  }

  /** \brief The class of each point. */
  const std::vector<ObstacleClass>&
  classes () const
  {
    return classes_;
  }

  const VirtualScan&
  scan () const
  {
    return scan_;
  }

private:
  /** What the points are, and which of them are linked. */
  void
  classify (const ObstacleFrame& frame,
            const std::uint8_t* selected,
            const ObstacleParameters& parameters);

  void
  exclude (const pcl::Indices& excluded);

  void
  collect (const OrganizedPoints& points,
           const ObstacleParameters& parameters,
           std::vector<Obstacle>& obstacles);

  /** Adds the points of the runs of a row to their obstacles and to the scan. */
  void
  addRow (const OrganizedPoints& points,
          const ObstacleClusters::Run* begin,
          const ObstacleClusters::Run* end,
          const Eigen::Affine3f& camera_to_base,
          std::vector<Obstacle>& obstacles);

  void
  followToFloor (const OrganizedPoints& points,
                 const ObstacleClusters::Run& run,
                 std::size_t column,
                 const Eigen::Vector3f& camera);

  void
  addRun (const ObstacleClusters::Run& run, std::size_t column, Obstacle& obstacle);

  FloorPlane floor_;
  ObstaclePoints point_classes_;
  ObstacleLinks links_;
  ObstacleClusters clusters_;
  ScanBuilder scan_builder_;
  VirtualScan scan_;
  std::vector<ObstacleClass> classes_;
  PointRow rows_[2];
  /** The points of a row in the base frame. */
  struct {
    std::vector<float> x, y, z;
    std::vector<float> squares; // of their distances from the z axis
  } base_;
  std::vector<float> nearest_; // squared distance of each obstacle
};

} // namespace rgbd_planes
} // namespace pcl
