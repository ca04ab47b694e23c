// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_source.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

inline InputOptions
inputOf (const std::filesystem::path& input)
{
  InputOptions options;
  options.input = input;
  return options;
}

inline InputOptions
depthInputOf (const std::filesystem::path& input)
{
  InputOptions options = inputOf (input);
  options.intrinsics = Intrinsics{100.f, 100.f, 0.f, 0.f};
  options.units_per_metre = 1000.f;
  return options;
}

inline std::vector<std::string>
namesOf (const FrameSource& source)
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < source.size(); ++i)
    names.push_back (source.read (i).name);
  return names;
}

inline std::string
messageOf (const InputOptions& options)
{
  try {
    namesOf (FrameSource (options));
  }
  catch (const AppError& error) {
    return error.what();
  }
  return "";
}

inline bool
contains (const std::string& text, const std::string& part)
{
  return text.find (part) != std::string::npos;
}

} // namespace rgbd_planes
} // namespace pcl
