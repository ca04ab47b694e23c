// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "any_values.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/filters/camera_to_base.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

/** Settings of the classes of the library, made of the bytes of a fuzzer. */
namespace fuzz {

using pcl::PointXYZ;

/** A pose, now and then none that is rigid. */
inline Eigen::Affine3f
anyPose (FuzzedDataProvider& data)
{
  Eigen::Affine3f pose = pcl::rgbd_planes::defaultCameraToBase();
  const auto turn = data.ConsumeFloatingPointInRange (-3.f, 3.f);
  pose.rotate (Eigen::AngleAxisf (turn, Eigen::Vector3f::UnitX()));
  pose.translation().z() = data.ConsumeFloatingPointInRange (-1.f, 3.f);
  if (data.ConsumeIntegralInRange (0, 9) == 0)
    pose.matrix() (data.ConsumeIntegralInRange (0, 2),
                   data.ConsumeIntegralInRange (0, 3)) = anyFloat (data);
  return pose;
}

inline pcl::rgbd_planes::DepthNoise
anyNoise (FuzzedDataProvider& data)
{
  return {anyFloat (data),
          anyFloat (data),
          anyFloat (data),
          data.ConsumeBool(),
          data.ConsumeFloatingPointInRange (1.f, 5.f)};
}

template <typename PointInT, typename PointOutT>
void
setAny (FuzzedDataProvider& data,
        pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT>& estimation)
{
  using Estimation = pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT>;
  estimation.setNumberOfThreads (data.ConsumeIntegralInRange (0, 3));
  estimation.setDepthDependentSmoothing (data.ConsumeBool());
  estimation.setEdgeAware (data.ConsumeBool());
  estimation.setScaleSelection (data.ConsumeBool());
  estimation.setDepthNoise (anyNoise (data));
  estimation.setBorderPolicy (data.ConsumeBool() ? Estimation::BORDER_POLICY_IGNORE
                                                 : Estimation::BORDER_POLICY_MIRROR);
  switch (data.ConsumeIntegralInRange (0, 4)) {
  case 0:
    return estimation.setNormalSmoothingSize (anyFloat (data));
  case 1:
    return estimation.setRectSize (data.ConsumeIntegral<int>(),
                                   data.ConsumeIntegralInRange (-1, 20));
  case 2:
    return estimation.setMaxDepthChangeFactor (anyFloat (data));
  case 3:
    return estimation.setViewPoint (anyFloat (data), anyFloat (data), anyFloat (data));
  default:
    return estimation.useSensorOriginAsViewPoint();
  }
}

inline void
setAny (FuzzedDataProvider& data,
        pcl::TwoRunNormalEstimation<PointXYZ, pcl::Normal>& estimation)
{
  estimation.setNumberOfThreads (data.ConsumeIntegralInRange (0, 3));
  estimation.setRadius (anyFloat (data), anyFloat (data), anyFloat (data));
  estimation.setWindowSize (data.ConsumeIntegralInRange (-1, 70));
  estimation.setViewPoint (anyFloat (data), anyFloat (data), anyFloat (data));
  const bool has_surface = data.ConsumeIntegralInRange (0, 3) == 0;
  estimation.setSearchSurface (has_surface ? anyCloud (data) : nullptr);
}

inline void
setAny (FuzzedDataProvider& data,
        pcl::NormalSpacePlaneSegmentation<PointXYZ, pcl::Normal>& segmentation)
{
  using Grid = pcl::rgbd_planes::NormalSpaceGrid;
  segmentation.setMinInliers (data.ConsumeIntegralInRange (0, 300));
  segmentation.setAngularThreshold (anyFloat (data));
  segmentation.setDistanceThreshold (anyFloat (data));
  segmentation.setMaximumCurvature (anyFloat (data));
  segmentation.setMaximumPointCurvature (anyFloat (data));
  segmentation.setMinimumNearNormals (anyFloat (data));
  segmentation.setDepthNoise (anyNoise (data));
  segmentation.setMinimumCellShare (anyFloat (data));
  segmentation.setNormalSpaceGrid (data.ConsumeBool() ? Grid::voxels : Grid::spherical);
  segmentation.setProjectPoints (data.ConsumeBool());
}

inline void
setAny (FuzzedDataProvider& data,
        pcl::SupportedObjectExtraction<PointXYZ, pcl::Normal>& extraction)
{
  extraction.setCameraToBase (anyPose (data));
  extraction.setHorizontalTolerance (anyFloat (data));
  extraction.setPlaneHeights (anyFloat (data), anyFloat (data));
  extraction.setMaxObjectHeight (anyFloat (data));
  extraction.setMinObjectHeight (anyFloat (data));
  extraction.setHullTolerance (anyFloat (data));
  extraction.setMaxOverhang (anyFloat (data));
  extraction.setClusterTolerance (anyFloat (data));
  extraction.setDepthNoise (anyNoise (data));
  extraction.setMinPoints (data.ConsumeIntegralInRange (0, 60));
  extraction.setGraspableSides (anyFloat (data), anyFloat (data));
  extraction.setSplitAtConcaveEdges (data.ConsumeBool());
}

inline void
setAny (FuzzedDataProvider& data,
        pcl::ObstacleDetection<PointXYZ, pcl::Normal>& detection)
{
  detection.setCameraToBase (anyPose (data));
  detection.setFloorTolerances (anyFloat (data), anyFloat (data));
  detection.setMinObstacleHeight (anyFloat (data));
  detection.setMinDropDepth (anyFloat (data));
  detection.setMinClusterSize (data.ConsumeIntegralInRange (0, 20));
  detection.setDepthNoise (anyNoise (data));
  detection.setScanLimits ({anyFloat (data),
                            anyFloat (data),
                            anyFloat (data),
                            anyFloat (data),
                            anyFloat (data),
                            anyFloat (data)});
}

} // namespace fuzz
