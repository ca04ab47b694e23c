// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>

namespace pcl {
namespace rgbd_planes {

/** \brief PCL prints no messages while one of these is there. */
class QuietPcl {
public:
  QuietPcl() { pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); }
  QuietPcl (const QuietPcl&) = delete;
  QuietPcl&
  operator= (const QuietPcl&) = delete;
  ~QuietPcl() { pcl::console::setVerbosityLevel (level_); }

private:
  pcl::console::VERBOSITY_LEVEL level_ = pcl::console::getVerbosityLevel();
};

} // namespace rgbd_planes
} // namespace pcl
