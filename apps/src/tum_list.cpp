// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/parse_number.h>
#include <pcl/apps/tum_list.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Since 1970; in smaller units, times are later. */
constexpr double latest_seconds = 1e11;

double
parseTime (const std::string& place, const std::string& text)
{
  const auto seconds = parseNumber<double> (place + ": the timestamp", text);
  if (!(std::abs (seconds) < latest_seconds))
    throw AppError (place + ": the timestamp '" + text + "' must be seconds");
  return seconds;
}

} // namespace

TumList
readTumList (const std::filesystem::path& list)
{
  TumList result;
  std::ifstream stream (list);
  if (!stream)
    throw cannotOpen (list.string());
  std::string line, timestamp, file;
  for (int number = 1; std::getline (stream, line); ++number) {
    std::istringstream words (line);
    if (!(words >> timestamp))
      continue;
    const std::string place = list.string() + ": line " + std::to_string (number);
    if (timestamp[0] == '#')
      result.freiburg3 =
          result.freiburg3 || line.find ("freiburg3") != std::string::npos;
    else if (words >> file)
      result.images.emplace_back (parseTime (place, timestamp),
                                  list.parent_path() / file);
    else
      throw AppError (place + " is not 'timestamp filename'");
  }
  if (result.images.empty())
    throw AppError (list.string() + ": lists no depth image");
  return result;
}

std::vector<std::filesystem::path>
otherTumFiles (const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const char* name : {"rgb.txt", "accelerometer.txt", "groundtruth.txt"})
    if (std::filesystem::exists (folder / name))
      files.push_back (folder / name);
  std::ifstream list (folder / "rgb.txt");
  std::string line, timestamp, image;
  while (std::getline (list, line))
    if (std::istringstream (line) >> timestamp >> image && timestamp[0] != '#')
      files.push_back (folder / image);
  return files;
}

} // namespace rgbd_planes
} // namespace pcl
