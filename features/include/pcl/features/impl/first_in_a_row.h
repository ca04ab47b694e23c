// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <utility>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether something \a is_so that was not so in the frame before: all frames of a camera
 * are alike, and a warning for each would fill the log.
 * \param[in,out] was_so whether it was so in the frame before; then, whether it is
 */
inline bool
isFirstInARow (bool is_so, bool& was_so)
{
  return !std::exchange (was_so, is_so) && is_so;
}

} // namespace rgbd_planes
} // namespace pcl
