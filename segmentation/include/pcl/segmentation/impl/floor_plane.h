// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/impl/plane_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The planes of a frame, as the segmentation gives them. */
struct LabelledPlanes {
  /** a, b, c, d of each plane in the camera frame, unit normals that face the camera. */
  PlaneVectors coefficients;
  /** The plane of point i is labels[i * stride]; others lie on none. */
  const std::uint32_t* labels = nullptr;
  std::size_t stride = 0;

  std::uint32_t
  operator[] (std::size_t point) const
  {
    return labels[point * stride];
  }
};

/** \brief The variance of the height of a point near a floor.
 *
 * Noise moves a point along its ray, and the flatter that meets the floor, the less the
 * height changes.
 * \param[in] camera_height distance of the camera from the floor
 * \return NaN or Inf for a point that is no measurement, or too far for one
 */
inline float
heightVariance (const float* point, float camera_height, const DepthNoise& noise)
{
  const float squared_range = squaredRange (point);
  const float sigma = camera_height * noise.sigmaAtSquare (squared_range);
  const float variance = sigma * sigma / squared_range;
  return squared_range <= noise.maxSquaredRange()
             ? variance
             : std::numeric_limits<float>::quiet_NaN();
}

/** \brief How far \a point is above a floor. */
inline float
heightAbove (const Eigen::Vector4f& floor, const float* point)
{
  return floor[0] * point[0] + floor[1] * point[1] + floor[2] * point[2] + floor[3];
}

/** \brief Which of the planes of a frame is the floor, and which are no part of it. */
class PCL_RGBD_PLANES_EXPORTS FloorPlane {
public:
  /** \brief Finds the floor: of the planes whose normal is the z axis of the base frame
   * within \a max_angle (radians) and that is at z = 0 within \a max_height (metres), in
   * the weighted mean of its points or below the base, the one whose points have the largest
   * weight in all. A weight falls with the fourth power of range, for a robot stands on what
   * is near, and with the square of how far off the plane is within \a max_height. Where another
   * one lies lower than that, and is nearer to z = 0, it is the floor: a step before the robot is
   * nearer than the floor that it stands on. So is one with half as many points that is less
   * tilted by 3 degrees and no farther from z = 0: ramps begin there.
   *
   * The points of about 80 columns and 60 rows are looked at.
   */
  void
  find (const OrganizedPoints& points,
        const LabelledPlanes& planes,
        const Eigen::Affine3f& camera_to_base,
        const DepthNoise& noise,
        float max_angle,
        float max_height);

  bool
  isFound () const
  {
    return found_;
  }

  /** \brief a, b, c, d of the floor in the camera frame; zeros where none was found. */
  const Eigen::Vector4f&
  coefficients () const
  {
    return coefficients_;
  }

  /** \brief What drop-offs are below, in the camera frame: the floor, or z = 0 of the base
   * frame where none was found; zeros where the camera is not above that either. */
  const Eigen::Vector4f&
  reference () const
  {
    return reference_;
  }

  /** \brief Whether points of a plane are no floor even where they are as low: it is
   * tilted against the floor by more than 5 degrees, and more than a fifth of its points
   * are above or below the floor by more than three standard deviations; up to 26 degrees,
   * which the error of depth bends pieces of the floor by, also by more than 3 cm or three
   * standard deviations of depth, whichever is less. False for \a plane beyond those of the
   * frame, no plane at all. */
  bool
  differs (std::uint32_t plane) const
  {
    return plane < samples_.size() && samples_[plane].is_other;
  }

  /** \brief Whether a plane is likely more of the floor, which the error of depth bent:
   * it is not the floor that was found, there is no step where they meet in the image, and
   * either it is tilted against it by less than 5 degrees, and less than 1.75 standard
   * deviations of depth above or below, in the weighted mean of where its points are, or
   * less than 2.7 if these are at least a quarter as many as those of the floor or there is
   * clearly no step, or they do not meet and both are less than 1.75 from z = 0 of the base
   * frame; or it is tilted by less than 26 degrees and does not differ. */
  bool
  isPart (std::uint32_t plane) const
  {
    return plane < samples_.size() && samples_[plane].is_part;
  }

  /** \brief How far above the floor a plane is that is another level near it: tilted
   * against it by less than 5 degrees, with a step where they meet or at least 2.7 standard
   * deviations of depth above or below, in the weighted mean, no part of it, and not so far
   * that each of its points tells. 0 for all other planes. */
  float
  level (std::uint32_t plane) const
  {
    return plane < samples_.size() ? samples_[plane].level : 0.f;
  }

  /** \brief Whether any plane is a part of the floor or a level near it. */
  bool
  hasPartsOrLevels () const
  {
    return std::any_of (samples_.begin(), samples_.end(), [] (const Samples& s) {
      return s.is_part || s.level != 0.f;
    });
  }

private:
  struct Samples {
    std::size_t points = 0;
    std::size_t off = 0; // above or below the floor
    // Sums of weights, and of weighted heights in the base frame.
    float weight = 0.f, height = 0.f;
    // The same of how far the plane is above z = 0, in standard deviations of depth, and of those
    // of heights.
    float sigmas_in_base = 0.f, height_sigma = 0.f;
    // How far the plane is from z = 0; infinite where it cannot be the floor.
    float off_zero = std::numeric_limits<float>::infinity();
    float tilt = 0.f; // against the z axis of the base frame
    // Weighted sums of how far the plane is above the floor, in metres, then the level, and
    // in standard deviations of depth.
    float level = 0.f, sigmas = 0.f;
    // Where the plane meets the floor in the image: how often that is sampled, and the sum
    // of how much higher it is there, in standard deviations of depth.
    std::size_t borders = 0;
    float step = 0.f;
    float cosine = 1.f; // of the angle with the floor
    bool is_other = false;
    bool is_part = false;
  };

  struct SampledPoint {
    const float* point;
    std::uint32_t plane;
    int u, v;     // in the grid of samples
    float weight; // 1 / range^4: what is near the robot decides
  };

  /** The plane \a floor, or a lower one that is nearer to z = 0. */
  std::size_t
  lowerLevel (std::size_t floor, float max_height) const;

  /** Takes usable points on planes. */
  void
  sample (const OrganizedPoints& points,
          const LabelledPlanes& planes,
          const DepthNoise& noise);

  void
  compare (const LabelledPlanes& planes, const DepthNoise& noise, std::size_t floor);

  /** Compares heights on both sides of the borders between the floor and other planes. */
  void
  addSteps (const DepthNoise& noise, std::size_t floor);

  bool found_ = false;
  Eigen::Vector4f coefficients_ = Eigen::Vector4f::Zero();
  Eigen::Vector4f reference_ = Eigen::Vector4f::Zero();
  std::vector<Samples> samples_;     // one for each plane
  std::vector<SampledPoint> points_; // of the frame at hand
  std::vector<const SampledPoint*> last_in_column_;
};

} // namespace rgbd_planes
} // namespace pcl
