// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/plane_report.h>
#include <pcl/apps/viewer_frame.h>
#include <pcl/simulation/subsample.h>

#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

SegmenterOptions
withEverything (const std::optional<Eigen::Affine3f>& camera_to_base,
                bool corrected_points,
                const DepthNoise& depth_noise)
{
  SegmenterOptions options;
  options.corrected_points = corrected_points;
  options.depth_noise = depth_noise;
  options.find_objects = true;
  options.find_obstacles = true;
  options.camera_to_base = camera_to_base;
  return options;
}

} // namespace

ViewerFrame::ViewerFrame (const std::optional<Eigen::Affine3f>& camera_to_base,
                          const std::optional<CorrectedOption>& corrected,
                          const DepthNoise& depth_noise)
: options_ (withEverything (camera_to_base, corrected.has_value(), depth_noise))
, segmenter_ (options_)
, correction_ (corrected)
{
  frame_.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
}

void
ViewerFrame::setCorrected (bool corrected)
{
  options_.corrected_points = corrected;
  segmenter_ = FrameSegmenter (options_);
}

void
ViewerFrame::compute (const Frame& frame, std::uint32_t step)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (
      subsample (*frame.cloud, step));
  if (cloud->width < 2 || cloud->height < 2)
    throw AppError ("frame " + frame.name +
                    " is unorganized, or too small for this resolution; give organized "
                    "clouds, and use --resolution vga");
  frame_ = frame;
  frame_.cloud = std::move (cloud);
  if (isCorrected())
    frame_ = correction_->correct (frame_, minInliers (options_, frame_.cloud->size()));
  summary_ = segmenter_.segment (frame_);
  tracker_.track (segmenter_.models(), segmenter_.labels(), ids_);
}

std::string
ViewerFrame::describePlane (const Eigen::Vector3f& place) const
{
  std::size_t nearest = 0;
  float smallest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < cloud().size(); ++i) {
    const float distance = (cloud()[i].getVector3fMap() - place).squaredNorm();
    if (distance < smallest) {
      smallest = distance;
      nearest = i;
    }
  }
  if (smallest == std::numeric_limits<float>::infinity())
    return "no point here";
  const std::uint32_t plane = segmenter_.labels()[nearest].label;
  if (plane == unlabelled)
    return "no plane here";
  return "plane " + std::to_string (ids_[plane]) + ": " +
         planeText (summary_.planes[plane]);
}

} // namespace rgbd_planes
} // namespace pcl
