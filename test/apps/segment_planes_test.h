// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "app_test.h"

#include <cstdint>
#include <string>
#include <vector>

/** A test that runs pcl_segment_planes. */
class SegmentPlanesTest : public AppTest {
protected:
  SegmentPlanesTest() : AppTest (SEGMENT_PLANES) {}

  /** A depth image of 160 x 120, 1 mm units: a wall at 1 m left, one at 1.5 m right,
   * the four top rows missing. */
  void
  writeTwoWalls (const std::string& name) const
  {
    std::vector<std::uint16_t> depth (160 * 120);
    for (std::size_t i = 4 * 160; i < depth.size(); ++i)
      depth[i] = i % 160 < 80 ? 1000 : 1500;
    writePng (folder_ / name, 160, depth);
  }

  const std::string camera_ = " --intrinsics 131,131,79.5,59.5 --depth-scale 1000 ";
};
