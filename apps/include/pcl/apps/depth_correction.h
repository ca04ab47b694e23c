// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Which planes tell the warp of depth: those of the same frame, or of all frames, which
 * are of one camera then. */
enum class WarpSource { frame, camera };

void
addCorrectedOption (boost::program_options::options_description& options);

/** \brief What --corrected says, if it is given; AppError where it is neither. */
std::optional<WarpSource>
readCorrected (const boost::program_options::variables_map& values);

/** \brief What a segmentation writes. */
struct SegmentedPlanes {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
};

/** \brief Learns the warp of depth with DepthWarpCorrection in two rounds: planes of points as
 * measured tell it roughly, those of points that are roughly corrected tell it finely. */
class DepthCorrection {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using Calibration =
      std::function<void (const Cloud::ConstPtr& cloud, unsigned min_inliers)>;

  explicit DepthCorrection (WarpSource source);

  /** \brief For WarpSource::camera, what is to be shown all frames, one after the other,
   * before the first one is corrected: throws AppError where they are of several sizes. */
  std::vector<Calibration>
  calibration ();

  /** \brief The points of a frame without the warp, until the next frame. */
  const Cloud::Ptr&
  correct (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  /** \brief Planes of points that are corrected. */
  void
  findPlanes (const Cloud::ConstPtr& corrected,
              unsigned min_inliers,
              SegmentedPlanes& planes);

private:
  using Segmentation = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>;
  using Correction = pcl::DepthWarpCorrection<pcl::PointXYZ>;

  void
  calibrateRoughly (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  void
  calibrateFinely (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  void
  segment (Segmentation& segmentation,
           const Cloud::ConstPtr& cloud,
           unsigned min_inliers,
           SegmentedPlanes& planes);

  void
  apply (Correction& correction, const Cloud::ConstPtr& cloud);

  WarpSource source_;
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation_;
  pcl::PointCloud<pcl::Normal>::Ptr normals_ =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  Segmentation coarse_, fine_;
  Correction rough_correction_, correction_;
  SegmentedPlanes planes_;
  Cloud::Ptr corrected_ = pcl::make_shared<Cloud>();
};

} // namespace rgbd_planes
} // namespace pcl
