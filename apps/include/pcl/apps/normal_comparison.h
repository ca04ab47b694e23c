// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/apps/normal_evaluation.h>
#include <pcl/apps/normal_methods.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of the table: a method at a resolution against a reference. */
struct NormalResult {
  std::string method;
  /** "vga", "qvga" or "qqvga": every 1st, 2nd or 4th pixel. */
  std::string resolution;
  /** "truth" or "two_run_pca". */
  std::string reference;
  /** For each frame, the fastest of up to three runs. */
  std::vector<double> milliseconds;
  NormalDeviations all;
  /** Of pixels within 5 px (of the full image) of a depth edge or crease, and of the
   * others; without true normals, nothing is known of them. */
  NormalDeviations edges;
  NormalDeviations interior;
  /** Of "tangent" at the points to which this method gives a normal: the figures to
   * compare those of a method with that leaves points out. */
  NormalDeviations tangent_there;
  NormalDeviations tangent_there_edges;
};

/** \brief Runs all methods on frames and pools how far their normals are from the
 * reference: true normals where the frame has them, else two-run principal component
 * analysis of the full image.
 *
 * Only measured points count. Two-run principal component analysis itself is one of the
 * methods where there are true normals.
 */
class NormalComparison {
public:
  /** \param[in] steps resolutions: every step-th pixel, of 1, 2 and 4
   * \param[in] radius of two-run principal component analysis */
  NormalComparison (const std::vector<std::uint32_t>& steps,
                    const RadiusFunction& radius);

  /** \brief Adds a frame of full resolution. AppError where it is too small. */
  void
  add (const Frame& frame);

  const std::vector<NormalResult>&
  results () const
  {
    return results_;
  }

private:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using Normals = pcl::PointCloud<pcl::Normal>;

  struct Runner {
    NormalMethod method;
    Normals normals;
  };

  struct Resolution {
    std::uint32_t step;
    std::vector<Runner> runners;
  };

  /** A frame at one resolution; \a is_edge is empty without true normals. */
  struct Task {
    Cloud::Ptr cloud;
    Normals reference;
    std::vector<bool> is_edge;
  };

  Task
  makeTask (const Frame& frame);

  static Task
  subsampleTask (const Frame& frame, const Task& task, std::uint32_t step);

  void
  run (Resolution& resolution, const Task& task);

  NormalResult&
  resultOf (const std::string& method, std::uint32_t step, bool has_truth);

  NormalMethod reference_;
  std::vector<Resolution> resolutions_;
  std::vector<NormalResult> results_;
};

} // namespace rgbd_planes
} // namespace pcl
