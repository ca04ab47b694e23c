// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>

#include <pcl/apps/progress.h>

#include <iostream>

namespace pcl {
namespace rgbd_planes {

void
showProgress (std::size_t done, std::size_t all)
{
  if (all > 1 && ::isatty (STDERR_FILENO))
    std::cerr << "\rframe " << done << " of " << all << (done == all ? "\n" : "")
              << std::flush;
}

} // namespace rgbd_planes
} // namespace pcl
