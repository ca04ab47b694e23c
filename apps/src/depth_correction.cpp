// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_correction.h>

#include <boost/program_options/value_semantic.hpp>

#include <string>

namespace po = boost::program_options;

namespace pcl {
namespace rgbd_planes {

void
addCorrectedOption (po::options_description& options)
{
  options.add_options() (
      "corrected",
      po::value<std::string>()->value_name ("frame|camera"),
      "points corrected by DepthWarpCorrection: the planes of the frame itself tell "
      "the error of depth, or those of all frames, which are of one camera then; they "
      "are found on points as measured, and once more on points that these corrected");
}

std::optional<WarpSource>
readCorrected (const po::variables_map& values)
{
  if (!values.count ("corrected"))
    return std::nullopt;
  const auto& source = values["corrected"].as<std::string>();
  if (source == "frame")
    return WarpSource::frame;
  if (source == "camera")
    return WarpSource::camera;
  throw AppError ("--corrected: '" + source + "' must be frame or camera");
}

DepthCorrection::DepthCorrection (WarpSource source) : source_ (source)
{
  fine_.setDepthNoise (DepthNoise::kinectV1Corrected());
  fine_.setDistanceThreshold (0.007);
}

std::vector<DepthCorrection::Calibration>
DepthCorrection::calibration()
{
  if (source_ == WarpSource::frame)
    return {};
  return {[this] (const Cloud::ConstPtr& cloud, unsigned min_inliers) {
            calibrateRoughly (cloud, min_inliers);
          },
          [this] (const Cloud::ConstPtr& cloud, unsigned min_inliers) {
            calibrateFinely (cloud, min_inliers);
          }};
}

void
DepthCorrection::calibrateRoughly (const Cloud::ConstPtr& cloud, unsigned min_inliers)
{
  if (rough_correction_.getNumberOfFrames() == 0)
    corrected_->resize (cloud->width, cloud->height);
  else if (cloud->width != corrected_->width || cloud->height != corrected_->height)
    throw AppError ("--corrected camera: the frames are of several sizes, but those of "
                    "one camera have one; evaluate each camera by itself");
  segment (coarse_, cloud, min_inliers, planes_);
  rough_correction_.addFrame (cloud, planes_.models, planes_.inliers);
}

void
DepthCorrection::calibrateFinely (const Cloud::ConstPtr& cloud, unsigned min_inliers)
{
  apply (rough_correction_, cloud);
  segment (fine_, corrected_, min_inliers, planes_);
  correction_.addFrame (cloud, planes_.models, planes_.inliers);
}

const DepthCorrection::Cloud::Ptr&
DepthCorrection::correct (const Cloud::ConstPtr& cloud, unsigned min_inliers)
{
  if (source_ == WarpSource::frame) {
    rough_correction_.clearFrames();
    correction_.clearFrames();
    calibrateRoughly (cloud, min_inliers);
    calibrateFinely (cloud, min_inliers);
  }
  apply (correction_, cloud);
  return corrected_;
}

void
DepthCorrection::findPlanes (const Cloud::ConstPtr& corrected,
                             unsigned min_inliers,
                             SegmentedPlanes& planes)
{
  segment (fine_, corrected, min_inliers, planes);
}

void
DepthCorrection::segment (Segmentation& segmentation,
                          const Cloud::ConstPtr& cloud,
                          unsigned min_inliers,
                          SegmentedPlanes& planes)
{
  estimation_.setInputCloud (cloud);
  estimation_.compute (*normals_);
  segmentation.setMinInliers (min_inliers);
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals_);
  segmentation.segment (planes.models, planes.inliers);
}

void
DepthCorrection::apply (Correction& correction, const Cloud::ConstPtr& cloud)
{
  correction.setInputCloud (cloud);
  correction.filter (*corrected_);
}

} // namespace rgbd_planes
} // namespace pcl
