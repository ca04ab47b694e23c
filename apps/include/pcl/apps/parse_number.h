// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/app_error.h>

#include <charconv>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief The number that \a text is, in whole and in any locale; AppError, which
 * starts with \a what, if it is none or does not fit. */
template <typename Number>
Number
parseNumber (const std::string& what, const std::string& text)
{
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars (text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end)
    throw AppError (what + " is '" + text + "', which is no number it can be");
  return number;
}

} // namespace rgbd_planes
} // namespace pcl
