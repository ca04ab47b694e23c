// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/two_run_normals.h>
#include <pcl/features/normal_estimation_base.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/point_types.h>

#include <functional>
#include <string>

namespace pcl {

/** \brief Surface normals by principal component analysis in two runs, the slow and
 * accurate way that fast estimators are compared with (Holz, Holzer, Rusu, Behnke:
 * Real-Time Plane Segmentation using RGB-D Cameras, 2011, section 3).
 *
 * The first run fits a plane to all neighbours of a point within a radius that grows
 * with range. The second one weights them by their distance to that plane, so that
 * edges and corners are smoothed less (rgbd_planes::fitPlaneInTwoRuns). Neighbours of
 * organized clouds are found in the image, others with pcl::KdTreeFLANN; both find the
 * same points.
 *
 * \code
 * pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
 * estimation.setInputCloud (cloud);
 * estimation.compute (normals);
 * \endcode
 *
 * Input: an organized or unorganized cloud, in metres. Points with NaN, Inf or (0, 0,
 * 0) are missing depth. Output: as many normals as points (width x height kept), or one
 * for each index (N x 1) when indices are given; unit length, facing the viewpoint; NaN
 * where the point is missing or has fewer than 3 neighbours, or only ones on a line,
 * with \c is_dense false then. \c curvature is the smallest eigenvalue of the weighted
 * covariance over the sum of all (section 3), 0 to 1/3. Coordinates are copied where
 * PointOutT has them. With setSearchSurface the neighbours are taken from another
 * cloud; setKSearch, setRadiusSearch and setSearchMethod have no effect.
 *
 * Output and input may be the same cloud, which keeps its other fields; not with indices.
 * Objects are copyable; several threads need one each.
 *
 * A null or empty cloud, an empty search surface, a \c sensor_origin_ or \c
 * sensor_orientation_ that is not finite, an index outside of the cloud, indices where output
 * and input are the same cloud, an output that is the search surface but not the input, or a
 * window of pixels where there is no image: an error message and an empty output.
 *
 * \ingroup features
 */
template <typename PointInT, typename PointOutT>
class PCL_RGBD_PLANES_EXPORTS TwoRunNormalEstimation
: public rgbd_planes::NormalEstimationBase<PointInT, PointOutT> {
  using Base = rgbd_planes::NormalEstimationBase<PointInT, PointOutT>;
  using Base::feature_name_;
  using Base::indices_;
  using Base::input_;
  using Base::surface_;

public:
  using Ptr = shared_ptr<TwoRunNormalEstimation<PointInT, PointOutT>>;
  using ConstPtr = shared_ptr<const TwoRunNormalEstimation<PointInT, PointOutT>>;
  using typename Base::PointCloudIn;
  using typename Base::PointCloudOut;

  TwoRunNormalEstimation() { feature_name_ = "TwoRunNormalEstimation"; }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~TwoRunNormalEstimation() override = default;

  /** \brief Neighbours within \a constant + \a linear * z; default 0.01 m + 0.01 z.
   *
   * z is the distance of a point from the sensor along the viewing axis: the z axis
   * of the sensor, as the \c sensor_orientation_ of the input has it, so that z is the
   * third coordinate of clouds in the frame of their camera. In any other frame \c
   * sensor_orientation_ must be set, or \a linear be 0. Whether the axis points
   * forwards or backwards does not matter.
   * \param[in] constant in metres, 0 or more
   * \param[in] linear 0 or more, not 0 if \a constant is; other values are refused with
   * an error
   */
  void
  setRadius (float constant, float linear)
  {
    setRadius (constant, linear, 0.f);
  }

  /** \brief Neighbours within max (\a constant + \a linear * z, \a quadratic * z^2),
   * for sensors whose noise grows with z^2: 0.01 m, 0.01 and 0.0085 / m do for a
   * Kinect.
   * \param[in] constant in metres, 0 or more
   * \param[in] linear 0 or more
   * \param[in] quadratic in 1 / m, 0 or more; not all of them 0; other values are
   * refused with an error
   */
  void
  setRadius (float constant, float linear, float quadratic);

  /** \brief Neighbours within any function of z, both in metres. Points where it is not
   * positive get no normal. It must not throw, and several threads call it at once.
   * \param[in] radius an empty function is refused with an error
   */
  void
  setRadius (const std::function<float (float)>& radius);

  /** \brief Take neighbours only from a window of pixels around the point, within the
   * radius still (section 3, after Holz et al. 2010): faster, and less smooth where the
   * radius spans more pixels. Organized clouds without a search surface only.
   * \param[in] window_size width and height in pixels, odd and 3 or more; 0 (default)
   * for all neighbours within the radius; other values are refused with an error
   */
  void
  setWindowSize (int window_size);

  /** \brief The number of threads; 0 (default) for one on each processor. The result
   * does not depend on it. */
  void
  setNumberOfThreads (unsigned int nr_threads = 0)
  {
    parameters_.threads = nr_threads;
  }

private:
  std::string
  complaint () const override;

  std::size_t
  computeNormals (PointCloudOut& output) override;

  rgbd_planes::TwoRunNormalParameters parameters_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/two_run_normal.hpp>
#endif
