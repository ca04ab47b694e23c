// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_correction.h>
#include <pcl/apps/frame_files.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/apps/quiet_pcl.h>
#include <pcl/common/io.h>
#include <pcl/simulation/subsample.h>

#include <boost/program_options/value_semantic.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace po = boost::program_options;

namespace pcl {
namespace rgbd_planes {

void
addCorrectedOption (po::options_description& options)
{
  options.add_options() (
      "corrected",
      po::value<std::string>()->value_name ("frame|camera|FILE"),
      "take points that DepthWarpCorrection corrects. The planes of the frame itself "
      "tell the error of depth, or those of all frames, which are of one camera then; "
      "they are found on points as measured, and once more on those that these "
      "corrected. Or FILE.pcd does, the warp.pcd that pcl_segment_planes wrote for the "
      "camera. Not with --depth-noise");
}

std::optional<CorrectedOption>
readCorrected (const po::variables_map& values)
{
  if (!values.count ("corrected"))
    return std::nullopt;
  const auto& source = values["corrected"].as<std::string>();
  if (source == "frame")
    return CorrectedOption{WarpSource::frame, {}, {}};
  if (source == "camera")
    return CorrectedOption{WarpSource::camera, {}, {}};
  if (!hasExtension (source, ".pcd"))
    throw AppError ("--corrected: '" + source +
                    "' must be frame, camera or a .pcd file");
  CorrectedOption option{WarpSource::file, source, readIntensityPcd (source)};
  // Ten times as much as cameras have, for their warp grows where no plane tells it.
  const auto isWarp = [] (const auto& point) {
    return std::fabs (point.intensity) <= 0.2f;
  };
  if (!std::all_of (option.warp.begin(), option.warp.end(), isWarp))
    throw AppError (
        source + ": this is no warp of depth, whose values are from -0.2 to 0.2 / m; "
                 "give a warp.pcd that pcl_segment_planes wrote");
  return option;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
coordinates (const Frame& frame)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::copyPointCloud (*frame.cloud, *cloud);
  return cloud;
}

DepthCorrection::DepthCorrection (const CorrectedOption& option) : option_ (option)
{
  expectCorrectedPoints (fine_);
}

std::vector<DepthCorrection::Calibration>
DepthCorrection::calibration()
{
  if (option_.source != WarpSource::camera)
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
  add (rough_correction_, cloud);
}

void
DepthCorrection::calibrateFinely (const Cloud::ConstPtr& cloud, unsigned min_inliers)
{
  apply (rough_correction_, cloud);
  segment (fine_, corrected_, min_inliers, planes_);
  add (correction_, cloud);
}

const DepthCorrection::Cloud::Ptr&
DepthCorrection::correct (const Cloud::ConstPtr& cloud, unsigned min_inliers)
{
  if (option_.source == WarpSource::file)
    fitWarpTo (*cloud);
  if (option_.source == WarpSource::frame) {
    rough_correction_.clearFrames();
    correction_.clearFrames();
    calibrateRoughly (cloud, min_inliers);
    calibrateFinely (cloud, min_inliers);
  }
  apply (correction_, cloud);
  return corrected_;
}

Frame
DepthCorrection::correct (const Frame& measured, unsigned min_inliers)
{
  Frame frame = measured;
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (*measured.cloud);
  const Cloud& points = *correct (coordinates (measured), min_inliers);
  for (std::size_t i = 0; i < points.size(); ++i)
    (*frame.cloud)[i].getVector3fMap() = points[i].getVector3fMap();
  return frame;
}

void
DepthCorrection::fitWarpTo (const Cloud& cloud)
{
  if (corrected_->width == cloud.width && corrected_->height == cloud.height)
    return;
  const auto size = [] (const auto& image) {
    return std::to_string (image.width) + " x " + std::to_string (image.height);
  };
  const std::uint32_t step = (option_.warp.width + cloud.width - 1) / cloud.width;
  const auto warp = subsample (option_.warp, step);
  if (warp.width != cloud.width || warp.height != cloud.height)
    throw AppError (option_.file + ": the warp is " + size (option_.warp) +
                    ", but a frame is " + size (cloud) +
                    "; give the warp of the camera that took the frames");
  correction_.setWarp (warp);
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
  // Who takes the corrected points segments them, and is told then.
  const QuietPcl quiet;
  estimation_.setInputCloud (cloud);
  estimation_.compute (*normals_);
  segmentation.setMinInliers (min_inliers);
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals_);
  segmentation.segment (planes.models, planes.inliers);
}

void
DepthCorrection::add (Correction& correction, const Cloud::ConstPtr& cloud) const
{
  if (!correction.addFrame (cloud, planes_.models, planes_.inliers))
    throw AppError ("--corrected: a frame does not tell the smooth error of depth, for "
                    "its planes are not where its points are; leave it out");
}

void
DepthCorrection::apply (Correction& correction, const Cloud::ConstPtr& cloud)
{
  correction.setInputCloud (cloud);
  correction.filter (*corrected_);
}

} // namespace rgbd_planes
} // namespace pcl
