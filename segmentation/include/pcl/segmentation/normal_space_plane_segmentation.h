// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/plane_extraction.h>

#include <Eigen/Core>
#include <Eigen/StdVector>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief All planes of an organized cloud, found by clustering its points in normal
 * space and then in distance space (Holz, Holzer, Rusu, Behnke: Real-Time Plane
 * Segmentation using RGB-D Cameras, 2011, section 4).
 *
 * A replacement for pcl::OrganizedMultiPlaneSegmentation. A plane is one cluster
 * however many unconnected parts of it are visible.
 *
 * \code
 * pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
 * segmentation.setInputCloud (cloud);
 * segmentation.setInputNormals (normals);
 * segmentation.segment (model_coefficients, inlier_indices);
 * \endcode
 *
 * Input: an organized cloud in metres, in the camera frame (or any frame whose origin
 * is the sensor), and one normal for each point from any estimator. Points or normals
 * with NaN or Inf, and points (0, 0, 0), are left out. With indices, only these points
 * are segmented. Output: planes by decreasing number of points, with coefficients a, b,
 * c, d such that a x + b y + c z + d = 0, (a, b, c) of unit length and d >= 0, so that
 * the normal faces the sensor. Outputs are replaced, not appended to, and carry the
 * header of the input.
 *
 * A null, empty or unorganized cloud, normals that are missing or of another size, or
 * an index outside of the cloud: an error message and empty outputs.
 *
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT, typename PointLT = pcl::Label>
class PCL_RGBD_PLANES_EXPORTS NormalSpacePlaneSegmentation : public PCLBase<PointT> {
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::use_indices_;

public:
  using Ptr = shared_ptr<NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>>;
  using ConstPtr =
      shared_ptr<const NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>>;

  using PointCloudN = pcl::PointCloud<PointNT>;
  using PointCloudNPtr = typename PointCloudN::Ptr;
  using PointCloudNConstPtr = typename PointCloudN::ConstPtr;

  using PointCloudL = pcl::PointCloud<PointLT>;
  using PointCloudLPtr = typename PointCloudL::Ptr;
  using PointCloudLConstPtr = typename PointCloudL::ConstPtr;

  using Centroids =
      std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>;
  using Covariances =
      std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>>;

  /** \brief The label of points that lie on no plane. */
  static constexpr std::uint32_t unlabelled = rgbd_planes::unlabelled;

  /** \brief One normal for each point of the input cloud, in the same order. */
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

  /** \brief Planes with fewer points are not reported; default 1000, as in
   * OrganizedMultiPlaneSegmentation. */
  void
  setMinInliers (unsigned min_inliers)
  {
    parameters_.min_inliers = min_inliers;
  }

  unsigned
  getMinInliers () const
  {
    return parameters_.min_inliers;
  }

  /** \brief Clusters whose mean normals differ by less are merged; radians, more than 0
   * and at most pi / 4. */
  void
  setAngularThreshold (double angular_threshold);

  double
  getAngularThreshold () const
  {
    return parameters_.angular_threshold;
  }

  /** \brief How far from its plane a point may lie, in metres at a range of 1 m; grows
   * with range as the noise of the sensor does, more than 0. */
  void
  setDistanceThreshold (double distance_threshold);

  double
  getDistanceThreshold () const
  {
    return parameters_.distance_threshold;
  }

  /** \brief Points with a larger curvature start no cluster, but may still join a
   * plane. */
  void
  setMaximumCurvature (double maximum_curvature)
  {
    parameters_.maximum_curvature = static_cast<float> (maximum_curvature);
  }

  double
  getMaximumCurvature () const
  {
    return parameters_.maximum_curvature;
  }

  /** \brief Finds all planes.
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   */
  void
  segment (std::vector<ModelCoefficients>& model_coefficients,
           std::vector<PointIndices>& inlier_indices);

  /** \brief Finds all planes.
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   * \param[out] centroids the mean of the points of each plane, with 1 as last
   * component
   * \param[out] covariances the covariance of the points of each plane
   * \param[out] labels the plane of each point, or \ref unlabelled; size of the input
   * \param[out] label_indices the same as \a inlier_indices: one entry for each label
   */
  void
  segment (std::vector<ModelCoefficients>& model_coefficients,
           std::vector<PointIndices>& inlier_indices,
           Centroids& centroids,
           Covariances& covariances,
           PointCloudL& labels,
           std::vector<PointIndices>& label_indices);

  /** \brief How long each stage of the last call took. */
  const rgbd_planes::PlaneStageTimes&
  getStageTimes () const
  {
    return plane_extraction_.stageTimes();
  }

protected:
  std::string
  getClassName () const
  {
    return "NormalSpacePlaneSegmentation";
  }

private:
  bool
  checkInput () const;

  /** \brief Finds the planes and, for every point, the one it lies on. */
  bool
  extract ();

  void
  fillModels (std::vector<ModelCoefficients>& model_coefficients,
              std::vector<PointIndices>& inlier_indices) const;

  PointCloudNConstPtr normals_;
  rgbd_planes::PlaneExtractionParameters parameters_;
  rgbd_planes::PlaneExtraction plane_extraction_;
  std::vector<std::uint8_t> selected_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/normal_space_plane_segmentation.hpp>
#endif
