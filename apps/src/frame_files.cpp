// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/frame_files.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <string>

namespace fs = std::filesystem;

namespace pcl {
namespace rgbd_planes {

namespace {

bool
isDigit (char c)
{
  return c >= '0' && c <= '9';
}

/** Compares names with their numbers by value, so that 2.png comes before 10.png. */
bool
naturalLess (const fs::path& path_a, const fs::path& path_b)
{
  const std::string a = path_a.filename(), b = path_b.filename();
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit (a[i]) || !isDigit (b[j])) {
      if (a[i] != b[j])
        return static_cast<unsigned char> (a[i]) < static_cast<unsigned char> (b[j]);
      ++i, ++j;
      continue;
    }
    const auto number = [] (const std::string& text, std::size_t& at) {
      const auto begin = std::min (text.find_first_not_of ('0', at), text.size());
      at = begin;
      while (at < text.size() && isDigit (text[at]))
        ++at;
      return text.substr (begin, at - begin);
    };
    const std::string x = number (a, i), y = number (b, j);
    if (x != y)
      return x.size() != y.size() ? x.size() < y.size() : x < y;
  }
  const std::size_t left_a = a.size() - i, left_b = b.size() - j;
  return left_a != left_b ? left_a < left_b : a < b;
}

/** Whether the file belongs to a frame beside it: NAME_truth, as pcl_simulate_rgbd writes it, or
 * NAME_view, as pcl_plane_viewer does. */
bool
isMadeOfFrame (const fs::path& file)
{
  const std::string path = (file.parent_path() / file.stem()).string();
  for (const std::string ending : {"_truth", "_view"})
    if (boost::ends_with (path, ending)) {
      const std::string frame = path.substr (0, path.size() - ending.size());
      for (const char* extension : {".pcd", ".png", ".PCD", ".PNG"})
        if (fs::exists (frame + extension))
          return true;
    }
  return false;
}

} // namespace

bool
hasExtension (const fs::path& file, const std::string& extension)
{
  return boost::iequals (file.extension().string(), extension);
}

std::vector<fs::path>
listFrames (const fs::path& folder, const std::string& extension)
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator (folder))
    if (hasExtension (entry.path(), extension) && !entry.is_directory() &&
        !boost::starts_with (entry.path().filename().string(), ".") &&
        !isMadeOfFrame (entry.path()))
      files.push_back (entry.path());
  std::sort (files.begin(), files.end(), naturalLess);
  return files;
}

} // namespace rgbd_planes
} // namespace pcl
