// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <limits>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether a parameter may be 0. */
enum class Zero { allowed, refused };

/** \brief The \c max of setParameter() that refuses infinity only. */
constexpr double any_finite = std::numeric_limits<float>::max();

/** \brief Whether setParameter() takes \a value. */
PCL_RGBD_PLANES_EXPORTS bool
isParameter (double value, Zero zero, double max);

/** \brief The error message of setParameter(). */
PCL_RGBD_PLANES_EXPORTS void
refuseParameter (
    const std::string& setter, double value, double kept, Zero zero, double max);

/** \brief What setters of numbers do: \a parameter becomes \a value. One that is NaN,
 * negative, a 0 that is refused or more than \a max: an error message with the name of the
 * setter, and the one before stays: a 0 that is refused is a default that goes with the input.
 * \return whether \a parameter has become \a value
 */
template <typename T>
bool
setParameter (const std::string& setter,
              double value,
              T& parameter,
              Zero zero = Zero::allowed,
              double max = std::numeric_limits<double>::infinity())
{
  const bool is_parameter = isParameter (value, zero, max);
  if (is_parameter)
    parameter = static_cast<T> (value);
  else
    refuseParameter (setter, value, static_cast<double> (parameter), zero, max);
  return is_parameter;
}

} // namespace rgbd_planes
} // namespace pcl
