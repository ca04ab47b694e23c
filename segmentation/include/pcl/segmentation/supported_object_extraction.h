// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/sensor_points.h>
#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/camera_pose.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/impl/concave_split.h>
#include <pcl/segmentation/impl/object_box.h>
#include <pcl/segmentation/impl/object_clusters.h>
#include <pcl/segmentation/impl/support_planes.h>
#include <pcl/segmentation/impl/whole_things.h>
#include <pcl/segmentation/support_plane.h>
#include <pcl/segmentation/supported_object.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Things that stand on horizontal planes, for a robot to grasp (Holz, Holzer, Rusu,
 * Behnke: Real-Time Plane Segmentation using RGB-D Cameras, 2011, section 5.1).
 *
 * \code
 * pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
 * extraction.setCameraToBase (camera_to_base);
 * extraction.setInputCloud (cloud);
 * extraction.extract (model_coefficients, inlier_indices, objects);
 * \endcode
 *
 * Horizontal planes in a range of heights support objects. Each model is optimised with RANSAC.
 * Objects are looked for over the hull of its points and some way around it, up to their largest
 * height. The points there, of other planes or none, are clustered along the image. Heights are
 * those above the points of the plane around, for cameras bend planes; a point is above only where
 * depth noise does not explain it. Up to three quarters of a thing may reach further outside: it
 * hides the plane where it stands at a corner, or sticks out.
 *
 * No objects are: what continues further outside or higher up (people, legs of a table); what lies
 * on a plane much of which is elsewhere, or which goes from one side of the image to the other (the
 * wall behind a table); what mostly ends at something nearer above it in the image, for its height
 * cannot be seen; what the image cuts above where the plane ends, as the foot of a wall; and what
 * is lower than six standard deviations of depth in most of its points and passes into the plane
 * behind it without a step, as bumps that noise makes. What touches such a wall is an object if a
 * quarter of its points stand out from it, by five standard deviations. A thing on a thing is one
 * object with it, but for setSplitAtConcaveEdges(): the box of the upper one begins where its lower
 * end is seen, in mid-air or over the lower thing. Steps, pallets and low boards are no things, but
 * support some, see setMaxObjectHeight(). Both sides of the rim of a cup, a bowl, or a box without
 * a lid are one object. Small parts beside a thing, such as handles, belong to it if they neither
 * stand on the plane nor rest on the thing.
 *
 * Input: an organized cloud in metres, in the camera frame (x right, y down, z forward; any
 * frame will do if the base transform goes with it and \c sensor_origin_ is the place of the
 * sensor, as CameraToBase sets it), and the planes that NormalSpacePlaneSegmentation or another
 * segmentation found in it. NaN, Inf and (0, 0, 0) mean missing depth. With indices, only these
 * points can be of objects. Output: objects in the order of their first points, parts of what
 * was split one after the other; replaced, not appended to.
 *
 * A null, empty or unorganized cloud, a \c sensor_origin_ that is not finite, a plane without four
 * coefficients or without a list of inliers, an index outside of the cloud, or
 * setSplitAtConcaveEdges() without a normal for each point: an error message and no objects. No
 * supporting one among the planes while setCameraToBase was not called, or setSplitAtConcaveEdges()
 * with normals of which none has a length of 1: a warning, once for frames in a row. What a setter
 * cannot take: an error message, and the value before stays. Several threads need an object each.
 *
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT>
class PCL_RGBD_PLANES_EXPORTS SupportedObjectExtraction : public PCLBase<PointT> {
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;

public:
  using Ptr = shared_ptr<SupportedObjectExtraction<PointT, PointNT>>;
  using ConstPtr = shared_ptr<const SupportedObjectExtraction<PointT, PointNT>>;

  using PointCloudN = pcl::PointCloud<PointNT>;
  using PointCloudNPtr = typename PointCloudN::Ptr;
  using PointCloudNConstPtr = typename PointCloudN::ConstPtr;

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~SupportedObjectExtraction() override = default;

  /** \brief One normal for each point of the input cloud, in the same order; of unit length,
   * facing the sensor, for else convex edges look concave. Needed for
   * setSplitAtConcaveEdges() only. */
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

  /** \brief The pose of the frame of the cloud in the base frame: x forward, y left, z up, metres;
   * heights count from z = 0. Default: the camera looks forward along x, without tilt, and is
   * 2 cm to the left of the origin, at height 0 (section 3 of the paper). A transform that is not
   * rigid: an error message, and the one before stays. */
  void
  setCameraToBase (const Eigen::Affine3f& camera_to_base)
  {
    is_posed_ |= rgbd_planes::setTransform (
        getClassName() + "::setCameraToBase", camera_to_base, camera_to_base_);
  }

  const Eigen::Affine3f&
  getCameraToBase () const
  {
    return camera_to_base_;
  }

  /** \brief Supporting planes are tilted by no more than this; radians, 0 to pi / 2, default
   * 0.26 (15 degrees). */
  void
  setHorizontalTolerance (double tolerance)
  {
    setNumber ("setHorizontalTolerance",
               tolerance,
               parameters_.horizontal_tolerance,
               rgbd_planes::Zero::allowed,
               M_PI / 2.);
  }

  double
  getHorizontalTolerance () const
  {
    return parameters_.horizontal_tolerance;
  }

  /** \brief Heights of supporting planes in the base frame, where their points are on
   * average, give or take 3 standard deviations of depth; metres, default 0 to 1.2. A range that
   * starts at z = 0 holds the plane that is nearest to it, if that is up to 5 cm lower: a floor, as
   * the pose may be off. */
  void
  setPlaneHeights (double lowest, double highest)
  {
    setRange ("setPlaneHeights",
              lowest,
              highest,
              parameters_.min_plane_height,
              parameters_.max_plane_height);
  }

  double
  getMinPlaneHeight () const
  {
    return parameters_.min_plane_height;
  }

  double
  getMaxPlaneHeight () const
  {
    return parameters_.max_plane_height;
  }

  /** \brief Objects reach no higher above their plane; metres, more than 0, default 0.3. A level
   * surface within that height above a plane is no top of an object, but supports objects, if it
   * measures 2.8 times this from corner to corner and is 0.75 times this wide on average, 84 and
   * 22 cm, without gaps of more than a tenth of it. */
  void
  setMaxObjectHeight (double height)
  {
    setNumber ("setMaxObjectHeight",
               height,
               parameters_.max_object_height,
               rgbd_planes::Zero::refused);
  }

  double
  getMaxObjectHeight () const
  {
    return parameters_.max_object_height;
  }

  /** \brief Things that are lower, or lower than 3 standard deviations of depth, are noise;
   * metres, more than 0, default 0.01. */
  void
  setMinObjectHeight (double height)
  {
    setNumber ("setMinObjectHeight",
               height,
               parameters_.min_object_height,
               rgbd_planes::Zero::refused);
  }

  double
  getMinObjectHeight () const
  {
    return parameters_.min_object_height;
  }

  /** \brief How far outside of the hull of its plane a thing may lie; metres, 0 or more,
   * default 0.03. */
  void
  setHullTolerance (double tolerance)
  {
    setNumber ("setHullTolerance",
               tolerance,
               parameters_.hull_tolerance,
               rgbd_planes::Zero::allowed);
  }

  double
  getHullTolerance () const
  {
    return parameters_.hull_tolerance;
  }

  /** \brief How much further up to three quarters of a thing may reach, which hides the
   * plane where it stands at a corner, or sticks out; metres, 0 or more, default 0.2. */
  void
  setMaxOverhang (double overhang)
  {
    setNumber ("setMaxOverhang",
               overhang,
               parameters_.max_overhang,
               rgbd_planes::Zero::allowed);
  }

  double
  getMaxOverhang () const
  {
    return parameters_.max_overhang;
  }

  /** \brief Neighbouring points are of one object when they are no further apart than three
   * pixels are wide there, plus this many standard deviations of depth; 0 or more, default
   * 1; or 8 mm at 1 m, if that is more. At the same height, as on tops that are seen at a flat
   * angle, they may be as far apart as one and a half pixels on a level surface. */
  void
  setClusterTolerance (double sigmas)
  {
    setNumber ("setClusterTolerance",
               sigmas,
               parameters_.cluster_tolerance,
               rgbd_planes::Zero::allowed);
  }

  double
  getClusterTolerance () const
  {
    return parameters_.cluster_tolerance;
  }

  /** \brief Objects have at least so many points; default 50, which suits 640 x 480 pixels:
   * take fewer for smaller images. What is little more than one pixel wide is no object. */
  void
  setMinPoints (unsigned min_points)
  {
    parameters_.min_points = min_points;
  }

  unsigned
  getMinPoints () const
  {
    return parameters_.min_points;
  }

  /** \brief What a gripper can grasp: the smallest side of a box; metres, 0 or more,
   * default 0.01 to 0.1. */
  void
  setGraspableSides (double smallest, double largest)
  {
    float side = parameters_.min_graspable_side;
    if (setNumber ("setGraspableSides", smallest, side, rgbd_planes::Zero::allowed))
      setRange ("setGraspableSides",
                smallest,
                largest,
                parameters_.min_graspable_side,
                parameters_.max_graspable_side);
  }

  double
  getMinGraspableSide () const
  {
    return parameters_.min_graspable_side;
  }

  double
  getMaxGraspableSide () const
  {
    return parameters_.max_graspable_side;
  }

  /** \brief The noise of the sensor; default rgbd_planes::DepthNoise::kinectV1 ().
   * Points beyond its range are left out. One that is not valid: an error message, and the noise
   * before stays. */
  void
  setDepthNoise (const rgbd_planes::DepthNoise& noise)
  {
    rgbd_planes::setDepthNoise (getClassName(), noise, parameters_.noise);
  }

  const rgbd_planes::DepthNoise&
  getDepthNoise () const
  {
    return parameters_.noise;
  }

  /** \brief Whether to split objects that touch along concave edges and steps between their
   * surfaces; default false. An object that stands on another one then rests on that one's
   * top, where this is a plane. From 480 columns on, edges are looked for on cells of 2 x 2
   * pixels, from 960 on on cells of 4 x 4, and so on. */
  void
  setSplitAtConcaveEdges (bool split)
  {
    parameters_.split_at_concave_edges = split;
  }

  bool
  getSplitAtConcaveEdges () const
  {
    return parameters_.split_at_concave_edges;
  }

  /** \brief Finds the objects.
   * \param[in] model_coefficients a, b, c, d of each plane, a x + b y + c z + d = 0; of any
   * length and sign, as those of SACSegmentation
   * \param[in] inlier_indices the points of each plane, in ascending order
   * \param[out] objects the objects
   */
  void
  extract (const std::vector<ModelCoefficients>& model_coefficients,
           const std::vector<PointIndices>& inlier_indices,
           std::vector<SupportedObject>& objects);

  /** \brief The horizontal planes in the range of heights, as the last call of extract() found
   * and optimised them, from the highest to the lowest; empty after an error. */
  const std::vector<SupportPlane>&
  getSupportPlanes () const
  {
    return support_planes_;
  }

  /** \brief Why planes of the last call of extract() support nothing, and how many. */
  const SupportRejections&
  getSupportRejections () const
  {
    return supports_.rejections();
  }

protected:
  std::string
  getClassName () const
  {
    return "SupportedObjectExtraction";
  }

private:
  bool
  setNumber (const char* setter,
             double value,
             float& parameter,
             rgbd_planes::Zero zero,
             double max = rgbd_planes::any_finite)
  {
    return rgbd_planes::setParameter (
        getClassName() + "::" + setter, value, parameter, zero, max);
  }

  void
  setRange (const char* setter, double low, double high, float& min, float& max);

  std::string
  faultOf (const std::vector<ModelCoefficients>& model_coefficients,
           const std::vector<PointIndices>& inlier_indices) const;

  void
  findObjects (const std::vector<ModelCoefficients>& model_coefficients,
               const std::vector<PointIndices>& inlier_indices,
               std::vector<SupportedObject>& objects);

  const std::vector<rgbd_planes::ObjectCluster>&
  findClusters (const rgbd_planes::OrganizedPoints& points,
                const rgbd_planes::ObjectParameters& parameters);

  void
  describe (const rgbd_planes::OrganizedPoints& points,
            const rgbd_planes::ObjectCluster& cluster,
            const rgbd_planes::ObjectParameters& parameters,
            SupportedObject& object);

  /** \brief Warns if no plane supports (\a is_lost) and nobody said where the camera is. */
  void
  warnOfPose (bool is_lost);

  /** \brief Warns if objects were split by normals of which none has unit length (\a
   * have_no_length). */
  void
  warnOfNormals (bool have_no_length);

  PointCloudNConstPtr normals_;
  Eigen::Affine3f camera_to_base_ = rgbd_planes::defaultCameraToBase();
  rgbd_planes::ObjectParameters parameters_;
  std::vector<rgbd_planes::SegmentedPlane> planes_;
  rgbd_planes::SensorPoints relative_points_;
  std::vector<std::uint8_t> selected_;
  rgbd_planes::SupportPlanes supports_;
  std::vector<SupportPlane> support_planes_;
  rgbd_planes::ObjectClusters clustering_;
  rgbd_planes::ConcaveSplit split_;
  rgbd_planes::WholeThings whole_things_;
  rgbd_planes::ObjectBoxFinder boxes_;
  bool is_posed_ = false, is_warned_ = false, is_warned_of_normals_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/supported_object_extraction.hpp>
#endif
