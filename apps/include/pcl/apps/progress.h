// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A line on stderr that says how far the work is, where that is a terminal and
 * there are several frames. */
class Progress {
public:
  explicit Progress (std::size_t all);
  Progress (const Progress&) = delete;
  Progress&
  operator= (const Progress&) = delete;
  ~Progress();

  /** \brief Says that \a frame, counted from 1, is being worked on. */
  void
  show (std::size_t frame) const;

private:
  std::size_t all_;
  bool shown_;
};

/** \brief Shows all frames to \a body with Progress, until the user interrupts. */
void
forEachFrame (const std::vector<FrameSource>& sources,
              const std::function<void (const Frame&)>& body);

} // namespace rgbd_planes
} // namespace pcl
