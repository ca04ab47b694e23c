// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/feature.h>
// Programs have computePointNormal and flipNormalTowardsViewpoint from PCL's headers of normals.
#include <pcl/features/normal_3d.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/point_types.h>

#include <array>
#include <cstddef>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief What the normal estimators share: the viewpoint, the check of the input, and
 * everything of the output but normals and curvatures.
 *
 * Output: as many points as the input (width x height kept), or one for each index
 * (N x 1) when indices are given, in their order; header and pose of the sensor are
 * those of the input; \c is_dense tells whether all normals are valid; coordinates are
 * copied where PointOutT has them. Without indices, the output may be the input cloud. A
 * null cloud, a \c sensor_origin_ that is not finite, an index outside of the cloud, indices where
 * output and input are the same cloud, or what an estimator refuses: one error message and an
 * empty output (0 x 0).
 *
 * The neighbourhoods of Feature (setKSearch, setRadiusSearch, setSearchMethod) have no
 * effect: no search structure is built, and clouds need not be projective.
 */
template <typename PointInT, typename PointOutT>
class PCL_RGBD_PLANES_EXPORTS NormalEstimationBase
: public Feature<PointInT, PointOutT> {
public:
  using PointCloudIn = typename Feature<PointInT, PointOutT>::PointCloudIn;
  using PointCloudOut = typename Feature<PointInT, PointOutT>::PointCloudOut;

  /** \brief Normals face this point, in the frame and unit of the points. It tells
   * nothing else: ranges are distances from the sensor origin of the input, which has to be
   * set in clouds that are not in the frame of their sensor, as CameraToBase does. One that is
   * not finite: an error message, and the one before stays. */
  void
  setViewPoint (float vpx, float vpy, float vpz);

  /** \brief The viewpoint in use: the one set, or else the sensor origin of the input,
   * or else (0, 0, 0). */
  void
  getViewPoint (float& vpx, float& vpy, float& vpz) const;

  /** \brief Take the sensor origin of the input cloud as the viewpoint (default). */
  void
  useSensorOriginAsViewPoint ()
  {
    use_sensor_origin_ = true;
  }

protected:
  using Feature<PointInT, PointOutT>::fake_indices_;
  using Feature<PointInT, PointOutT>::feature_name_;
  using Feature<PointInT, PointOutT>::indices_;
  using Feature<PointInT, PointOutT>::input_;
  using Feature<PointInT, PointOutT>::use_indices_;

  /** \brief Checks the input; the search structures of Feature are not needed. */
  bool
  initCompute () override;

  /** \brief The \c sensor_origin_ of the input, (0, 0, 0) without one. */
  std::array<float, 3>
  sensorOrigin () const;

  /** \brief Whether normals are wanted for given indices, all of them even, instead of
   * the cloud as it is. */
  bool
  forIndices () const
  {
    return use_indices_ && !fake_indices_;
  }

private:
  /** \brief What is wrong with the input, which is not null, or with the settings for
   * it, and what to do, in one sentence; empty if nothing. */
  virtual std::string
  complaint () const = 0;

  /** \brief Writes normals and curvatures to \a output, which has its size and is not
   * empty; NaN where there is none. After an error message, \a output is cleared.
   * \return the number of normals that are not NaN
   */
  virtual std::size_t
  computeNormals (PointCloudOut& output) = 0;

  void
  computeFeature (PointCloudOut& output) final;

  /** \brief Turns normals that face away from the viewpoint. */
  void
  faceViewpoint (PointCloudOut& output) const;

  std::array<float, 3> viewpoint_{{0.f, 0.f, 0.f}};
  bool use_sensor_origin_ = true;
};

} // namespace rgbd_planes
} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/features/impl/normal_estimation_base.hpp>
#endif
