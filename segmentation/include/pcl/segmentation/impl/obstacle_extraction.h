// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/camera_pose.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/impl/floor_bumps.h>
#include <pcl/segmentation/impl/floor_plane.h>
#include <pcl/segmentation/impl/obstacle_clusters.h>
#include <pcl/segmentation/impl/obstacle_points.h>
#include <pcl/segmentation/impl/point_row.h>
#include <pcl/segmentation/impl/scan_builder.h>
#include <pcl/segmentation/obstacle.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The settings of ObstacleExtraction. */
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
  /** A row that waits for the classes of its points. */
  struct Row {
    PointRow points;
    RowLinks links;
  };

  void
  start (const ObstacleFrame& frame,
         const pcl::Indices* excluded,
         const ObstacleParameters& parameters);

  /** Goes on with a row whose classes are final. */
  void
  finishRow (const OrganizedPoints& points,
             int v,
             const Eigen::Affine3f& camera_to_base);

  void
  exclude (std::size_t first, std::size_t end);

  /** Adds a run of the row that begins with point \a first to the runs to scan. */
  void
  addToScan (std::size_t run, std::size_t first);

  /** Those that were left out because they may be of no obstacle, or excluded. */
  void
  scanLateRuns (const OrganizedPoints& points, const Eigen::Affine3f& camera_to_base);

  void
  collect (const OrganizedPoints& points,
           const Eigen::Affine3f& camera_to_base,
           std::vector<Obstacle>& obstacles);

  /** \param[in] run that its nearest point is in */
  void
  describe (const OrganizedPoints& points,
            const ObstacleClusters::Run& run,
            const Eigen::Affine3f& camera_to_base,
            Obstacle& obstacle) const;

  Row&
  rowAt (int v)
  {
    return rows_[static_cast<std::size_t> (v) % rows_.size()];
  }

  FloorPlane floor_;
  ObstaclePoints point_classes_;
  ObstacleClusters clusters_;
  FloorBumps bumps_;
  ScanBuilder scan_builder_;
  VirtualScan scan_;
  std::vector<ObstacleClass> classes_;
  std::vector<Row> rows_;              // in turn
  std::vector<std::uint8_t> excluded_; // 1 for these points; empty without any
  std::vector<Extent> extents_;        // of each run; infinite before its scan
  std::vector<ScanRun> scan_runs_;     // of the row at hand
  PointRow late_row_;
  std::vector<std::size_t> nearest_runs_; // of each obstacle
};

} // namespace rgbd_planes
} // namespace pcl
