// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/pcd_file.h>
#include <pcl/apps/quiet_pcl.h>
#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

AppError
damaged (const std::string& file)
{
  return AppError (file +
                   ": the PCD file is incomplete or damaged; copy or record it again");
}

/** All of a file at once: it may change while it is looked at. */
std::string
readBytes (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  stream.peek(); // which folders do not let
  if (!stream.is_open() || stream.bad())
    throw cannotOpen (file);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

/** The lines up to DATA; PCDReader would read on. */
std::string
headerLines (const std::string& bytes)
{
  const std::size_t data =
      bytes.compare (0, 4, "DATA") == 0 ? 0 : bytes.find ("\nDATA");
  const std::size_t end =
      bytes.find ('\n', data == std::string::npos ? data : data + 1);
  return bytes.substr (0, end == std::string::npos ? end : end + 1);
}

/** How many bytes PCDReader takes for the points that a header speaks of. */
double
declaredBytes (const std::string& header)
{
  std::istringstream lines (header);
  double fields = 0., points = 0.;
  std::vector<double> sizes, counts;
  bool has_fields = false;
  for (std::string line, key; std::getline (lines, line);) {
    std::istringstream words (line);
    words >> key;
    const auto startsWith = [&] (const char* start) {
      return key.rfind (start, 0) == 0;
    };
    if (startsWith ("FIELDS") || startsWith ("COLUMNS")) {
      if (has_fields) // PCDReader takes sizes of the first ones for those of the others
        return std::numeric_limits<double>::infinity();
      has_fields = true;
      for (std::string name; words >> name;)
        fields += 1.;
    }
    for (std::string word; words >> word;) {
      char* rest = nullptr;
      double number = std::strtod (word.c_str(), &rest); // infinite if too large
      const bool goes_on = rest != word.c_str() && *rest != '\0'; // 0-11 is two numbers
      if (number < 0. || goes_on)                                 // read without a sign
        number = 4294967296.;
      if (std::isnan (number)) // a word, which is read as 0
        continue;
      if (startsWith ("SIZE"))
        sizes.push_back (number);
      else if (startsWith ("COUNT"))
        counts.push_back (std::max (number, 1.));
      else if (startsWith ("POINTS"))
        points = std::max (points, number);
    }
  }
  const auto speaksOfFields = [&] (const std::vector<double>& numbers) {
    return static_cast<double> (numbers.size()) == fields;
  };
  if (speaksOfFields (sizes) && speaksOfFields (counts))
    return points * std::inner_product (sizes.begin(), sizes.end(), counts.begin(), 0.);
  // Fields are floats, one value each, until a line of the header says otherwise.
  sizes.push_back (sizeof (float));
  const double values = std::accumulate (counts.begin(), counts.end(), 0.);
  return points * *std::max_element (sizes.begin(), sizes.end()) *
         std::max (fields, values);
}

PcdFile
readHeader (const std::string& bytes, const std::string& file)
{
  PcdFile header;
  const std::string lines = headerLines (bytes);
  // Each byte of compressed data stands for 88 at most.
  if (!(declaredBytes (lines) <= 100. * static_cast<double> (bytes.size())))
    throw damaged (file);
  std::istringstream stream (lines);
  int result = -1;
  try {
    result = pcl::PCDReader().readHeader (stream,
                                          header.cloud,
                                          header.origin,
                                          header.orientation,
                                          header.version,
                                          header.data_type,
                                          header.data_begin);
  }
  catch (const std::exception&) {
    // Words that are no numbers, numbers of no sense: the same to the user.
  }
  if (result < 0 || header.data_begin == 0 || header.data_begin > bytes.size() ||
      header.cloud.fields.empty())
    throw AppError (file +
                    ": not a PCD file, or its header is damaged; give a .pcd file");
  return header;
}

/** Whether the values of each field lie inside of their point. */
bool
fieldsFit (const pcl::PCLPointCloud2& cloud)
{
  return std::all_of (
      cloud.fields.begin(), cloud.fields.end(), [&] (const auto& field) {
        const auto size =
            static_cast<std::uint64_t> (pcl::getFieldSize (field.datatype));
        return size > 0 && field.offset + size * field.count <= cloud.point_step;
      });
}

/** PCDReader trusts the sizes in the header, and those in front of compressed data. */
bool
isComplete (const std::string& bytes, const PcdFile& header)
{
  const auto& cloud = header.cloud;
  if (!fieldsFit (cloud) ||
      cloud.data.size() != std::uint64_t{cloud.width} * cloud.height * cloud.point_step)
    return false;
  const std::size_t body = bytes.size() - header.data_begin;
  if (header.data_type != 2)
    return header.data_type == 0 || body >= cloud.data.size();
  std::uint32_t sizes[2];
  if (body < sizeof (sizes))
    return false;
  std::memcpy (sizes, bytes.data() + header.data_begin, sizeof (sizes));
  return sizeof (sizes) + sizes[0] <= body && sizes[1] == cloud.data.size();
}

void
checkHeader (const pcl::PCLPointCloud2& cloud,
             const std::vector<std::string>& floats,
             const std::string& file)
{
  for (const auto& name : floats) {
    const auto* field = findField (cloud, name);
    if (!field)
      throw AppError (file + ": the cloud has no field '" + name +
                      "'; give a cloud that has one");
    if (field->datatype != pcl::PCLPointField::FLOAT32)
      throw AppError (file + ": the field '" + name +
                      "' is no 32-bit float; write it as one (TYPE F, SIZE 4)");
  }
  if (cloud.height < 2 || cloud.width < 2)
    throw AppError (file + ": the cloud is unorganized (" +
                    std::to_string (cloud.width) + " x " +
                    std::to_string (cloud.height) +
                    "); record organized clouds (an image of points, missing ones as "
                    "NaN), or give the depth image");
}

/** Whether each line of \a text has a number for each value of a point. PCDReader takes 0 for
 * those that are missing. */
bool
isTable (const std::string& text, const pcl::PCLPointCloud2& cloud)
{
  const auto values = std::accumulate (
      cloud.fields.begin(),
      cloud.fields.end(),
      std::size_t{0},
      [] (std::size_t sum, const auto& field) { return sum + field.count; });
  const char spaces[] = " \t\r";
  std::istringstream lines (text);
  for (std::string line; std::getline (lines, line);) {
    std::size_t count = 0;
    const char* next = line.c_str() + std::strspn (line.c_str(), spaces);
    for (; *next != '\0'; ++count) {
      char* end = nullptr;
      std::strtod (next, &end);
      const std::size_t gap = std::strspn (end, spaces);
      if (end == next || (gap == 0 && *end != '\0'))
        return false;
      next = end + gap;
    }
    if (count != 0 && count != values)
      return false;
  }
  return true;
}

/** Fills in the data; false where it is damaged. */
bool
readBody (const std::string& bytes, PcdFile& header)
{
  pcl::PCDReader reader;
  try {
    if (header.data_type != 0)
      return reader.readBodyBinary (
                 reinterpret_cast<const unsigned char*> (bytes.data()),
                 header.cloud,
                 header.version,
                 header.data_type == 2,
                 header.data_begin) == 0;
    const std::string text = bytes.substr (header.data_begin);
    std::istringstream stream (text);
    return isTable (text, header.cloud) &&
           reader.readBodyASCII (stream, header.cloud, header.version) == 0;
  }
  catch (const std::exception&) {
    return false;
  }
}

} // namespace

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& blob, const std::string& name)
{
  for (const auto& field : blob.fields)
    if (field.name == name && field.offset + sizeof (float) <= blob.point_step)
      return &field;
  return nullptr;
}

PcdFile
readPcdFile (const std::string& file, const std::vector<std::string>& floats)
{
  const QuietPcl quiet; // what is wrong with a file is said once, by the exception
  const std::string bytes = readBytes (file);
  PcdFile header = readHeader (bytes, file);
  checkHeader (header.cloud, floats, file);
  if (!isComplete (bytes, header) || !readBody (bytes, header))
    throw damaged (file);
  return header;
}

} // namespace rgbd_planes
} // namespace pcl
