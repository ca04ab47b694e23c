// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

// Programs have pcl::deg2rad from the header of OrganizedMultiPlaneSegmentation.
#include <pcl/common/angles.h>
#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/sensor_points.h>
#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/impl/plane_extraction.h>
#include <pcl/segmentation/impl/plane_outputs.h>
#include <pcl/segmentation/normal_space_grid.h>
#include <pcl/segmentation/planar_region.h>
#include <pcl/segmentation/plane_results.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/StdVector>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief All planes of an organized cloud, found by clustering its points in normal
 * space and then in distance space (Holz, Holzer, Rusu, Behnke: Real-Time Plane
 * Segmentation using RGB-D Cameras, 2011, section 4).
 *
 * A replacement for pcl::OrganizedMultiPlaneSegmentation. A plane is one cluster
 * however many unconnected parts of it are visible; getSegments () gives these parts.
 * Planes are always refined: segment () and segmentAndRefine () find the same.
 *
 * \code
 * pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
 * segmentation.setInputCloud (cloud);
 * segmentation.setInputNormals (normals);
 * segmentation.segment (model_coefficients, inlier_indices);
 * \endcode
 *
 * Input: an organized cloud in metres, in the camera frame or any other in which its \c
 * sensor_origin_ is the place of the sensor, as CameraToBase sets it, and one normal for each
 * point from any estimator. Points with NaN or Inf, and points (0, 0, 0), are left out. Points
 * without a normal of unit length start no plane, but belong to one on which they lie. With
 * indices, only these points are segmented. Output: planes by decreasing number of
 * points, with coefficients a, b, c, d such that a x + b y + c z + d = 0, (a, b, c) of unit
 * length, towards the sensor: d >= 0 where that is at the origin. Outputs are replaced, not
 * appended to, and carry the header of the input; their memory is used again, so that frames
 * like the one before allocate none.
 *
 * A null, empty or unorganized cloud, a \c sensor_origin_ that is not finite, normals that are
 * missing or of another size, or an index outside of the cloud: an error message and empty
 * outputs. All points farther off than 100 m, or no planes while no normal is of unit length or
 * all points are beyond the range of the sensor: a warning, once for frames in a row. What a
 * setter cannot take: an error message, and the value before stays. Several threads need an
 * object each.
 *
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT, typename PointLT = pcl::Label>
class PCL_RGBD_PLANES_EXPORTS NormalSpacePlaneSegmentation : public PCLBase<PointT> {
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::input_;

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
  using Regions =
      std::vector<PlanarRegion<PointT>, Eigen::aligned_allocator<PlanarRegion<PointT>>>;

  /** \brief The label of points that lie on no plane. */
  static constexpr std::uint32_t unlabelled = rgbd_planes::unlabelled;

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~NormalSpacePlaneSegmentation() override = default;

  /** \brief The organized cloud to segment. */
  void
  setInputCloud (const typename PCLBase<PointT>::PointCloudConstPtr& cloud) override
  {
    is_segmented_ = is_segmented_ && cloud == input_;
    PCLBase<PointT>::setInputCloud (cloud);
  }

  /** \brief One normal for each point of the input cloud, in the same order; of unit length,
   * to 5 % (others, as NaN, count as no normal), and of any sign. */
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

  /** \brief Planes with fewer points, or with fewer than 3, are not reported; default 1000, as
   * in OrganizedMultiPlaneSegmentation, which suits 640 x 480 pixels. */
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
   * and at most pi / 4, default 0.2. With the noise of active stereo, by less than 1.6 times
   * that: see DepthNoise::normal_scatter. What no plane took is clustered once more, with
   * twice the angle. */
  void
  setAngularThreshold (double angular_threshold);

  double
  getAngularThreshold () const
  {
    return parameters_.angular_threshold;
  }

  /** \brief How far from its plane a point may lie along the viewing ray, in metres at a
   * range of 1 m; more than 0. It grows with range as the noise of the sensor does: 0.02, a
   * usual value for PCL's class, is 0.22 m at 4 m. The default is 0.009, or 1.5 standard
   * deviations of that noise if it is less, or 4.5 if it is more; in frames with more noise than
   * the sensor has at least, those of that. Amid the plane points may lie 1.15 times as far, at its
   * borders 0.9 times. A plane that is seen at less than 6 degrees counts as seen at 6, so that
   * points on it may lie farther along the ray. */
  void
  setDistanceThreshold (double distance_threshold);

  double
  getDistanceThreshold () const
  {
    return parameters_.distanceThreshold();
  }

  /** \brief Planes with a larger curvature are dropped, as in OrganizedMultiPlaneSegmentation:
   * the smallest eigenvalue of the covariance of their points by its trace, which is at most 1 / 3.
   * It grows with noise, and so with range, and is larger for small planes: 0.001, the default of
   * PCL's class, drops most planes beyond 3 m. 0 or more (others: an error message), default 1,
   * which drops none. */
  void
  setMaximumCurvature (double maximum_curvature)
  {
    rgbd_planes::setParameter (getClassName() + "::setMaximumCurvature",
                               maximum_curvature,
                               parameters_.maximum_curvature);
  }

  double
  getMaximumCurvature () const
  {
    return parameters_.maximum_curvature;
  }

  /** \brief Points whose normals come with a larger curvature start no cluster, but may still join
   * a plane; the normals of those with more than half of it do not count. 0 or more (others: an
   * error message), default 0.08, which suits IntegralImageTangentNormalEstimation. */
  void
  setMaximumPointCurvature (double maximum_curvature)
  {
    rgbd_planes::setParameter (getClassName() + "::setMaximumPointCurvature",
                               maximum_curvature,
                               parameters_.max_point_curvature);
  }

  double
  getMaximumPointCurvature () const
  {
    return parameters_.max_point_curvature;
  }

  /** \brief Planes are dropped as parts of uneven surfaces, such as clothes, where a smaller
   * share of the normals of their points is near their own, and the points are farther off
   * than on flat surfaces; 0 to 1 (others: an error message), default 0.75, 0 keeps all.
   * Strips more than five times as long as wide are kept: around them, normals are averages
   * with what lies beside. Planes more than 0.6 m wide need 0.8 times the share only, and
   * less in proportion to their width, as clothes are hardly so wide, and the normals of walls
   * scatter where the camera bends them or pixels are missing. */
  void
  setMinimumNearNormals (double share)
  {
    rgbd_planes::setParameter (getClassName() + "::setMinimumNearNormals",
                               share,
                               parameters_.min_near_normals,
                               rgbd_planes::Zero::allowed,
                               1.);
  }

  double
  getMinimumNearNormals () const
  {
    return parameters_.min_near_normals;
  }

  /** \brief The noise of the sensor, which says how far the points of a plane spread; default
   * rgbd_planes::DepthNoise::kinectV1 (). Points beyond its range are on no plane. One that is not
   * valid: an error message, and the noise before stays. */
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

  /** \brief Which of the two grids of section 4.1 of the paper collects the normals: voxels
   * (default), or cells of their spherical coordinates. */
  void
  setNormalSpaceGrid (rgbd_planes::NormalSpaceGrid grid)
  {
    parameters_.grid = grid;
  }

  rgbd_planes::NormalSpaceGrid
  getNormalSpaceGrid () const
  {
    return parameters_.grid;
  }

  /** \brief The minimum of points in a cell of that grid (section 4.1 of the paper), as a share
   * of all pixels; 0 to 1 (others: an error message), default 0.00025, 0 takes all cells with
   * points. */
  void
  setMinimumCellShare (double share)
  {
    rgbd_planes::setParameter (getClassName() + "::setMinimumCellShare",
                               share,
                               parameters_.min_cell_share,
                               rgbd_planes::Zero::allowed,
                               1.);
  }

  double
  getMinimumCellShare () const
  {
    return parameters_.min_cell_share;
  }

  /** \brief Whether points of contours are moved onto their plane, along their viewing rays
   * as ProjectOntoPlanes does by default; default false: they are points of the input. */
  void
  setProjectPoints (bool project_points)
  {
    project_points_ = project_points;
  }

  bool
  getProjectPoints () const
  {
    return project_points_;
  }

  /** \brief Finds all planes.
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   */
  void
  segment (std::vector<ModelCoefficients>& model_coefficients,
           std::vector<PointIndices>& inlier_indices);

  /** \brief Finds all planes, for ObstacleDetection and PlaneTracker.
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   * \param[out] labels the plane of each point, or \ref unlabelled; size of the input
   */
  void
  segment (std::vector<ModelCoefficients>& model_coefficients,
           std::vector<PointIndices>& inlier_indices,
           PointCloudL& labels);

  /** \brief Finds all planes.
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   * \param[out] centroids the mean of the points of each plane, with 1 as last
   * component, in the frame of the cloud
   * \param[out] covariances the covariance of the points of each plane, in metres^2
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

  /** \brief Finds all planes.
   * \param[out] regions the planes with their coefficients, the centroid, covariance,
   * curvature (smallest eigenvalue of the covariance by its trace) and number of all their
   * points, and the contour of their largest connected part: its outer boundary in the
   * image, clockwise, without repeating the first point at the end
   */
  void
  segment (Regions& regions);

  /** \brief The same as segment (regions). */
  void
  segmentAndRefine (Regions& regions)
  {
    segment (regions);
  }

  /** \brief Finds all planes.
   * \param[out] regions as segment (regions) gives them
   * \param[out] model_coefficients a, b, c, d of each plane
   * \param[out] inlier_indices the points of each plane, in ascending order
   * \param[out] labels the plane of each point, or \ref unlabelled; size of the input;
   * created if null
   * \param[out] label_indices the same as \a inlier_indices: one entry for each label
   * \param[out] boundary_indices the points of each contour, in its order
   */
  void
  segmentAndRefine (Regions& regions,
                    std::vector<ModelCoefficients>& model_coefficients,
                    std::vector<PointIndices>& inlier_indices,
                    PointCloudLPtr& labels,
                    std::vector<PointIndices>& label_indices,
                    std::vector<PointIndices>& boundary_indices);

  /** \brief Gives the planes of the last segment () again, which has refined them: what is
   * passed in is replaced, and planes of other classes are not grown. For pipelines that
   * refine what they segmented. Without a segment () of the input cloud, which has another
   * size or time stamp if it is filled anew: an error message, and the arguments stay as they are.
   */
  void
  refine (std::vector<ModelCoefficients>& model_coefficients,
          std::vector<PointIndices>& inlier_indices,
          PointCloudLPtr& labels,
          std::vector<PointIndices>& label_indices);

  /** \brief The connected parts of the planes of the last call: points whose pixels touch
   * by a side or a corner (8-connected). Parts with fewer points than getMinInliers () are
   * left out.
   * \param[out] segment_indices the points of each part, in ascending order; parts by
   * their first points
   * \param[out] plane_of_segment the plane of each part
   */
  void
  getSegments (std::vector<PointIndices>& segment_indices,
               std::vector<std::size_t>& plane_of_segment);

  /** \brief Root of the mean squared distance of the points of each plane of the last call
   * to it, in metres, to some 0.1 mm. */
  const std::vector<double>&
  getRms () const
  {
    return rms_;
  }

  /** \brief Covariance of a, b, c, d of each plane of the last call: to first order in the
   * noise, which is that of getDepthNoise (), or more in frames that have more, along the
   * viewing rays, and independent for each point (neighbouring pixels of real sensors are
   * not, so that planes are less certain). a, b, c in units of 1, d in metres; of rank 3,
   * for (a, b, c) keeps its length. */
  const std::vector<Eigen::Matrix4d>&
  getParameterCovariances () const
  {
    return plane_extraction_.parameterCovariances();
  }

  /** \brief How many candidates of the last call did not become planes, and why. */
  const rgbd_planes::PlaneRejections&
  getRejections () const
  {
    return plane_extraction_.rejections();
  }

  /** \brief How long each stage of the last call took, in seconds. */
  const rgbd_planes::PlaneStageTimes&
  getStageTimes () const
  {
    return plane_extraction_.stageTimes();
  }

protected:
  virtual std::string
  getClassName () const
  {
    return "NormalSpacePlaneSegmentation";
  }

  rgbd_planes::PlaneExtractionParameters parameters_;

private:
  bool
  checkInput () const;

  /** \brief Finds the planes and, for every point, the one it lies on; none in bad
   * input. */
  void
  extract ();

  void
  findPlanes ();

  void
  warnOfInput ();

  /** \brief Whether the last call was for the input as it is now. */
  bool
  isSegmented () const;

  void
  fillLabels (PointCloudL& labels) const;

  void
  fillRegions (Regions& regions, std::vector<PointIndices>& boundary_indices);

  void
  fillContour (const Indices& boundary,
               const Eigen::Vector4f& plane,
               typename pcl::PointCloud<PointT>::VectorType& contour) const;

  PointCloudNConstPtr normals_;
  bool project_points_ = false;
  bool is_segmented_ = false;
  rgbd_planes::PlaneExtraction plane_extraction_;

  // Of the last call:
  PCLHeader header_;
  Eigen::Vector4f sensor_origin_ = Eigen::Vector4f::Zero();
  Eigen::Quaternionf sensor_orientation_ = Eigen::Quaternionf::Identity();
  std::uint32_t width_ = 0;
  bool is_warned_of_normals_ = false, is_warned_of_units_ = false,
       is_warned_of_range_ = false;
  std::vector<double> rms_;

  // Memory that is used again:
  rgbd_planes::SensorPoints relative_points_;
  std::vector<std::uint8_t> selected_;
  rgbd_planes::PlaneOutputs outputs_;
  std::vector<PointIndices> boundary_indices_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/segmentation/impl/normal_space_plane_segmentation.hpp>
#endif
