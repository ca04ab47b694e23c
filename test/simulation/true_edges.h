// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

/** \brief Edges are the pixels within 5 of one with another label in \a surfaces. */
template <typename PointT>
void
expectEdgesBetween (const pcl::PointCloud<PointT>& surfaces,
                    const pcl::PointCloud<pcl::rgbd_planes::TruthPoint>& truth)
{
  constexpr int px = 5;
  for (int v = px; v + px < 480; v += 3)
    for (int u = px; u + px < 640; u += 3) {
      bool expected = false;
      for (int y = v - px; y <= v + px; ++y)
        for (int x = u - px; x <= u + px; ++x)
          expected |= surfaces (x, y).label != surfaces (u, v).label;
      ASSERT_EQ (truth (u, v).edge, expected ? 1u : 0u) << u << " " << v;
    }
}
