// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/sensor_points.h>
#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/impl/plane_points.h>
#include <pcl/memory.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/impl/obstacle_extraction.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl {

/** \brief Where a robot can drive: the floor is safe, all else that is measured is an
 * obstacle, also what does not stick out but has another normal or plane (Holz et al.
 * 2011, section 5.1).
 *
 * \code
 * pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection;
 * detection.setCameraToBase (camera_to_base);
 * detection.setInputCloud (cloud);
 * detection.setInputNormals (normals);
 * detection.setInputPlanes (model_coefficients, labels); // NormalSpacePlaneSegmentation
 * detection.detect (obstacles, classes);
 * \endcode
 *
 * Input: an organized cloud in metres, in the camera frame or any other in which its \c
 * sensor_origin_ is the place of the sensor, as CameraToBase sets it; a normal for each point,
 * the planes of the cloud, and the pose of its frame in the base frame (x forward, y left, z
 * up, the floor at z = 0), the identity for clouds of CameraToBase. NaN, Inf and (0, 0, 0) are
 * missing points. With indices, only these points are classified; all points of the planes tell
 * where the floor is. Nothing is too high for an obstacle, as a lintel or a ceiling: only the
 * virtual scan has a limit of height.
 *
 * The floor is the plane that is horizontal and at z = 0 within tolerances, near to z = 0, and
 * large, where near points count most; heights are measured from it, as the pose may be
 * slightly off. Obstacles at least as high as the larger of 1 cm and three standard deviations
 * of depth are found. Points clearly below the floor are drop-offs. A plane beside the floor
 * that is clearly higher or lower where it is near is so everywhere. Clusters of a few points
 * are specks, errors of the sensor. Clusters of fewer points than a 700th of the image are floor
 * if half of them are lower than five standard deviations of height, and the floor behind begins
 * without a step of two: noise that pixels share, or warp, makes such bumps. Where no floor is
 * found, nothing is safe: points clearly below z = 0 are drop-offs if the camera is above it, all
 * other measured points obstacles.
 *
 * A null, empty or unorganized cloud, a \c sensor_origin_ that is not finite, normals or labels
 * that are missing or of another size, or an index outside of the cloud: an error message and
 * empty outputs. No floor while setCameraToBase was not called, or normals of which none has a
 * length of 1: a warning, once for frames in a row. Several threads need an object each.
 *
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT, typename PointLT = pcl::Label>
class PCL_RGBD_PLANES_EXPORTS ObstacleDetection : public PCLBase<PointT> {
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;

public:
  using Ptr = shared_ptr<ObstacleDetection<PointT, PointNT, PointLT>>;
  using ConstPtr = shared_ptr<const ObstacleDetection<PointT, PointNT, PointLT>>;

  using PointCloudN = pcl::PointCloud<PointNT>;
  using PointCloudNConstPtr = typename PointCloudN::ConstPtr;
  using PointCloudL = pcl::PointCloud<PointLT>;
  using PointCloudLConstPtr = typename PointCloudL::ConstPtr;

  using Obstacle = rgbd_planes::Obstacle;
  using ScanLimits = rgbd_planes::ScanLimits;
  using VirtualScan = rgbd_planes::VirtualScan;

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~ObstacleDetection() override = default;

  /** \brief One normal for each point of the input cloud, in the same order; of unit length,
   * facing the sensor: points of the floor with another normal are obstacles. */
  void
  setInputNormals (const PointCloudNConstPtr& normals)
  {
    normals_ = normals;
  }

  PointCloudNConstPtr
  getInputNormals () const
  {
    return normals_;
  }

  /** \brief The planes of the input cloud.
   * \param[in] model_coefficients a, b, c, d of each plane in the frame of the cloud, metres, of
   * any length and sign; one without four finite coefficients is never the floor
   * \param[in] labels the plane of each point of the input cloud, or a number beyond; kept, not
   * copied: to stay as they are until detect() returns
   */
  void
  setInputPlanes (const std::vector<ModelCoefficients>& model_coefficients,
                  const PointCloudLConstPtr& labels);

  /** \brief The pose of the frame of the cloud, which mostly is that of the camera, in the
   * base frame, metres; default rgbd_planes::defaultCameraToBase(), whose z = 0 is no floor
   * but the height of the camera: give a measured pose, or that of
   * CameraToBase::estimateFromFloor. A transform that is not rigid: an error message, and the
   * one before stays. */
  void
  setCameraToBase (const Eigen::Affine3f& camera_to_base);

  const Eigen::Affine3f&
  getCameraToBase () const
  {
    return parameters_.camera_to_base;
  }

  /** \brief How far the normal of the floor may be from z of the base frame, radians from
   * 0 to pi / 2, default 0.17, and it from z = 0, in the mean of its points or below the origin
   * of the base frame, metres, more than 0, default 0.05; what is nearer to z = 0 is preferred.
   * Where one of them is another: an error message, and both stay as before. */
  void
  setFloorTolerances (float angle, float height)
  {
    const std::string setter = getClassName() + "::setFloorTolerances";
    float floor_angle = parameters_.floor_angle;
    if (rgbd_planes::setParameter (
            setter, angle, floor_angle, rgbd_planes::Zero::allowed, M_PI / 2.) &&
        rgbd_planes::setParameter (
            setter, height, parameters_.floor_height, rgbd_planes::Zero::refused))
      parameters_.floor_angle = floor_angle;
  }

  float
  getFloorAngleTolerance () const
  {
    return parameters_.floor_angle;
  }

  float
  getFloorHeightTolerance () const
  {
    return parameters_.floor_height;
  }

  /** \brief The height of the lowest obstacles that are told by their height, metres, 0 or
   * more (others: an error message), default 0.01; where that is less than three standard
   * deviations of depth, lower ones may be missed. Tops lower than half of it
   * are floor. Points with another normal than the floor, and those above it of planes tilted
   * against it, are obstacles however low they are, for they may be the foot of something
   * whose top is hidden or out of view: the sides of low things stay obstacles. */
  void
  setMinObstacleHeight (float height)
  {
    rgbd_planes::setParameter (getClassName() + "::setMinObstacleHeight",
                               height,
                               parameters_.points.min_height,
                               rgbd_planes::Zero::allowed,
                               rgbd_planes::any_finite);
  }

  float
  getMinObstacleHeight () const
  {
    return parameters_.points.min_height;
  }

  /** \brief The depth of the shallowest drop-offs, metres, 0 or more (others: an error message),
   * default 0.03. Those within 8 standard deviations of height need a plane of their own. */
  void
  setMinDropDepth (float depth)
  {
    rgbd_planes::setParameter (
        getClassName() + "::setMinDropDepth", depth, parameters_.points.min_drop);
  }

  float
  getMinDropDepth () const
  {
    return parameters_.points.min_drop;
  }

  /** \brief The points of smaller clusters are specks; default 0 for one point in 20000
   * of the image, at least 2. */
  void
  setMinClusterSize (unsigned points)
  {
    parameters_.min_cluster_size = points;
  }

  unsigned
  getMinClusterSize () const
  {
    return parameters_.min_cluster_size;
  }

  /** \brief The noise of the sensor; default rgbd_planes::DepthNoise::kinectV1 ().
   * Points beyond its range are unmeasured. One that is not valid: an error message, and the noise
   * before stays. */
  void
  setDepthNoise (const rgbd_planes::DepthNoise& noise)
  {
    rgbd_planes::setDepthNoise (getClassName(), noise, parameters_.points.noise);
  }

  const rgbd_planes::DepthNoise&
  getDepthNoise () const
  {
    return parameters_.points.noise;
  }

  /** \brief The extent of the virtual scan; default 180 degrees ahead in steps of half a
   * degree, up to 10 m, up to 2 m above z = 0 of the base frame. Angles that are more than a
   * turn from the x axis or from each other, a last one before the first one, an increment
   * of less than 1e-4, a range that is negative or ends before it begins, or a limit that is
   * NaN: an error message, and the limits before stay. */
  void
  setScanLimits (const ScanLimits& limits);

  const ScanLimits&
  getScanLimits () const
  {
    return parameters_.scan;
  }

  /** \brief Points of the object that is to be grasped, which is no obstacle: indices of
   * the input cloud; null for none, the default. Obstacle points connected with them are
   * excluded too where they are fewer than a quarter as many, for they are likely its rim
   * and foot: something that touches it and is as small in the image is not found. */
  void
  setExcludedIndices (const IndicesConstPtr& indices)
  {
    excluded_ = indices;
  }

  /** \brief Tells floor, obstacles and drop-offs, and makes the virtual scan.
   * \param[out] obstacles by increasing distance; replaced
   * \param[out] classes the rgbd_planes::ObstacleClass of each point as its label,
   * organized as the input; what ObstacleFilter takes
   */
  void
  detect (std::vector<Obstacle>& obstacles, PointCloudL& classes);

  /** \brief The same without classes, which getClasses() has. */
  void
  detect (std::vector<Obstacle>& obstacles);

  /** \brief The class of each point in the last call of detect; empty after an error. */
  const std::vector<rgbd_planes::ObstacleClass>&
  getClasses () const
  {
    return extraction_.classes();
  }

  /** \brief The virtual scan of the last call of detect; without ranges after an error. */
  const VirtualScan&
  getScan () const
  {
    return extraction_.scan();
  }

  /** \brief Whether the last call of detect found a floor. */
  bool
  isFloorFound () const
  {
    return extraction_.floor().isFound();
  }

  /** \brief a, b, c, d of the floor in the frame of the cloud, metres, with a unit normal towards
   * the sensor; zeros where none was found. */
  const Eigen::Vector4f&
  getFloor () const
  {
    return floor_;
  }

protected:
  std::string
  getClassName () const
  {
    return "ObstacleDetection";
  }

private:
  bool
  checkInput () const;

  void
  findObstacles (std::vector<Obstacle>& obstacles);

  /** \brief Warns if the floor is lost (\a is_lost) and nobody said where the camera is. */
  void
  warnOfPose (bool is_lost);

  /** \brief Warns if obstacles were found, but no normal of unit length (\a have_no_length). */
  void
  warnOfNormals (bool have_no_length);

  PointCloudNConstPtr normals_;
  PointCloudLConstPtr labels_;
  rgbd_planes::PlaneVectors coefficients_;
  rgbd_planes::LabelledPlanes planes_;
  IndicesConstPtr excluded_;
  rgbd_planes::ObstacleParameters parameters_;
  rgbd_planes::SensorPoints relative_points_;
  rgbd_planes::ObstacleExtraction extraction_;
  Eigen::Vector4f floor_ = Eigen::Vector4f::Zero();
  std::vector<std::uint8_t> selected_;
  bool is_posed_ = false, is_warned_ = false, is_warned_of_normals_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/obstacle_detection.hpp>
#endif
