// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "any_settings.h"

#include <pcl/filters/depth_warp_correction.h>
#include <pcl/filters/obstacle_filter.h>
#include <pcl/filters/project_onto_planes.h>

#include <algorithm>
#include <vector>

namespace fuzz {

using Labels = pcl::PointCloud<pcl::Label>;

/** All filters of the library, with settings of any kind. */
class Filters {
public:
  struct Input {
    synthetic::Cloud::ConstPtr cloud;
    pcl::IndicesPtr indices;
    const std::vector<pcl::ModelCoefficients>& planes;
    const std::vector<pcl::PointIndices>& inliers;
    Labels::ConstPtr labels;
    Labels::ConstPtr classes;
  };

  void
  applyAll (FuzzedDataProvider& data, const Input& input)
  {
    obstacle_filter_.setClasses (input.classes);
    obstacle_filter_.setNegative (data.ConsumeBool());
    obstacle_filter_.setKeepOrganized (data.ConsumeBool());
    obstacle_filter_.setUserFilterValue (anyFloat (data));
    apply (obstacle_filter_, input);
    to_base_.setTransform (anyPose (data));
    if (data.ConsumeBool())
      to_base_.estimateFromFloor (input.planes.empty() ? pcl::ModelCoefficients()
                                                       : input.planes.front());
    apply (to_base_, input);
    project (data, input);
    correct (data, input);
  }

private:
  void
  project (FuzzedDataProvider& data, const Input& input)
  {
    using Direction = pcl::ProjectOntoPlanes<PointXYZ>::Direction;
    projection_.setDirection (data.ConsumeBool() ? Direction::normal
                                                 : Direction::viewing_ray);
    projection_.setMaxRayFactor (anyFloat (data));
    if (data.ConsumeBool())
      projection_.setInputPlanes (input.planes, input.inliers);
    else
      projection_.setInputPlanes (input.planes, input.labels);
    apply (projection_, input);
  }

  void
  correct (FuzzedDataProvider& data, const Input& input)
  {
    correction_.setDepthNoise (anyNoise (data));
    if (data.ConsumeBool())
      correction_.clearFrames();
    correction_.setRightAngles (data.ConsumeBool());
    correction_.addFrame (input.cloud, input.planes, input.inliers);
    apply (correction_, input);
    auto warp = correction_.getWarp();
    if (warp.empty() || data.ConsumeBool())
      return;
    warp.front().intensity = anyFloat (data);
    correction_.setWarp (warp);
    apply (correction_, input);
  }

  template <typename Filter>
  static void
  apply (Filter& filter, const Input& input)
  {
    filter.setInputCloud (input.cloud);
    filter.setIndices (input.indices);
    synthetic::Cloud output;
    filter.filter (output);
    const std::size_t most = input.indices ? input.indices->size() : 0;
    expect (output.size() <= (input.cloud ? std::max (input.cloud->size(), most) : 0));
  }

  pcl::ObstacleFilter<PointXYZ> obstacle_filter_;
  pcl::CameraToBase<PointXYZ> to_base_;
  pcl::ProjectOntoPlanes<PointXYZ> projection_;
  pcl::DepthWarpCorrection<PointXYZ> correction_;
};

} // namespace fuzz
