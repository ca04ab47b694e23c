// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The median, the upper one of an even number of values; NaN where there are
 * none. */
inline double
median (std::vector<double> values)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

/** \brief NaN where there are no values. */
inline double
mean (const std::vector<double>& values)
{
  return std::accumulate (values.begin(), values.end(), 0.) /
         static_cast<double> (values.size());
}

/** \brief \a part in percent of \a whole; NaN where there is no whole. */
inline double
percentOf (std::size_t part, std::size_t whole)
{
  return 100. * static_cast<double> (part) / static_cast<double> (whole);
}

/** \brief How many of \a values are up to \a limit, in percent; NaN where there are none. */
inline double
percentUpTo (double limit, const std::vector<double>& values)
{
  const auto part = std::count_if (
      values.begin(), values.end(), [limit] (double value) { return value <= limit; });
  return percentOf (static_cast<std::size_t> (part), values.size());
}

/** \brief A number for a table; '-' for NaN. */
inline std::string
numberText (double value, int digits)
{
  if (std::isnan (value))
    return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision (digits) << value;
  return text.str();
}

} // namespace rgbd_planes
} // namespace pcl
