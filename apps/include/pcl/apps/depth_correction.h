// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Which planes tell the warp of depth: those of the same frame, or of all frames, which
 * are of one camera then; or none, for it is known from a file. */
enum class WarpSource { frame, camera, file };

/** \brief The value of --corrected. */
struct CorrectedOption {
  WarpSource source;
  /** With WarpSource::file, its name and what it holds. */
  std::string file;
  pcl::PointCloud<pcl::Intensity> warp;
};

void
addCorrectedOption (boost::program_options::options_description& options);

/** \brief What --corrected says, if it is given; AppError where it is none of them. */
std::optional<CorrectedOption>
readCorrected (const boost::program_options::variables_map& values);

/** \brief The points of a frame without their colours. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
coordinates (const Frame& frame);

/** \brief Sets a segmentation up for points that DepthWarpCorrection corrected. */
template <typename Segmentation>
void
expectCorrectedPoints (Segmentation& segmentation)
{
  segmentation.setDepthNoise (DepthNoise::kinectV1Corrected());
  segmentation.setDistanceThreshold (0.007);
  segmentation.setMinimumNearNormals (0.4);
}

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

  explicit DepthCorrection (const CorrectedOption& option);

  /** \brief For WarpSource::camera, what is to be shown all frames, one after the other,
   * before the first one is corrected: throws AppError where they are of several sizes. */
  std::vector<Calibration>
  calibration ();

  /** \brief The points of a frame without the warp, until the next frame. Throws AppError where
   * the warp of a file is of a smaller or another image. */
  const Cloud::Ptr&
  correct (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  /** \brief A copy of a frame with corrected points. */
  Frame
  correct (const Frame& measured, unsigned min_inliers);

  /** \brief Planes of points that are corrected. */
  void
  findPlanes (const Cloud::ConstPtr& corrected,
              unsigned min_inliers,
              SegmentedPlanes& planes);

  /** \brief See DepthWarpCorrection::getWarp(). */
  pcl::PointCloud<pcl::Intensity>
  warp () const
  {
    return correction_.getWarp();
  }

private:
  using Segmentation = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>;
  using Correction = pcl::DepthWarpCorrection<pcl::PointXYZ>;

  /** Takes the warp of the file, and with smaller frames its every n-th pixel. */
  void
  fitWarpTo (const Cloud& cloud);

  void
  calibrateRoughly (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  void
  calibrateFinely (const Cloud::ConstPtr& cloud, unsigned min_inliers);

  void
  segment (Segmentation& segmentation,
           const Cloud::ConstPtr& cloud,
           unsigned min_inliers,
           SegmentedPlanes& planes);

  /** \brief Adds the planes that were segmented last; AppError where they do not fit. */
  void
  add (Correction& correction, const Cloud::ConstPtr& cloud) const;

  void
  apply (Correction& correction, const Cloud::ConstPtr& cloud);

  CorrectedOption option_;
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
