// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/filter.h>
#include <pcl/filters/impl/own_indices.h>
#include <pcl/filters/impl/plane_points.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Corrects depth: the points of planes move onto them (Holz et al. 2011, section
 * 5.2); all others stay as they are.
 *
 * \code
 * pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
 * projection.setInputCloud (cloud);
 * projection.setInputPlanes (model_coefficients, inlier_indices); // or with labels
 * projection.filter (*corrected);
 * \endcode
 *
 * Points move along their viewing ray, from the \c sensor_origin_ of the cloud through the
 * point, which keeps their pixel. Where a ray meets its plane so flat that the point would
 * move more than setMaxRayFactor times its distance from the plane, it moves along the
 * normal of the plane instead, as points do for Direction::normal.
 *
 * The output has all points of the input, its organization and its header; all fields but
 * coordinates stay. With indices, only these points move. Output and input may be the same
 * cloud. Points without a measurement (NaN, Inf or (0, 0, 0)) and those of planes without
 * four finite coefficients and a normal stay. Labels of another size than the input, not one
 * list of inliers for each plane, an index outside of the input, or a \c sensor_origin_ that is
 * not finite: an error message and an empty output. Without an input, after an error message of
 * PCL, the output stays as it was.
 *
 * \ingroup filters
 */
template <typename PointT>
class PCL_RGBD_PLANES_EXPORTS ProjectOntoPlanes
: public rgbd_planes::OwnIndices<Filter<PointT>> {
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::getClassName;
  using Filter<PointT>::indices_;
  using Filter<PointT>::input_;

public:
  using Ptr = shared_ptr<ProjectOntoPlanes<PointT>>;
  using ConstPtr = shared_ptr<const ProjectOntoPlanes<PointT>>;
  using typename Filter<PointT>::PointCloud;
  using Labels = pcl::PointCloud<pcl::Label>;

  /** \brief What a point moves along. */
  enum class Direction { viewing_ray, normal };

  ProjectOntoPlanes() { filter_name_ = "ProjectOntoPlanes"; }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~ProjectOntoPlanes() override = default;

  /** \brief The planes in the frame of the input and their points.
   * \param[in] model_coefficients a, b, c, d with a x + b y + c z + d = 0
   * \param[in] inlier_indices the points of each plane; a point of several planes moves
   * onto the last of them
   */
  void
  setInputPlanes (const std::vector<ModelCoefficients>& model_coefficients,
                  const std::vector<PointIndices>& inlier_indices);

  /** \brief The planes in the frame of the input and their points.
   * \param[in] model_coefficients a, b, c, d with a x + b y + c z + d = 0
   * \param[in] labels the plane of each point of the input, or a number beyond
   */
  void
  setInputPlanes (const std::vector<ModelCoefficients>& model_coefficients,
                  const Labels::ConstPtr& labels);

  /** \brief Default Direction::viewing_ray. */
  void
  setDirection (Direction direction)
  {
    direction_ = direction;
  }

  Direction
  getDirection () const
  {
    return direction_;
  }

  /** \brief How far along its ray a point may move, in distances from its plane: the
   * inverse of the sine of the angle between ray and plane; 0 or more (others: an error
   * message), default 10, about 6 degrees. */
  void
  setMaxRayFactor (float factor)
  {
    rgbd_planes::setParameter (
        getClassName() + "::setMaxRayFactor", factor, max_ray_factor_);
  }

  float
  getMaxRayFactor () const
  {
    return max_ray_factor_;
  }

protected:
  void
  applyFilter (PointCloud& output) override;

private:
  /** \brief What to tell a user whose planes are not those of the input; empty if they are. */
  std::string
  faultOfPlanes () const;

  /** \brief Fills in the plane of each point; false after an error message. */
  bool
  assignPlanes ();

  rgbd_planes::PlaneVectors planes_;
  std::vector<PointIndices> inliers_;
  Labels::ConstPtr labels_; // null where the points of planes are inliers_
  Direction direction_ = Direction::viewing_ray;
  float max_ray_factor_ = rgbd_planes::default_max_ray_factor;
  std::vector<std::uint32_t> plane_of_; // for each point; no plane: a number beyond
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/project_onto_planes.hpp>
#endif
