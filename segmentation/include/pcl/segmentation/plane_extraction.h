// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/distance_space_clusters.h>
#include <pcl/segmentation/normal_space_clusters.h>
#include <pcl/segmentation/plane_assignment.h>
#include <pcl/segmentation/plane_moments.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Which grid of section 4.1 collects the normals. */
enum class NormalSpaceGrid { voxels, spherical };

struct PlaneExtractionParameters {
  /** Planes with fewer points are dropped. */
  unsigned min_inliers = 1000;
  /** Clusters whose mean normals differ by less are merged; radians. */
  double angular_threshold = 0.15;
  /** Largest distance of a point from its plane at a range of 1 m, in metres; elsewhere
   * the same number of standard deviations of depth. */
  double distance_threshold = 0.009;
  /** Points with a larger curvature start no cluster, and those with more than a tenth
   * of it may join a plane whatever their normal. */
  float maximum_curvature = 0.02f;
  NormalSpaceGrid grid = NormalSpaceGrid::voxels;
  DepthNoise noise;
};

/** \brief Why candidates did not become planes: numbers of the last frame. */
struct PlaneRejections {
  std::size_t too_few_points = 0;
  std::size_t curved = 0;
  std::size_t claimed_by_larger = 0;
};

/** \brief Run time of each stage, in seconds. */
struct PlaneStageTimes {
  double normal_space = 0.;
  double distance_space = 0.;
  double refinement = 0.;
};

/** \brief All planes of an organized cloud: clusters in normal space, split in distance
 * space (Holz et al. 2011, section 4), then refined.
 *
 * The refinement fits a plane to each cluster, weighting points by the inverse variance
 * of their depth; joins clusters that lie on the plane of a larger one; lets the planes
 * claim their points, largest first, which takes the points from clusters that are no
 * plane of their own, such as in-between normals along creases; fits again, and gives
 * every point the nearest of the planes left around it.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneExtraction {
public:
  /** \brief Finds the planes.
   * \param[in] points in a frame whose origin is the sensor
   * \param[in] normals one for each point
   * \param[in] selected not 0 for the points to look at; one entry for each point, or
   * empty: all
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const std::vector<std::uint8_t>& selected,
           const PlaneExtractionParameters& parameters);

  /** \brief The planes, by decreasing number of points. */
  const std::vector<Plane>&
  planes () const
  {
    return planes_;
  }

  /** \brief Sums over the points of each plane, with weights of 1. */
  const std::vector<PlaneMoments>&
  moments () const
  {
    return moments_;
  }

  /** \brief The plane of each point, or \ref unlabelled. */
  const std::vector<std::uint32_t>&
  labels () const
  {
    return labels_;
  }

  /** \brief Covariance of (a, b, c, d) of each plane. */
  const std::vector<Eigen::Matrix4d>&
  parameterCovariances () const
  {
    return parameter_covariances_;
  }

  const PlaneRejections&
  rejections () const
  {
    return rejections_;
  }

  const PlaneStageTimes&
  stageTimes () const
  {
    return times_;
  }

private:
  void
  markUse (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const std::vector<std::uint8_t>& selected);

  void
  fitCandidates (const OrganizedPoints& points);

  void
  joinCoplanar ();

  void
  refine (const OrganizedPoints& points, const OrganizedNormals& normals);

  enum class Weights { ones, inverse_variances };

  void
  sumMoments (const OrganizedPoints& points, std::size_t planes, Weights weights);

  void
  keepPlanes (std::size_t min_points);

  float
  maxSigmas () const;

  PlaneExtractionParameters parameters_;
  std::vector<std::uint8_t> use_;
  NormalSpaceClusters normal_clusters_;
  DistanceSpaceClusters distance_clusters_;
  PlaneAssignment assignment_;
  std::vector<Plane> planes_;
  std::vector<PlaneMoments> moments_;
  std::vector<Eigen::Matrix4d> parameter_covariances_;
  PlaneRejections rejections_;
  std::vector<std::uint32_t> labels_;
  PlaneStageTimes times_;
};

} // namespace rgbd_planes
} // namespace pcl
