// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/object_evaluation.h>
#include <pcl/apps/obstacle_evaluation.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of the table: a resolution, pooled over all frames. */
struct DetectionResult {
  /** "vga", "qvga" or "qqvga": every 1st, 2nd or 4th pixel. */
  std::string resolution;
  /** Of all stages: normals, planes, objects (split at concave edges), obstacles. */
  std::vector<double> milliseconds;
  ObjectEvaluation objects;
  ObstacleEvaluation obstacles;
};

/** \brief Runs all stages on frames and scores what is detected (Holz et al. 2011, figure
 * 6c). Obstacles are scored on simulated frames; objects on these, and on recordings
 * whose points have labels of objects. */
class DetectionComparison {
public:
  /** \param[in] steps resolutions: every step-th pixel, of 1, 2 and 4
   * \param[in] noise of the sensor */
  explicit DetectionComparison (const std::vector<std::uint32_t>& steps,
                                const DepthNoise& noise = DepthNoise::kinectV1());

  /** \brief Adds a frame of full resolution. */
  void
  add (const Frame& frame);

  const std::vector<DetectionResult>&
  results () const
  {
    return results_;
  }

  /** \brief The table for people. */
  std::string
  table () const;

  /** \brief An object for each row: {"resolution", "objects_percent", ...}; null where no
   * frame has the truth that a figure needs. */
  nlohmann::ordered_json
  rows () const;

private:
  struct Run {
    std::uint32_t step = 1;
    std::size_t points = 0; // of the frame before
    DetectionPipeline<pcl::PointXYZ> pipeline;
  };

  std::vector<Run> runs_;
  std::vector<DetectionResult> results_; // one for each run
};

} // namespace rgbd_planes
} // namespace pcl
