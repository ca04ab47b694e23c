// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/obstacle_clusters.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds small clusters that are bumps of the floor, by noise that pixels share or by warp.
 *
 * Bumps are low, and pass into the floor behind them without a step; what stands on a floor hides a
 * part of it, and ends at a step. A pixel without depth may be one.
 */
class PCL_RGBD_PLANES_EXPORTS FloorBumps {
public:
  /** \brief Clusters with fewer points may be bumps. */
  static std::size_t
  maxPoints (const OrganizedPoints& points)
  {
    return points.size() / 700;
  }

  /** \param[in] floor a, b, c, d with a unit normal
   * \param[in] classes one for each point
   */
  void
  find (const OrganizedPoints& points,
        const Eigen::Vector4f& floor,
        const DepthNoise& noise,
        const ObstacleClusters& clusters,
        const std::vector<ObstacleClass>& classes);

  /** \brief For each cluster, whether it is a bump. */
  const std::vector<bool>&
  areBumps () const
  {
    return are_bumps_;
  }

private:
  bool
  isLow (std::size_t cluster) const;

  bool
  endsWithoutStep (std::size_t cluster);

  bool
  hasStep (std::uint32_t i, std::uint32_t end, std::ptrdiff_t up);

  template <typename Use>
  void
  forEachRun (std::size_t cluster, const Use& use) const;

  float
  heightInSigmas (std::uint32_t i) const;

  OrganizedPoints points_;
  Eigen::Vector4f floor_ = Eigen::Vector4f::Zero();
  DepthNoise noise_;
  const std::vector<ObstacleClusters::Run>* runs_ = nullptr;
  std::vector<std::size_t> last_run_, run_before_; // of each cluster, and of each run
  std::vector<float> heights_;
  std::vector<std::uint32_t> first_, last_; // pixels of a cluster in its lines
  std::vector<bool> are_bumps_;
};

} // namespace rgbd_planes
} // namespace pcl
