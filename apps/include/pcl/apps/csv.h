// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <boost/format.hpp>
#include <Eigen/Core>

#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief A field of a CSV file (RFC 4180). */
inline std::string
csvText (const std::string& text)
{
  if (text.find_first_of (",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? "\"\"" : std::string (1, c);
  return result + '"';
}

/** \brief Three fields of a CSV file, with a comma before each. */
inline std::string
csvFields (const Eigen::Vector3f& vector)
{
  return (boost::format (",%.6g,%.6g,%.6g") % vector.x() % vector.y() % vector.z())
      .str();
}

} // namespace rgbd_planes
} // namespace pcl
