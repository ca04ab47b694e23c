// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>

#include <pcl/apps/progress.h>

#include <iostream>

namespace pcl {
namespace rgbd_planes {

Progress::Progress (std::size_t all)
: all_ (all)
, shown_ (all > 1 && ::isatty (STDERR_FILENO))
{}

Progress::~Progress()
{
  if (shown_)
    std::cerr << std::endl;
}

void
Progress::show (std::size_t frame) const
{
  if (shown_)
    std::cerr << "\rframe " << frame << " of " << all_ << std::flush;
}

} // namespace rgbd_planes
} // namespace pcl
