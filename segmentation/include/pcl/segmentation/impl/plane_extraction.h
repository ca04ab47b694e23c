// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/bent_ends.h>
#include <pcl/segmentation/impl/curved_patches.h>
#include <pcl/segmentation/impl/distance_space_clusters.h>
#include <pcl/segmentation/impl/label_runs.h>
#include <pcl/segmentation/impl/normal_space_clusters.h>
#include <pcl/segmentation/impl/plane_additions.h>
#include <pcl/segmentation/impl/plane_assignment.h>
#include <pcl/segmentation/impl/plane_growth.h>
#include <pcl/segmentation/impl/plane_joining.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/sample_components.h>
#include <pcl/segmentation/impl/step_split.h>
#include <pcl/segmentation/plane_results.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The settings of PlaneExtraction. */
struct PlaneExtractionParameters {
  /** Planes with fewer points are dropped. */
  unsigned min_inliers = 1000;
  /** Clusters whose mean normals differ by less are merged; radians. */
  double angular_threshold = 0.2;
  /** Largest distance of a point from its plane, along the viewing ray, at a range of
   * 1 m, in metres; elsewhere the same number of standard deviations of depth. 0: see
   * distanceThreshold. */
  double distance_threshold = 0.;
  /** Planes whose points have a larger PlaneMoments::curvature are dropped. */
  double maximum_curvature = 1.;
  /** Points with a larger curvature start no cluster; with more than half of it, they may
   * join a plane whatever their normal. */
  double max_point_curvature = 0.08;
  /** Planes with a smaller share of normals near their own are dropped where their points are
   * far off. */
  double min_near_normals = 0.75;
  NormalSpaceGrid grid = NormalSpaceGrid::voxels;
  /** Cells of that grid with a smaller share of all points belong to no cluster. */
  double min_cell_share = 2.5e-4;
  DepthNoise noise = DepthNoise::kinectV1();
  PlaneAdditions additions;

  /** Its default suits a Kinect and its like, whose planes are bent as well; sensors with
   * less noise tell smaller steps, and those with more need more. */
  double
  distanceThreshold () const
  {
    const double sigma = noise.sigmaAtSquare (1.f);
    return distance_threshold > 0. ? distance_threshold
                                   : std::clamp (0.009, 1.5 * sigma, 4.5 * sigma);
  }
};

/** \brief All planes of an organized cloud: clusters in normal space, split in distance
 * space (Holz et al. 2011, section 4), then refined.
 *
 * Clusters are found on PlaneSamples. The refinement grows planes from their connected
 * parts, largest first (PlaneGrowth); what no plane took is clustered once more. Parts of
 * the same plane are joined, planes are parted at steps (StepSplit), and strips are joined
 * (PlaneJoining). Then each point of the image gets the nearest one of the planes around it
 * or, where two planes meet, the one on its side (PlaneAssignment), and planes are fitted to
 * their points.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneExtraction {
public:
  /** \brief Finds the planes.
   * \param[in] points in a frame whose origin is the sensor
   * \param[in] normals one for each point
   * \param[in] selected not 0 for the points to look at; empty for all
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

  /** \brief Turns the planes into those of points that are shifted by \a shift. */
  void
  shift (const Eigen::Vector3f& shift);

  /** \brief Sums over the points of each plane, with weights of 1. */
  const std::vector<PlaneMoments>&
  moments () const
  {
    return moments_;
  }

  /** \brief The covariance of the coefficients (a, b, c, d) of each plane, to first
   * order, if the errors of its points are independent and as the noise model says. */
  const std::vector<Eigen::Matrix4d>&
  parameterCovariances () const
  {
    return parameter_covariances_;
  }

  /** \brief The plane of each point, or \ref unlabelled. */
  const std::vector<std::uint32_t>&
  labels () const
  {
    return assignment_.labels();
  }

  const LabelRuns&
  runs () const
  {
    return runs_;
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
  findParts ();

  void
  growParts ();

  void
  joinParts ();

  void
  giveTo (const std::vector<PlaneMoments>& planes,
          const std::vector<std::int32_t>& plane_of_part);

  void
  assign (const OrganizedPoints& points, const std::vector<std::uint8_t>& selected);

  void
  fitToSamples ();

  bool
  isPatch (std::size_t plane) const;

  bool
  isLarge (const PlaneMoments& points) const;

  void
  finish (const OrganizedPoints& points);

  PlaneExtractionParameters parameters_;
  float max_sigmas_ = 0.f;
  /** How many times as far as those of a Kinect v1 means of clusters scatter. */
  float cluster_scatter_ = 1.f;
  PlaneSamples samples_;
  NormalSpaceClusters normal_clusters_;
  DistanceSpaceClusters distance_clusters_;
  SampleComponents components_;
  PlaneGrowth growth_;
  PlaneJoining joining_;
  BentEnds ends_;
  StepSplit steps_;
  CurvedPatches patches_;
  PlaneAssignment assignment_;
  std::vector<std::int32_t> owners_;
  std::vector<TilePart> parts_;
  std::vector<Plane> planes_;
  std::vector<PlaneMoments> moments_;
  std::vector<Eigen::Matrix4d> parameter_covariances_;
  std::vector<std::uint32_t> order_, numbers_;
  LabelRuns runs_;
  PlaneRejections rejections_;
  PlaneStageTimes times_;
};

} // namespace rgbd_planes
} // namespace pcl
