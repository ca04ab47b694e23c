// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/PCLHeader.h>
#include <pcl/segmentation/impl/convex_outline.h>
#include <pcl/segmentation/impl/image_margins.h>
#include <pcl/segmentation/impl/linked_runs.h>
#include <pcl/segmentation/impl/object_parameters.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_warp.h>
#include <pcl/segmentation/impl/ransac_sample.h>
#include <pcl/segmentation/support_plane.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace pcl {
namespace rgbd_planes {

class MainPart;

/** \brief A plane as a segmentation found it. */
struct SegmentedPlane {
  Plane plane;
  const pcl::Indices* inliers = nullptr; /**< in ascending order */
};

/** \brief What pcl::SupportPlane describes, relative to the sensor, and what the search for
 * things on it needs. */
struct SupportSurface {
  std::size_t index = 0; /**< among the planes of the segmentation */
  Plane plane;
  /** Directions in the plane; axis_x, axis_y and the normal are right-handed. */
  Eigen::Vector3f axis_x = Eigen::Vector3f::Zero(), axis_y = Eigen::Vector3f::Zero();
  float height = 0.f; /**< of the centre of its points in the base frame */
  ConvexOutline outline;
  ConvexOutline surroundings; /**< the outline and the largest overhang */
  PlaneWarp warp;             /**< of planes that are not on an object */
  bool is_on_object = false;
  bool is_platform = false;

  Eigen::Vector2f
  project (const float* p) const
  {
    const Eigen::Map<const Eigen::Vector3f> point (p);
    return {axis_x.dot (point), axis_y.dot (point)};
  }

  Eigen::Vector3f
  unproject (const Eigen::Vector2f& q) const
  {
    return q.x() * axis_x + q.y() * axis_y - plane.d * plane.normal;
  }
};

/** \brief Whether noise of up to \a sigmas standard deviations explains the \a height of a
 * point above a plane: depth errs along the ray, and only a part of that points up. */
inline bool
isWithinNoise (const float* p,
               const Plane& plane,
               float height,
               float sigmas,
               const DepthNoise& noise)
{
  // The ray of length 1 rises by (height - d) / range: without division and root.
  const float squared = squaredRange (p);
  const float rise = sigmas * noise.sigmaAtSquare (squared) * (height - plane.d);
  return height * height * squared <= rise * rise;
}

/** \brief Points so many standard deviations from a plane may belong to it. */
constexpr float plane_sigmas = 2.f;

/** \brief Whether a point at \a height above \a plane may belong to it: within half the smallest
 * height of an object, or \ref plane_sigmas. */
inline bool
mayBeOnPlane (const float* p,
              const Plane& plane,
              float height,
              const ObjectParameters& parameters)
{
  return std::fabs (height) <= 0.5f * parameters.min_object_height ||
         isWithinNoise (p, plane, height, plane_sigmas, parameters.noise);
}

/** \brief Things have at least such a share of their points over the hull of their plane. */
constexpr double over_hull_share = 0.25;

/** \brief Whether nearly all points of a thing lie over the hull of a plane, most of them above
 * it and the rest, such as its foot, where noise may have them on it. */
PCL_RGBD_PLANES_EXPORTS bool
liesAbove (const OrganizedPoints& points,
           const std::vector<PointRun>& thing,
           const SupportSurface& support,
           const ObjectParameters& parameters);

/** \brief Describes planes for users.
 * \param[in] sensor where the sensor is in the frame of the cloud
 * \param[in] header of the cloud
 * \param[out] planes one for each of \a supports
 */
PCL_RGBD_PLANES_EXPORTS void
describe (const std::vector<SupportSurface>& supports,
          const Eigen::Vector3f& sensor,
          const PCLHeader& header,
          std::vector<SupportPlane>& planes);

/** \brief Whether nearly all points of a thing lie on one of \a planes. */
PCL_RGBD_PLANES_EXPORTS bool
liesOnOneOf (const std::vector<SegmentedPlane>& planes,
             const OrganizedPoints& points,
             const std::vector<PointRun>& thing,
             const DepthNoise& noise);

/** \brief Finds the horizontal planes in a range of heights, optimises their models and
 * computes their hulls (Holz et al. 2011, section 5.1). */
class PCL_RGBD_PLANES_EXPORTS SupportPlanes {
public:
  /** \param[in] camera_to_base to a frame whose z axis points up */
  void
  compute (const OrganizedPoints& points,
           const std::vector<SegmentedPlane>& planes,
           const Eigen::Affine3f& camera_to_base,
           const ObjectParameters& parameters);

  /** \brief From the highest to the lowest. */
  const std::vector<SupportSurface>&
  planes () const
  {
    return supports_;
  }

  const SupportRejections&
  rejections () const
  {
    return rejections_;
  }

  /** \brief The planes many of whose points are neither on nor above a supporting one, and those
   * from one side of the image to the other, such as walls. */
  const std::vector<SegmentedPlane>&
  background () const
  {
    return background_;
  }

  /** \brief The margins of the image, which cut things. */
  const ImageMargins&
  margins () const
  {
    return margins_;
  }

private:
  /** \brief A level plane that is not too high. */
  struct Candidate {
    std::size_t index; /**< among the planes of the segmentation */
    Plane plane;
    float height; /**< of the centre of its points in the base frame */
    float noise;  /**< how far off that may be */
  };

  void
  findCandidates (const OrganizedPoints& points,
                  const std::vector<SegmentedPlane>& planes,
                  const Eigen::Affine3f& camera_to_base,
                  const ObjectParameters& parameters);

  float
  lowestHeight (const ObjectParameters& parameters) const;

  /** \brief The plane that most of a sample of the points agree on: RANSAC that starts
   * from the model at hand, then least squares over the points that agree. */
  Plane
  optimise (const OrganizedPoints& points,
            const SegmentedPlane& segmented,
            const DepthNoise& noise);

  void
  outline (const OrganizedPoints& points,
           const pcl::Indices& inliers,
           const MainPart& part,
           const ObjectParameters& parameters,
           const SupportSurface& support,
           ConvexOutline& hull);

  void
  findSurroundings (const ObjectParameters& parameters, SupportSurface& support);

  void
  markPlanesOnObjects (const OrganizedPoints& points,
                       const std::vector<SegmentedPlane>& planes,
                       const ObjectParameters& parameters);

  bool
  makePlatform (const OrganizedPoints& points,
                const pcl::Indices& inliers,
                const ObjectParameters& parameters,
                SupportSurface& support);

  void
  findBackground (const OrganizedPoints& points,
                  const std::vector<SegmentedPlane>& planes,
                  const ObjectParameters& parameters);

  std::vector<Candidate> candidates_;
  std::vector<SupportSurface> supports_;
  std::vector<SegmentedPlane> background_;
  ImageMargins margins_;
  SupportRejections rejections_;
  RansacSample sample_;
  std::vector<Eigen::Vector2f> border_;
  ConvexOutline main_outline_; // of a plane that may be a platform
};

} // namespace rgbd_planes
} // namespace pcl
