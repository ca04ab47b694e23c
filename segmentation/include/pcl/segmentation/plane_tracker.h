// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {

/** \brief Identities of planes over a sequence of frames: a plane keeps its number as long as it
 * is in view.
 *
 * \code
 * pcl::PlaneTracker tracker;
 * // for each frame:
 * segmentation.segment (models, inliers, labels);
 * tracker.track (models, labels, ids); // ids[i] is the identity of models[i]
 * \endcode
 *
 * The motion of the camera need not be known, but must be small from frame to frame: planes must
 * cover some of the pixels that they did before, those with parallel ones beside them half. A
 * plane is the one before that covered most of the same pixels, weighted by how little normal
 * and distance have changed; more than 0.5 radians or 1 m is another plane. While the camera
 * stays, so that a quarter of the pixels of planes with such a normal show the distance they
 * had, 3 cm halve the weight: what stood before a wall that stays, and is taken away, is not the
 * wall. A plane that is not found, or hidden, or taken for a part of another one, is remembered
 * where it was seen last, for 15 frames. When a plane falls into parts, the part with the
 * largest overlap keeps the identity; when planes are joined, the one with the largest overlap
 * does.
 *
 * Time is linear in the number of pixels (and in the product of the numbers of planes of two
 * frames). Memory is used again. Frames may change their size. A new tracker starts anew: assign
 * one for another recording. Not in the paper.
 *
 * \ingroup segmentation
 */
class PCL_RGBD_PLANES_EXPORTS PlaneTracker {
public:
  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~PlaneTracker() = default;

  /** \brief Takes the next frame.
   * \param[in] model_coefficients a, b, c, d of each plane in the camera frame, metres; of any
   * length and sign
   * \param[in] labels the plane of each pixel, organized as the frame; numbers beyond the
   * planes are pixels without one
   * \param[out] ids the identity of each plane, counted from 0 and never used for another one;
   * replaced. Empty after an error message where a plane does not have 4 coefficients, where
   * there are planes but no labels, or labels are not width x height; the tracker then forgets
   * nothing.
   */
  void
  track (const std::vector<ModelCoefficients>& model_coefficients,
         const PointCloud<Label>& labels,
         std::vector<std::uint32_t>& ids);

private:
  /** A plane that was seen in the last frames. Tracks keep their place in the list, which is
   * given to another one once no pixel refers to it. */
  struct Track {
    Eigen::Vector4f plane = Eigen::Vector4f::Zero();
    std::uint32_t id = 0;
    /** Frames since it was seen. */
    unsigned missed = 0;
  };

  static constexpr auto none = std::numeric_limits<std::uint32_t>::max();

  struct Pixel {
    /** What was seen here last. */
    std::uint32_t track = none;
    /** What was seen before that: it may be hidden, or part of the other one for a while. */
    std::uint32_t former = none;
  };

  struct Match {
    float score; // pixels, then weighted
    std::uint32_t track;
    std::uint32_t plane;
    float turn = 0.f, shift = 0.f;
  };

  /** \brief Scales pixels_ to the size of a frame. */
  void
  fit (std::uint32_t width, std::uint32_t height);

  /** \brief Whether there is such a track, but not in the last frame. */
  bool
  isMissing (std::uint32_t track) const;

  void
  countOverlaps (const PointCloud<Label>& labels);

  void
  match ();

  /** \brief How far planes have moved that face as \a plane does and cover the quarter of the
   * pixels of such planes that moved least. */
  float
  leastShift (const Eigen::Vector4f& plane) const;

  std::uint32_t
  addTrack ();

  void
  remember (const PointCloud<Label>& labels);

  std::vector<Track, Eigen::aligned_allocator<Track>> tracks_;
  std::uint32_t next_id_ = 0;
  std::vector<Pixel> pixels_, scaled_; // row by row
  std::uint32_t width_ = 0, height_ = 0;

  // Of this frame:
  std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> planes_;
  std::vector<std::uint32_t> track_of_plane_;
  /** Pixels that track t and plane p share at [t * number of planes + p]. */
  std::vector<std::uint32_t> overlaps_;
  std::vector<Match> matches_;
  std::vector<float> halves_; // for each plane, the shift that halves the weight
};

} // namespace pcl
