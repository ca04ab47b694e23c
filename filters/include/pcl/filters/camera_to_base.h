// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/camera_pose.h>
#include <pcl/filters/filter.h>
#include <pcl/filters/impl/own_indices.h>
#include <pcl/memory.h>
#include <pcl/ModelCoefficients.h>

#include <string>

namespace pcl {

/** \brief Points, and normals where they have them, from the camera frame (x right, y
 * down, z forward) into the base frame of the robot (x forward, y left, z up), after Holz
 * et al. 2011, section 3.
 *
 * \code
 * pcl::CameraToBase<pcl::PointNormal> to_base;
 * to_base.setTransform (camera_to_base);
 * to_base.setInputCloud (cloud);
 * to_base.filter (*cloud_in_base);
 * \endcode
 *
 * PointT has coordinates, normals or both: a CameraToBase<pcl::Normal> turns the normals of a
 * cloud that has none itself.
 *
 * The output keeps the organization of the input and all fields but coordinates and
 * normals; with indices, it has only these points, N x 1, in their order. Points without a
 * measurement (NaN, Inf or (0, 0, 0)) become NaN, and normals that are NaN stay so. The
 * header is that of the input with the frame of setBaseFrame. The sensor pose of the input,
 * zero and identity in the camera frame, moves with the points: that of the output is the pose
 * of the camera in the base frame, also after two of these, as by way of the frame of a head.
 * pcl::visualization::PCLVisualizer moves clouds by that pose, these a second time: show it a
 * copy with a pose of zero and identity.
 * Output and input may be the same cloud, but not through a pointer to pcl::Filter, which
 * would keep header and sensor pose of the input. No cloud or an index outside of it: an
 * error message and an empty output, but what pcl::Filter leaves where there is no cloud.
 *
 * \ingroup filters
 */
template <typename PointT>
class PCL_RGBD_PLANES_EXPORTS CameraToBase
: public rgbd_planes::OwnIndices<Filter<PointT>> {
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::getClassName;
  using Filter<PointT>::indices_;
  using Filter<PointT>::input_;
  using PCLBase<PointT>::fake_indices_;
  using PCLBase<PointT>::use_indices_;

public:
  using Ptr = shared_ptr<CameraToBase<PointT>>;
  using ConstPtr = shared_ptr<const CameraToBase<PointT>>;
  using typename Filter<PointT>::PointCloud;

  CameraToBase() { filter_name_ = "CameraToBase"; }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~CameraToBase() override = default;

  /** \brief The pose of the camera, or of another frame of the input, in the base frame,
   * metres; default rgbd_planes::defaultCameraToBase(). A transform that is not rigid: an
   * error message, and the one before stays. */
  void
  setTransform (const Eigen::Affine3f& camera_to_base);

  const Eigen::Affine3f&
  getTransform () const
  {
    return transform_;
  }

  /** \brief Where the transform is unknown but a floor is seen: takes height, roll and
   * pitch of the camera from it, see rgbd_planes::cameraToBaseFromFloor.
   * \param[in] floor a, b, c, d with a x + b y + c z + d = 0 in the camera frame
   * \return false after an error message where \a floor is no plane; the transform
   * before stays
   */
  bool
  estimateFromFloor (const ModelCoefficients& floor);

  /** \brief The frame in the header of the output; default "base_link". */
  void
  setBaseFrame (const std::string& frame)
  {
    base_frame_ = frame;
  }

  const std::string&
  getBaseFrame () const
  {
    return base_frame_;
  }

  /** \brief Transforms the input cloud; hides the method of the base class, which would
   * put back header and sensor pose of the input where \a output is the input. */
  void
  filter (PointCloud& output);

protected:
  void
  applyFilter (PointCloud& output) override;

private:
  Eigen::Affine3f transform_ = rgbd_planes::defaultCameraToBase();
  std::string base_frame_ = "base_link";
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/camera_to_base.hpp>
#endif
