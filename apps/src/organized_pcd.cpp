// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/apps/point_labels.h>
#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/features/organized_view.h>
#include <pcl/io/pcd_io.h>
#include <pcl/PCLPointCloud2.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Silences PCL's own messages: what is wrong with a file is said once, by the
 * exception. */
class QuietPcl {
public:
  QuietPcl() { pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); }
  QuietPcl (const QuietPcl&) = delete;
  QuietPcl&
  operator= (const QuietPcl&) = delete;
  ~QuietPcl() { pcl::console::setVerbosityLevel (level_); }

private:
  pcl::console::VERBOSITY_LEVEL level_ = pcl::console::getVerbosityLevel();
};

AppError
damaged (const std::string& file)
{
  return AppError (file +
                   ": the PCD file is incomplete or damaged; copy or record it again");
}

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& blob, const std::string& name)
{
  for (const auto& field : blob.fields)
    if (field.name == name && field.offset + sizeof (float) <= blob.point_step)
      return &field;
  return nullptr;
}

/** All of a file at once: it may change while it is looked at. */
std::string
readBytes (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  stream.peek(); // which folders do not let
  if (!stream.is_open() || stream.bad())
    throw AppError (file + ": cannot open this file: " + std::strerror (errno));
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
  // Fields are floats, one value each, until the header says otherwise.
  double largest = sizeof (float), fields = 0., values = 0., points = 0.;
  for (std::string line, key; std::getline (lines, line);) {
    std::istringstream words (line);
    words >> key;
    const auto startsWith = [&] (const char* start) {
      return key.rfind (start, 0) == 0;
    };
    if (startsWith ("FIELDS") || startsWith ("COLUMNS"))
      for (std::string name; words >> name;)
        fields += 1.;
    for (std::string word; words >> word;) {
      double number = std::strtod (word.c_str(), nullptr); // infinite if too large
      if (number < 0.)                                     // read without a sign
        number = 4294967296.;
      if (std::isnan (number)) // a word, which is read as 0
        continue;
      if (startsWith ("SIZE"))
        largest = std::max (largest, number);
      else if (startsWith ("COUNT"))
        values += number;
      else if (startsWith ("POINTS"))
        points = std::max (points, number);
    }
  }
  return points * largest * std::max (fields, values);
}

struct Header {
  /** Its data is as large as that of the file, but not read. */
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  int data_type = 0; /**< 0 is text, 1 binary, 2 compressed */
  unsigned data_begin = 0;
};

Header
readHeader (const std::string& bytes, const std::string& file)
{
  Header header;
  const std::string lines = headerLines (bytes);
  // Each byte of compressed data stands for 88 at most.
  if (declaredBytes (lines) > 100. * static_cast<double> (bytes.size()))
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
isComplete (const std::string& bytes, const Header& header)
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
    if (!field || field->datatype != pcl::PCLPointField::FLOAT32)
      throw AppError (file + ": the cloud has no 32-bit field '" + name +
                      "'; write it as a float");
  }
  if (cloud.height < 2 || cloud.width < 2)
    throw AppError (file + ": the cloud is unorganized (" +
                    std::to_string (cloud.width) + " x " +
                    std::to_string (cloud.height) +
                    "); record organized clouds (an image of points, missing ones as "
                    "NaN), or give the depth image");
}

/** Fills in the data; false where it is damaged. */
bool
readBody (const std::string& bytes, Header& header)
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
    std::istringstream stream (bytes.substr (header.data_begin));
    return reader.readBodyASCII (stream, header.cloud, header.version) == 0;
  }
  catch (const std::exception&) {
    return false;
  }
}

Header
readFile (const std::string& file, const std::vector<std::string>& floats)
{
  const std::string bytes = readBytes (file);
  Header header = readHeader (bytes, file);
  checkHeader (header.cloud, floats, file);
  if (!isComplete (bytes, header) || !readBody (bytes, header))
    throw damaged (file);
  return header;
}

} // namespace

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readOrganizedPcd (const std::string& file, PointLabels* labels)
{
  const QuietPcl quiet;
  const Header header = readFile (file, {"x", "y", "z"});
  const pcl::PCLPointCloud2& blob = header.cloud;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  cloud->sensor_origin_ = header.origin;
  cloud->sensor_orientation_ = header.orientation;
  const std::size_t offsets[] = {findField (blob, "x")->offset,
                                 findField (blob, "y")->offset,
                                 findField (blob, "z")->offset};
  const auto* rgba = findField (blob, "rgba");
  const auto* colour = rgba ? rgba : findField (blob, "rgb");
  cloud->resize (blob.width, blob.height);
  cloud->is_dense = false;
  const std::uint8_t* data = blob.data.data();
  for (auto& point : *cloud) {
    for (int i = 0; i < 3; ++i)
      std::memcpy (&point.data[i], data + offsets[i], sizeof (float));
    if (!isMeasured (point.data))
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN();
    if (colour)
      std::memcpy (&point.rgba, data + colour->offset, sizeof (point.rgba));
    data += blob.point_step;
  }
  if (labels)
    *labels = readPointLabels (blob);
  return cloud;
}

pcl::PointCloud<pcl::Intensity>
readIntensityPcd (const std::string& file)
{
  const QuietPcl quiet;
  const Header header = readFile (file, {"intensity"});
  pcl::PointCloud<pcl::Intensity> cloud (header.cloud.width, header.cloud.height);
  const std::uint8_t* data =
      header.cloud.data.data() + findField (header.cloud, "intensity")->offset;
  for (auto& point : cloud) {
    std::memcpy (&point.intensity, data, sizeof (point.intensity));
    data += header.cloud.point_step;
  }
  return cloud;
}

} // namespace rgbd_planes
} // namespace pcl
