// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// The reader of organized PCD files, and of the labels in them.

#include "scratch_file.h"

#include <pcl/apps/organized_pcd.h>

#include <cmath>

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* bytes, std::size_t size)
{
  fuzz::mayBeRefused ([&] {
    const fuzz::ScratchFile file (bytes, size);
    pcl::rgbd_planes::PointLabels labels;
    const auto cloud = pcl::rgbd_planes::readOrganizedPcd (file.path(), &labels);
    if (!cloud->isOrganized() || cloud->size() != cloud->width * cloud->height ||
        (!labels.points.empty() && labels.points.size() != cloud->size()))
      std::abort();
    for (const auto& p : *cloud)
      if (std::isfinite (p.x) != std::isfinite (p.z) || std::isinf (p.y))
        std::abort();
  });
  fuzz::mayBeRefused ([&] {
    const fuzz::ScratchFile file (bytes, size);
    const auto image = pcl::rgbd_planes::readIntensityPcd (file.path());
    if (!image.isOrganized() || image.size() != image.width * image.height)
      std::abort();
  });
  return 0;
}
