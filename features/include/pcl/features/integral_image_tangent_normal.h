// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/tangent_normals.h>
#include <pcl/features/impl/threads.h>
#include <pcl/features/normal_estimation_base.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/point_types.h>

namespace pcl {

/** \brief Surface normals of organized clouds from tangents that are averaged with
 * integral images (Holz, Holzer, Rusu, Behnke: Real-Time Plane Segmentation using RGB-D
 * Cameras, 2011, section 3).
 *
 * A replacement for pcl::IntegralImageNormalEstimation that takes all of its setters,
 * so that swapping the type name is enough. Other than there, borders are on unless
 * switched off, setRectSize has an effect, and every valid point with a surface around it gets a
 * normal. Interlaced clouds have none: where every second row or column is missing, or points
 * form a checkerboard, no point has a valid neighbour along one axis. Time is linear in the
 * number of points, and a third longer for smoothing areas of 64 pixels than for those of 8.
 *
 * -# Images of 480 x 96 pixels and more, either way round, are divided into cells of 2 x 2
 *    pixels. The mean of those on the surface of the nearest one takes their place, and has
 *    less noise.
 * -# Tangents are the differences between neighbouring points to the left and right, and
 *    above and below, where both lie on one surface: by a model of the noise of depth;
 *    slanted surfaces are told from steps by the points further on.
 * -# Six integral images of fixed-point numbers, whose differences are exact, give the sums
 *    of tangents over the smoothing area around each cell, their cross product gives its
 *    plane, and the sums
 *    over its halves tell how much the surface bends inside.
 * -# The paper stops here (setEdgeAware (false)). At edges and creases, areas show two
 *    surfaces. So the planes around each cell are averaged, twice: planes
 *    that bend little count, and on which the point of the cell lies (Tukey's biweight of
 *    the distance over the deviation of depth). This is the counterpart of the second run
 *    of principal component analysis, and it makes use of much larger areas where the
 *    surface is flat.
 * -# Each point takes the plane of its cell, or, if it does not lie on that, the mean of
 *    the planes around on which it lies.
 *
 * Vector instructions are chosen at run time; all of them give the same normals within
 * 1e-4, but for one in 300 on noise without surfaces, where a choice is a matter of rounding.
 *
 * \code
 * pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
 * estimation.setInputCloud (cloud);
 * estimation.compute (normals);
 * \endcode
 *
 * Input: an organized cloud in any frame, in metres. Points with NaN, Inf or (0, 0, 0)
 * are missing depth. Output: as many normals as points (width x height kept), or one
 * for each index (N x 1) when indices are given; unit length, facing the viewpoint; NaN
 * where the point is missing or has no surface around it (or one seen so flatly that
 * neighbouring ranges differ by more than setMaxDepthChangeFactor allows), with \c is_dense
 * false then.
 * \c curvature is the ratio of the smallest eigenvalue to the sum of all (section 3)
 * that a smooth patch of the same bend would have, 1/3 where the normal is that of planes
 * around the point, which has none of its own. Coordinates are copied where
 * PointOutT has them.
 *
 * Output and input may be the same cloud, which keeps its other fields; not with indices.
 *
 * A null, empty or unorganized cloud, a \c sensor_origin_ that is not finite, an index outside of
 * the cloud, or indices where output and input are the same cloud: an error message and an empty
 * output. A cloud with measured points of which less than half have a normal: a warning, once for
 * frames in a row, unless they are less than 1 % of all points or BORDER_POLICY_IGNORE is set.
 * setKSearch, setRadiusSearch, setSearchMethod and setSearchSurface have no effect. Nothing is
 * allocated after the first of several clouds of the same size.
 *
 * Objects are copyable; several threads need one each.
 *
 * \ingroup features
 */
template <typename PointInT, typename PointOutT>
class PCL_RGBD_PLANES_EXPORTS IntegralImageTangentNormalEstimation
: public rgbd_planes::NormalEstimationBase<PointInT, PointOutT> {
  using Base = rgbd_planes::NormalEstimationBase<PointInT, PointOutT>;
  using Base::feature_name_;
  using Base::indices_;
  using Base::input_;

public:
  using Ptr = shared_ptr<IntegralImageTangentNormalEstimation<PointInT, PointOutT>>;
  using ConstPtr =
      shared_ptr<const IntegralImageTangentNormalEstimation<PointInT, PointOutT>>;
  using typename Base::PointCloudIn;
  using typename Base::PointCloudOut;

  /** \brief What to do where the smoothing area leaves the image. */
  enum BorderPolicy {
    BORDER_POLICY_IGNORE, /**< these points get no normal */
    BORDER_POLICY_MIRROR /**< the part of the area inside the image is used (default) */
  };

  /** \brief The methods of pcl::IntegralImageNormalEstimation. */
  enum NormalEstimationMethod {
    COVARIANCE_MATRIX,
    AVERAGE_3D_GRADIENT,
    AVERAGE_DEPTH_CHANGE,
    SIMPLE_3D_GRADIENT
  };

  /** \param[in] nr_threads as for setNumberOfThreads, and as pcl::NormalEstimationOMP has it */
  explicit IntegralImageTangentNormalEstimation (unsigned int nr_threads = 1)
  {
    feature_name_ = "IntegralImageTangentNormalEstimation";
    setNumberOfThreads (nr_threads);
  }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~IntegralImageTangentNormalEstimation() override = default;

  /** \brief Has no effect, for there is one method here: accepted so that the type name
   * of pcl::IntegralImageNormalEstimation can be swapped for this one. */
  void
  setNormalEstimationMethod (NormalEstimationMethod)
  {}

  /** \brief Width and height of the smoothing area in pixels. Where the area grows with
   * range, this is its size at 1 m. Default: 3/160 of the longer side of the image, at
   * least 4: less than for PCL's class, because planes are averaged afterwards. Areas reach
   * the nearest whole number of cells to each side: sizes from 10 to less than 14 are the same
   * in large images. Areas of more than 200 pixels round tangents, which turns normals:
   * doc/limits.md says by how much.
   * \param[in] normal_smoothing_size more than 0; other values are refused with an
   * error
   */
  void
  setNormalSmoothingSize (float normal_smoothing_size);

  /** \brief As setNormalSmoothingSize, with a size for each direction.
   * \param[in] width in pixels, more than 0
   * \param[in] height in pixels, more than 0
   */
  void
  setRectSize (int width, int height);

  /** \brief Let the smoothing area grow with the square root of the range, from its size
   * at 1 m to 2.7 times that; default false, as in PCL. Far points get smoother normals,
   * in 1.3 to 2.1 times the time. */
  void
  setDepthDependentSmoothing (bool use_depth_dependent_smoothing)
  {
    parameters_.depth_dependent_smoothing = use_depth_dependent_smoothing;
  }

  /** \brief Average the planes around each point on which it lies, so that normals keep to
   * their side of edges and creases; default true. The paper does not. Tangents between two
   * surfaces are left out either way, of which the paper says nothing. */
  void
  setEdgeAware (bool edge_aware)
  {
    parameters_.edge_aware = edge_aware;
  }

  /** \brief Compute several sizes of the smoothing area, from the given one to 2.7 times
   * that, and choose the most likely normal for each point (section 3 of the paper);
   * default false. Smoothest, in 1.3 to 2.1 times the time; near edges, areas may be too
   * large. Takes the place of depth-dependent smoothing. */
  void
  setScaleSelection (bool scale_selection)
  {
    parameters_.scale_selection = scale_selection;
  }

  /** \brief Neighbouring pixels whose ranges differ by more than
   * 2 * factor * (range + 1 m) lie on different surfaces, as in PCL; default 0.02. Cells of 2 x 2
   * pixels may differ by twice as much. They
   * also do if the difference is neither noise nor the slant of the surface. Beyond 5 m, the
   * noise of a Kinect v1 is more than the default allows: with 0.2, errors of slanted walls
   * at 6 m are a fifth smaller, and half as large at 8 m.
   * \param[in] max_depth_change_factor 0 or more; other values are refused with an
   * error
   */
  void
  setMaxDepthChangeFactor (float max_depth_change_factor);

  /** \brief The noise of the sensor, which tells neighbouring surfaces apart; default
   * rgbd_planes::DepthNoise::kinectV1 (). Normals are computed beyond its range as well.
   * One that is not valid: an error message, and the noise before stays. */
  void
  setDepthNoise (const rgbd_planes::DepthNoise& noise)
  {
    rgbd_planes::setDepthNoise (feature_name_, noise, parameters_.noise);
  }

  const rgbd_planes::DepthNoise&
  getDepthNoise () const
  {
    return parameters_.noise;
  }

  /** \brief What to do at image borders; default BORDER_POLICY_MIRROR. Where there are areas of
   * several sizes, the smallest one says what is at the border. */
  void
  setBorderPolicy (BorderPolicy border_policy)
  {
    parameters_.ignore_border = border_policy == BORDER_POLICY_IGNORE;
  }

  /** \brief The number of threads; 0 for one on each processor, default 1. The result
   * does not depend on it. */
  void
  setNumberOfThreads (unsigned int nr_threads = 0)
  {
    parameters_.threads = rgbd_planes::numberOfThreads (nr_threads);
  }

private:
  std::string
  complaint () const override;

  std::size_t
  computeNormals (PointCloudOut& output) override;

  /** \brief Says why most normals are missing where points are not. */
  void
  warnOfFew (std::size_t valid);

  rgbd_planes::TangentNormalParameters parameters_;
  rgbd_planes::TangentNormals tangent_normals_;
  /** The normals of the whole cloud, where only some are asked for. */
  pcl::PointCloud<pcl::Normal> all_normals_;
  bool is_warned_ = false;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/integral_image_tangent_normal.hpp>
#endif
