// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>

#include <pcl/apps/interruption.h>
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

void
forEachFrame (const std::vector<FrameSource>& sources,
              const std::function<void (const Frame&)>& body)
{
  std::size_t all = 0, frame = 0;
  for (const auto& source : sources)
    all += source.size();
  const Progress progress (all);
  for (const auto& source : sources)
    for (std::size_t i = 0; i < source.size(); ++i) {
      progress.show (++frame);
      body (source.read (i));
      stopIfInterrupted();
    }
}

} // namespace rgbd_planes
} // namespace pcl
