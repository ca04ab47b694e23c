// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>

#include <limits>
#include <sstream>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether a parameter may be 0. */
enum class Zero { allowed, refused };

/** \brief The \c max of setParameter() that refuses infinity only. */
constexpr double any_finite = std::numeric_limits<float>::max();

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
  // As floats: what was one is the limit that it was meant to be.
  const auto number = static_cast<float> (value);
  const bool may_be_zero = zero == Zero::allowed;
  if ((may_be_zero ? value >= 0. : number > 0.f) &&
      number <= static_cast<float> (max)) {
    parameter = static_cast<T> (value);
    return true;
  }
  std::ostringstream limit, kept;
  if (max < any_finite)
    limit << " and at most " << max;
  if (may_be_zero || parameter > T (0))
    kept << parameter;
  else
    kept << "the default, which goes with the input";
  PCL_ERROR ("[pcl::%s] The value must be a number, %s 0%s, got %g. Keeping %s.\n",
             setter.c_str(),
             may_be_zero ? "at least" : "more than",
             limit.str().c_str(),
             value,
             kept.str().c_str());
  return false;
}

} // namespace rgbd_planes
} // namespace pcl
