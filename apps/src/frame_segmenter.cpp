// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/depth_correction.h>
#include <pcl/apps/estimated_pose.h>
#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/min_points.h>
#include <pcl/apps/stopwatch.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** \param[in] camera_to_base nothing where it is a guess */
PlaneSummary
summarize (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
           const pcl::ModelCoefficients& model,
           const pcl::Indices& inliers,
           const std::optional<Eigen::Affine3f>& camera_to_base)
{
  PlaneSummary plane;
  std::copy_n (model.values.begin(), 4, plane.coefficients.begin());
  plane.points = inliers.size();
  const auto& [a, b, c, d] = plane.coefficients;
  double squares = 0.;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto index : inliers) {
    const auto& p = cloud[static_cast<std::size_t> (index)];
    const double distance = a * p.x + b * p.y + c * p.z + d;
    squares += distance * distance;
    sum += p.getVector3fMap().cast<double>();
  }
  const auto points = static_cast<double> (inliers.size());
  plane.rms = std::sqrt (squares / points);
  plane.plane_class = planeClass (
      Eigen::Vector3d (plane.coefficients.data()), sum / points, camera_to_base);
  return plane;
}

bool
isKnown (PoseSource pose)
{
  return pose == PoseSource::given || pose == PoseSource::simulated;
}

} // namespace

unsigned
minInliers (const SegmenterOptions& options, std::size_t pixels)
{
  return options.min_inliers.value_or (minPlanePoints (pixels));
}

std::string
planeClass (const Eigen::Vector3d& normal,
            const Eigen::Vector3d& centroid,
            const std::optional<Eigen::Affine3f>& camera_to_base)
{
  if (!camera_to_base)
    return "unknown";
  const double min_cosine = std::cos (0.26), max_floor_height = 0.05;
  const Eigen::Vector3d up = camera_to_base->linear().row (2).cast<double>();
  const double rise = up.dot (normal);
  if (rise > min_cosine) {
    const double height = camera_to_base->translation().z() + up.dot (centroid);
    return std::fabs (height) <= max_floor_height ? "floor" : "table";
  }
  return rise < -min_cosine                                            ? "ceiling"
         : std::fabs (rise) < std::sqrt (1. - min_cosine * min_cosine) ? "wall"
                                                                       : "slope";
}

void
FrameSummary::freeIndices()
{
  for (auto& summary : objects)
    pcl::Indices().swap (summary.object.indices.indices);
  for (auto& summary : obstacles)
    pcl::Indices().swap (summary.obstacle.indices);
}

FrameSegmenter::FrameSegmenter (const SegmenterOptions& options)
: options_ (options)
, normals_ (new pcl::PointCloud<pcl::Normal>)
, labels_ (new pcl::PointCloud<pcl::Label>)
{
  estimation_.setDepthNoise (options.depth_noise);
  segmentation_.setDepthNoise (options.depth_noise);
  extraction_.setDepthNoise (options.depth_noise);
  detection_.setDepthNoise (options.depth_noise);
  extraction_.setSplitAtConcaveEdges (true);
  ScanLimits all_around;
  all_around.angle_min = -static_cast<float> (M_PI);
  all_around.angle_max = static_cast<float> (M_PI);
  detection_.setScanLimits (all_around);
  if (options.corrected_points)
    expectCorrectedPoints (segmentation_);
}

FrameSummary
FrameSegmenter::segment (const Frame& frame)
{
  if (!has_memory_) {
    has_memory_ = true;
    segment (frame);
  }
  const auto& cloud = *frame.cloud;
  FrameSummary summary;
  summary.name = frame.name;
  summary.width = cloud.width;
  summary.height = cloud.height;
  summary.measured_points = static_cast<std::size_t> (std::count_if (
      cloud.begin(), cloud.end(), [] (const auto& p) { return std::isfinite (p.z); }));
  summary.min_inliers = minInliers (options_, cloud.size());

  const Stopwatch total;
  estimation_.setInputCloud (frame.cloud);
  estimation_.compute (*normals_);
  summary.times.normals = total.milliseconds();
  segmentation_.setInputCloud (frame.cloud);
  segmentation_.setInputNormals (normals_);
  segmentation_.setMinInliers (summary.min_inliers);
  segmentation_.segment (coefficients_, inliers_, *labels_);
  summary.rejections = segmentation_.getRejections();
  findPose (frame, summary);
  if (options_.find_objects)
    findObjects (frame, summary);
  if (options_.find_obstacles)
    findObstacles (frame, summary);
  summary.times.total = total.milliseconds();
  const PlaneStageTimes& seconds = segmentation_.getStageTimes();
  summary.times.normal_space = 1e3 * seconds.normal_space;
  summary.times.distance_space = 1e3 * seconds.distance_space;
  summary.times.refinement = 1e3 * seconds.refinement;

  const auto known_pose =
      isKnown (summary.pose) ? summary.camera_to_base : std::nullopt;
  for (std::size_t id = 0; id < inliers_.size(); ++id) {
    summary.planes.push_back (
        summarize (cloud, coefficients_[id], inliers_[id].indices, known_pose));
    summary.labelled_points += inliers_[id].indices.size();
  }
  return summary;
}

void
FrameSegmenter::findPose (const Frame& frame, FrameSummary& summary) const
{
  if (options_.camera_to_base) {
    summary.pose = PoseSource::given;
    summary.camera_to_base = options_.camera_to_base;
  }
  else if (frame.camera_to_base) {
    summary.pose = PoseSource::simulated;
    summary.camera_to_base = frame.camera_to_base;
  }
  else if ((summary.camera_to_base = estimateCameraToBase (coefficients_))) {
    summary.pose = PoseSource::estimated;
    summary.floor = findLikelyFloor (coefficients_);
  }
}

void
FrameSegmenter::findObjects (const Frame& frame, FrameSummary& summary)
{
  const Stopwatch watch;
  extraction_.setCameraToBase (summary.camera_to_base.value_or (defaultCameraToBase()));
  const auto [lowest_m, highest_m] = planeHeights (isKnown (summary.pose));
  extraction_.setPlaneHeights (lowest_m, highest_m);
  extraction_.setMinPoints (minObjectPoints (frame.cloud->size()));
  extraction_.setInputCloud (frame.cloud);
  extraction_.setInputNormals (normals_);
  extraction_.extract (coefficients_, inliers_, objects_);
  summary.times.objects = watch.milliseconds();
  for (const auto& object : objects_)
    summary.objects.push_back ({object, object.indices.indices.size()});
}

void
FrameSegmenter::findObstacles (const Frame& frame, FrameSummary& summary)
{
  const Stopwatch watch;
  const Eigen::Affine3f camera_to_base =
      summary.camera_to_base.value_or (defaultCameraToBase());
  detection_.setCameraToBase (camera_to_base);
  detection_.setInputCloud (frame.cloud);
  detection_.setInputNormals (normals_);
  detection_.setInputPlanes (coefficients_, labels_);
  detection_.detect (obstacles_);
  summary.times.obstacles = watch.milliseconds();

  summary.scan = detection_.getScan();
  summary.floor_found = detection_.isFloorFound();
  for (const auto& obstacle : obstacles_) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto index : obstacle.indices)
      sum += (*frame.cloud)[static_cast<std::size_t> (index)]
                 .getVector3fMap()
                 .cast<double>();
    const Eigen::Vector3d mean = sum / static_cast<double> (obstacle.indices.size());
    summary.obstacles.push_back (
        {obstacle, obstacle.indices.size(), camera_to_base * mean.cast<float>()});
  }
}

} // namespace rgbd_planes
} // namespace pcl
