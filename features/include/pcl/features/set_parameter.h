// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>

#include <cmath>
#include <limits>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief What setters of numbers do: \a parameter becomes \a value. One that is NaN or not
 * from 0 to \a max: an error message with the name of the setter, and the one before
 * stays. */
template <typename T>
void
setParameter (const std::string& setter,
              double value,
              T& parameter,
              double max = std::numeric_limits<double>::infinity())
{
  // As floats: what was one is the limit that it was meant to be.
  if (value >= 0. && static_cast<float> (value) <= static_cast<float> (max)) {
    parameter = static_cast<T> (value);
    return;
  }
  const std::string range = std::isinf (max) ? "or more" : "to " + std::to_string (max);
  PCL_ERROR ("[pcl::%s] The value must be 0 %s, got %g. Keeping %g.\n",
             setter.c_str(),
             range.c_str(),
             value,
             static_cast<double> (parameter));
}

} // namespace rgbd_planes
} // namespace pcl
