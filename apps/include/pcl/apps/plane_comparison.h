// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/curved_points.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/object_label_evaluation.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/plane_correction.h>
#include <pcl/apps/plane_evaluation.h>
#include <pcl/apps/plane_methods.h>
#include <pcl/apps/right_angles.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of the table: a method at a resolution, pooled over all frames. */
struct PlaneResult {
  std::string method;
  /** "vga", "qvga" or "qqvga": every 1st, 2nd or 4th pixel. */
  std::string resolution;
  /** For each frame, the fastest of three runs. */
  std::vector<double> milliseconds;
  PlaneEvaluation evaluation;
  ObjectLabelEvaluation object_labels;
  CurvedPoints curved;
  RightAngles right_angles;
  PlaneCorrection correction;
};

/** \brief Runs all methods on frames and scores the planes that they find. True planes
 * count from minPlanePoints() on, and methods drop smaller ones. */
class PlaneComparison {
public:
  /** \param[in] steps resolutions: every step-th pixel, of 1, 2 and 4
   * \param[in] right_angles which pairs of planes of the scenes are at right angles, if any
   */
  PlaneComparison (const std::vector<std::uint32_t>& steps,
                   const std::optional<RightAngles::Pairs>& right_angles,
                   const PlaneMethodOptions& options);

  /** \brief What is to be shown all frames, one after the other, before the first
   * add (). */
  std::vector<std::function<void (const Frame&)>>
  calibration ();

  /** \brief Adds a frame of full resolution. AppError where it is too small. */
  void
  add (const Frame& frame);

  /** \brief Writes the planes that each method found in \a frame, the last one that was
   * added, to FRAME_METHOD_RESOLUTION.png in \a folder. */
  void
  writePictures (const Frame& frame,
                 const std::filesystem::path& folder,
                 OutputFiles& files) const;

  const std::vector<PlaneResult>&
  results () const
  {
    return results_;
  }

private:
  struct Run {
    std::uint32_t step;
    PlaneMethod method;
    FoundPlanes found;
  };

  void
  score (const Frame& frame,
         const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
         const Run& run,
         PlaneResult& result) const;

  std::optional<RightAngles::Pairs> right_angles_;
  std::vector<Run> runs_;
  std::vector<PlaneResult> results_; // one for each run
};

} // namespace rgbd_planes
} // namespace pcl
