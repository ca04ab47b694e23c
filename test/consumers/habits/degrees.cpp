// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/normal_space_plane_segmentation.h>

void
setDegrees (pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>& segmentation)
{
  segmentation.setAngularThreshold (pcl::deg2rad (3.0));
}
