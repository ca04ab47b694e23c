// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/apps/object_evaluation.h>
#include <pcl/apps/object_methods.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of the table: a method at a resolution, pooled over all frames. */
struct ObjectResult {
  std::string method;
  /** "vga", "qvga" or "qqvga": every 1st, 2nd or 4th pixel. */
  std::string resolution;
  std::vector<double> milliseconds;
  ObjectEvaluation evaluation;
};

/** \brief The true objects of a frame of full resolution: those of the simulation, or of the
 * labels of a .pcd file, where label / 10 is 0 for none, 1 for the table and from 2 on an object
 * (as in mOSD). No ids where nothing is known. */
ObjectTruth
objectTruth (const Frame& frame);

/** \brief Scores what was found in every step-th pixel of a frame of full resolution. Adds
 * nothing where nothing is known of the objects.
 * \param[in] truth objectTruth() of the frame
 */
void
scoreObjects (const Frame& frame,
              const ObjectTruth& truth,
              std::uint32_t step,
              const std::vector<FoundObject>& found,
              ObjectEvaluation& evaluation);

/** \brief {"objects_percent", "false_objects", ...}; shares are in percent, null where there is
 * nothing to share. */
nlohmann::ordered_json
objectFigures (const ObjectEvaluation& evaluation);

/** \brief Runs methods, ours and PCL's LCCP, on frames and scores the objects that they find. */
class ObjectComparison {
public:
  /** \param[in] steps resolutions: every step-th pixel, of 1, 2 and 4
   * \param[in] noise that ours expects */
  explicit ObjectComparison (const std::vector<std::uint32_t>& steps,
                             const DepthNoise& noise = DepthNoise::kinectV1());

  /** \brief Adds a frame of full resolution; one without truth is left out. */
  void
  add (const Frame& frame);

  const std::vector<ObjectResult>&
  results () const
  {
    return results_;
  }

  /** \brief The table for people. */
  std::string
  table () const;

  /** \brief An object for each row: {"method", "resolution", "ms_median"} and
   * objectFigures(). */
  nlohmann::ordered_json
  rows () const;

private:
  struct Run {
    std::uint32_t step;
    ObjectMethod method;
    std::size_t points; // of the frame before
    std::vector<FoundObject> found;
  };

  std::vector<Run> runs_;
  std::vector<ObjectResult> results_; // one for each run
};

} // namespace rgbd_planes
} // namespace pcl
