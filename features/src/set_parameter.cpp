// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/impl/set_parameter.h>

#include <limits>
#include <sstream>

namespace pcl {
namespace rgbd_planes {

bool
isParameter (double value, Zero zero, double max)
{
  // As floats: what was one is the limit that it was meant to be.
  const auto number = static_cast<float> (value);
  return (zero == Zero::allowed ? value >= 0. : number > 0.f) &&
         number <= static_cast<float> (max);
}

void
refuseParameter (
    const std::string& setter, double value, double kept, Zero zero, double max)
{
  const bool may_be_zero = zero == Zero::allowed;
  std::ostringstream limit, keeping;
  if (max < any_finite)
    limit << " and at most " << max;
  if (may_be_zero || kept > 0.)
    keeping << kept;
  else
    keeping << "the default, which goes with the input";
  PCL_ERROR ("[pcl::%s] The value must be a %s, %s 0%s, got %g. Keeping %s.\n",
             setter.c_str(),
             max < std::numeric_limits<double>::infinity() ? "finite number" : "number",
             may_be_zero ? "at least" : "more than",
             limit.str().c_str(),
             value,
             keeping.str().c_str());
}

} // namespace rgbd_planes
} // namespace pcl
