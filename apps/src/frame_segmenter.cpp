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
  const ObstacleParameters floor;
  const double min_cosine = std::cos (ObjectParameters().horizontal_tolerance);
  const Eigen::Vector3d up = camera_to_base->linear().row (2).cast<double>();
  const double rise = up.dot (normal);
  if (rise > min_cosine) {
    const double height = camera_to_base->translation().z() + up.dot (centroid);
    return rise >= std::cos (floor.floor_angle) &&
                   std::fabs (height) <= floor.floor_height
               ? "floor"
               : "table";
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
, pipeline_ (options.depth_noise)
{
  ScanLimits all_around;
  all_around.angle_min = -static_cast<float> (M_PI);
  all_around.angle_max = static_cast<float> (M_PI);
  pipeline_.detection.setScanLimits (all_around);
  if (options.corrected_points)
    expectCorrectedPoints (pipeline_.segmentation);
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
  pipeline_.estimateNormals (frame.cloud);
  summary.times.normals = total.milliseconds();
  pipeline_.findPlanes (summary.min_inliers);
  summary.rejections = pipeline_.segmentation.getRejections();
  findPose (frame, summary);
  if (options_.find_objects)
    findObjects (summary);
  if (options_.find_obstacles)
    findObstacles (summary);
  summary.times.total = total.milliseconds();
  const PlaneStageTimes& seconds = pipeline_.segmentation.getStageTimes();
  summary.times.normal_space = 1e3 * seconds.normal_space;
  summary.times.distance_space = 1e3 * seconds.distance_space;
  summary.times.refinement = 1e3 * seconds.refinement;

  const auto known_pose =
      isKnown (summary.pose) ? summary.camera_to_base : std::nullopt;
  for (std::size_t id = 0; id < pipeline_.models.size(); ++id) {
    const pcl::Indices& inliers = pipeline_.inliers[id].indices;
    summary.planes.push_back (
        summarize (cloud, pipeline_.models[id], inliers, known_pose));
    summary.labelled_points += inliers.size();
  }
  return summary;
}

void
FrameSegmenter::findPose (const Frame& frame, FrameSummary& summary)
{
  if (options_.camera_to_base) {
    summary.pose = PoseSource::given;
    summary.camera_to_base = options_.camera_to_base;
  }
  else if (frame.camera_to_base) {
    summary.pose = PoseSource::simulated;
    summary.camera_to_base = frame.camera_to_base;
  }
  else if ((summary.camera_to_base = estimateCameraToBase (pipeline_.models))) {
    summary.pose = PoseSource::estimated;
    summary.floor = findLikelyFloor (pipeline_.models);
  }
  pipeline_.setPose (summary.camera_to_base.value_or (defaultCameraToBase()),
                     isKnown (summary.pose));
}

void
FrameSegmenter::findObjects (FrameSummary& summary)
{
  const Stopwatch watch;
  pipeline_.findObjects();
  summary.times.objects = watch.milliseconds();
  for (const auto& object : pipeline_.objects)
    summary.objects.push_back ({object, object.indices.indices.size()});
}

void
FrameSegmenter::findObstacles (FrameSummary& summary)
{
  const Stopwatch watch;
  pipeline_.findObstacles();
  summary.times.obstacles = watch.milliseconds();

  const auto& detection = pipeline_.detection;
  summary.scan = detection.getScan();
  summary.floor_found = detection.isFloorFound();
  for (const auto& obstacle : pipeline_.obstacles) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto index : obstacle.indices)
      sum += (*pipeline_.cloud)[static_cast<std::size_t> (index)]
                 .getVector3fMap()
                 .cast<double>();
    const Eigen::Vector3d mean = sum / static_cast<double> (obstacle.indices.size());
    summary.obstacles.push_back ({obstacle,
                                  obstacle.indices.size(),
                                  detection.getCameraToBase() * mean.cast<float>()});
  }
}

} // namespace rgbd_planes
} // namespace pcl
