// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/ground_rectangle.h>
#include <pcl/segmentation/impl/support_planes.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A box that rests on a plane, or above it on another thing. */
struct ObjectBox {
  Eigen::Vector3f center = Eigen::Vector3f::Zero(); /**< in the camera frame */
  /** Columns are the directions of its sides, right-handed; the last one is the normal of
   * the plane. */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f size = Eigen::Vector3f::Zero(); /**< along \ref axes */
  /** The smallest side, but for the first one where noise explains that: of what shows only its
   * front, nobody knows how deep it is. */
  float smallest_known_side = 0.f;
};

/** \brief Finds boxes, and keeps its buffers for the next one. */
class PCL_RGBD_PLANES_EXPORTS ObjectBoxFinder {
public:
  /** \brief The box from the plane, or from a bottom above it, to the top of the points, with a
   * GroundRectangle around them; a few points, such as flying pixels, may stick out.
   *
   * Noise of depth spreads points along the view. Where a front and a top are seen, the
   * near end is where the front is in the mean. The far end is half-way between the furthest
   * points, of all or of the top alone, and where it is if the top is seen evenly from the
   * front to there: all of the top is more certain than a margin that few pixels see at a
   * flat angle.
   * \param[in] indices measured points, at least one
   * \param[in] bottom height above the plane, lower than the points; 0 or more
   */
  ObjectBox
  compute (const OrganizedPoints& points,
           const pcl::Indices& indices,
           const SupportSurface& support,
           float bottom,
           const DepthNoise& noise);

private:
  /** \brief How the camera sees a thing; heights are those above the supporting plane. */
  struct View {
    float camera_height = 0.f;
    float sigma = 0.f; // of depth
    /** The part of the ray to the middle, of length 1, that lies in the plane, and how much
     * it falls towards the plane. */
    Eigen::Vector2f away = Eigen::Vector2f::Zero();
    float rise = 0.f;
    float top = 0.f;        // in the mean
    float top_margin = 0.f; // points further below or above are not of the top
  };

  /** \brief How the camera sees the points at hand, the highest ones at \a height. */
  View
  viewFrom (float camera_height, float height, const DepthNoise& noise) const;

  /** \brief Moves the ends of the range along a direction away from the camera to where they
   * are without noise, if a front and a top are seen. */
  CoordinateRange
  withoutNoise (const CoordinateRange& range,
                const Eigen::Vector2f& direction,
                const View& view);

  std::vector<Eigen::Vector2f> projected_;
  std::vector<float> heights_;
  // Of the top, along the view: points, and where their rays meet it.
  std::vector<float> measured_, met_;
  GroundRectangle rectangle_;
  std::vector<Eigen::Vector2f> border_;
  std::vector<Eigen::Vector2f> hull_;
};

} // namespace rgbd_planes
} // namespace pcl
