// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/frame_source.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Run times in milliseconds. */
struct StageTimes {
  double normals = 0.;
  double normal_space = 0.;
  double distance_space = 0.;
  double refinement = 0.;
  double objects = 0.;
  double obstacles = 0.;
  /** All of the above and what lies between them; not reading and writing of files. */
  double total = 0.;
};

struct PlaneSummary {
  /** a x + b y + c z + d = 0 in the camera frame, metres, facing the camera: d >= 0 is
   * the distance of the camera from the plane. */
  std::array<double, 4> coefficients;
  std::size_t points = 0;
  /** Root mean square distance of the points from the plane, metres. */
  double rms = 0.;
  /** See planeClass(). */
  std::string plane_class;
};

/** \brief What to find, and how. */
struct SegmenterOptions {
  /** Planes with fewer points are dropped; by default 1000 for 640 x 480 pixels and in
   * proportion for other sizes. */
  std::optional<unsigned> min_inliers;
  bool find_objects = false;
  bool find_obstacles = false;
  /** Where the camera is; by default where a simulated one is. Without either,
   * estimateCameraToBase(). */
  std::optional<Eigen::Affine3f> camera_to_base;
  /** Of the sensor. */
  DepthNoise depth_noise = DepthNoise::kinectV1();
  /** Whether DepthWarpCorrection corrected the points of the frames. */
  bool corrected_points = false;
};

/** \brief What the options say, or their default for a number of pixels. */
unsigned
minInliers (const SegmenterOptions& options, std::size_t pixels);

/** \brief The kind of a plane with a \a normal towards the camera and points around \a centroid,
 * both in the camera frame: floor (level, and at z = 0 in the mean, as ObstacleDetection may take
 * it), table (what else SupportedObjectExtraction takes for level), ceiling, wall or slope;
 * "unknown" without a transform. */
std::string
planeClass (const Eigen::Vector3d& normal,
            const Eigen::Vector3d& centroid,
            const std::optional<Eigen::Affine3f>& camera_to_base);

/** \brief Where a pose of the camera is from: an option, the simulation, a plane that is taken for
 * the floor, or nothing, so that defaultCameraToBase() is assumed. */
enum class PoseSource { given, simulated, estimated, assumed };

struct ObjectSummary {
  pcl::SupportedObject object;
  std::size_t points = 0;
};

struct ObstacleSummary {
  Obstacle obstacle;
  std::size_t points = 0;
  /** The mean of its points in the base frame. */
  Eigen::Vector3f centroid;
};

/** \brief What is known of a frame after it was segmented, without its points. */
struct FrameSummary {
  std::string name;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::size_t measured_points = 0;
  std::size_t labelled_points = 0;
  unsigned min_inliers = 0;
  StageTimes times;
  /** By decreasing number of points; the index is the id of the plane. */
  std::vector<PlaneSummary> planes;
  PlaneRejections rejections;
  /** Where options ask for them. */
  std::vector<ObjectSummary> objects;
  /** Where options ask for them, by increasing distance. */
  std::vector<ObstacleSummary> obstacles;
  VirtualScan scan;
  /** Nothing where obstacles were not asked for. */
  std::optional<bool> floor_found;
  PoseSource pose = PoseSource::assumed;
  /** With PoseSource::estimated, the plane that was taken for the floor. */
  std::size_t floor = 0;
  /** Where the camera was taken to be; nothing where that is unknown and there is no
   * plane to estimate it from. */
  std::optional<Eigen::Affine3f> camera_to_base;

  /** \brief Frees the indices of the points of objects and obstacles, a megabyte in some
   * frames; all that reports tell stays. */
  void
  freeIndices ();
};

/** \brief Finds the planes of one frame after the other, objects on them, and obstacles. */
class FrameSegmenter {
public:
  explicit FrameSegmenter (const SegmenterOptions& options);

  /** \brief The first frame is segmented twice, so that all times are those with memory in
   * place. */
  FrameSummary
  segment (const Frame& frame);

  /** \brief The normals of the last frame; NaN where there is none. */
  const pcl::PointCloud<pcl::Normal>&
  normals () const
  {
    return *pipeline_.normals;
  }

  /** \brief The plane of each point of the last frame, or \ref unlabelled. */
  const pcl::PointCloud<pcl::Label>&
  labels () const
  {
    return *pipeline_.labels;
  }

  /** \brief a, b, c, d of each plane of the last frame, as PCL gives them. */
  const std::vector<pcl::ModelCoefficients>&
  models () const
  {
    return pipeline_.models;
  }

  /** \brief The planes that objects were looked for on. */
  const std::vector<pcl::SupportPlane>&
  supportPlanes () const
  {
    return pipeline_.extraction.getSupportPlanes();
  }

  /** \brief What each point of the last frame is to a robot, where options ask for
   * obstacles. */
  const std::vector<ObstacleClass>&
  obstacleClasses () const
  {
    return pipeline_.detection.getClasses();
  }

private:
  void
  findPose (const Frame& frame, FrameSummary& summary);

  void
  findObjects (FrameSummary& summary);

  void
  findObstacles (FrameSummary& summary);

  SegmenterOptions options_;
  bool has_memory_ = false;
  DetectionPipeline<pcl::PointXYZRGB> pipeline_;
};

} // namespace rgbd_planes
} // namespace pcl
