// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/filter.h>
#include <pcl/filters/impl/depth_warp.h>
#include <pcl/filters/impl/own_indices.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Corrects the smooth error of depth that calibration leaves: it bends far walls of a
 * Kinect by centimetres, and tilts them by a degree. The planes of one or more frames of
 * the same camera tell it, see rgbd_planes::DepthWarp. Not in the paper.
 *
 * \code
 * segmentation.segment (model_coefficients, inlier_indices);
 * pcl::DepthWarpCorrection<pcl::PointXYZ> correction;
 * correction.addFrame (cloud, model_coefficients, inlier_indices); // more views: better
 * correction.setInputCloud (cloud);
 * correction.filter (*corrected);
 * \endcode
 *
 * Points move along their viewing ray and keep their pixel. What is left of the error is
 * noise, which DepthNoise::kinectV1Corrected() describes for a segmentation of the output.
 * It is only as good as the planes: whatever makes one of two surfaces is taken for warp.
 * An error of inverse depth that is linear in the image tilts all planes alike: right angles tell
 * it, where planes meet at any.
 *
 * The output has all points of the input, its organization and its header; all fields but
 * coordinates stay. With indices, only these points move. Output and input may be the same
 * cloud. Points without a measurement (NaN, Inf or (0, 0, 0)), behind the camera, or so far
 * away that the error is as large as half of the range stay. Without frames or a warp, with an
 * input that is no image of their size or not in the camera frame (\c sensor_origin_ is not 0), or
 * an index outside of it: an error message and an empty output. Without an input, after an error
 * message of PCL, the output stays as it was.
 *
 * The warp stays with the camera. getWarp() is an image that PCL can keep in a file:
 *
 * \code
 * pcl::io::savePCDFileBinaryCompressed ("warp.pcd", correction.getWarp());
 * \endcode
 *
 * \ingroup filters
 */
template <typename PointT>
class PCL_RGBD_PLANES_EXPORTS DepthWarpCorrection
: public rgbd_planes::OwnIndices<Filter<PointT>> {
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::getClassName;
  using Filter<PointT>::indices_;
  using Filter<PointT>::input_;

public:
  using Ptr = shared_ptr<DepthWarpCorrection<PointT>>;
  using ConstPtr = shared_ptr<const DepthWarpCorrection<PointT>>;
  using typename Filter<PointT>::PointCloud;
  using typename Filter<PointT>::PointCloudConstPtr;

  DepthWarpCorrection() { filter_name_ = "DepthWarpCorrection"; }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~DepthWarpCorrection() override = default;

  /** \brief Adds what the planes of a frame tell; false after an error message where there is no
   * cloud, it is no image of the size of the frames before, its \c sensor_origin_ is not 0, or
   * the planes are not those of the cloud. A frame without planes, or that shows
   * the same as the one before, adds nothing, and is taken; then what setWarp() set stays.
   * \param[in] cloud as measured, in the camera frame, z forward
   * \param[in] model_coefficients a, b, c, d with a x + b y + c z + d = 0
   * \param[in] inlier_indices the points of each plane
   */
  bool
  addFrame (const PointCloudConstPtr& cloud,
            const std::vector<ModelCoefficients>& model_coefficients,
            const std::vector<PointIndices>& inlier_indices);

  /** \brief What the camera adds to the inverse depth 1/z of each pixel, in 1/m: an image of the
   * size of the frames; empty while there are none. */
  pcl::PointCloud<pcl::Intensity>
  getWarp () const;

  /** \brief Sets what getWarp() gave: it takes the place of all frames, and those that are added
   * later take its place. False after an error message where it is no image, or not finite. */
  bool
  setWarp (const pcl::PointCloud<pcl::Intensity>& warp);

  /** \brief Forgets all frames and the warp: for another camera. */
  void
  clearFrames ()
  {
    warp_.clear();
  }

  std::size_t
  getNumberOfFrames () const
  {
    return warp_.frames();
  }

  /** \brief The errors of measured depth, which tell how large the warp may be: without a
   * quadratic part, hardly anything is corrected. Default: DepthNoise::kinectV1 (). Counts from the
   * next frame on; points beyond its range tell nothing.
   * One that is not valid: an error message, and the noise before stays. */
  void
  setDepthNoise (const rgbd_planes::DepthNoise& noise)
  {
    rgbd_planes::setDepthNoise (getClassName(), noise, noise_);
  }

  const rgbd_planes::DepthNoise&
  getDepthNoise () const
  {
    return noise_;
  }

  /** \brief Whether planes of 3 % of the image and more that are within 4 degrees of a right
   * angle are taken to be at one, as in buildings; default true. False where such planes may
   * truly be some degrees off, or to measure right angles. Counts from the next frame on. */
  void
  setRightAngles (bool right_angles)
  {
    right_angles_ = right_angles;
  }

  bool
  getRightAngles () const
  {
    return right_angles_;
  }

protected:
  void
  applyFilter (PointCloud& output) override;

private:
  /** \brief What is wrong with an image, or nothing. */
  std::string
  faultOf (const PointCloud& cloud) const;

  rgbd_planes::DepthWarp warp_;
  rgbd_planes::DepthNoise noise_ = rgbd_planes::DepthNoise::kinectV1();
  bool right_angles_ = true;
  std::vector<std::uint32_t> plane_of_; // for each point; no plane: a number beyond
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/depth_warp_correction.hpp>
#endif
