// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/console/print.h>
#include <pcl/exceptions.h>
#include <pcl/features/organized_view.h>
#include <pcl/io/pcd_io.h>
#include <pcl/PCLPointCloud2.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

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

struct Header {
  /** Its data is as large as that of the file, but not read. */
  pcl::PCLPointCloud2 cloud;
  bool compressed = false;
  std::size_t data_begin = 0;
};

Header
readHeader (std::istream& stream, const std::string& file)
{
  Header header;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0, data_type = 0, result = -1;
  unsigned data_begin = 0;
  try {
    result = pcl::PCDReader().readHeader (
        stream, header.cloud, origin, orientation, version, data_type, data_begin);
  }
  catch (const std::exception&) {
    // Words that are no numbers, numbers of no sense: the same to the user.
  }
  if (result < 0 || data_begin == 0 || header.cloud.fields.empty())
    throw AppError (file +
                    ": not a PCD file, or its header is damaged; give a .pcd file");
  header.compressed = data_type == 2;
  header.data_begin = data_begin;
  return header;
}

/** PCDReader trusts the sizes in front of compressed data. */
bool
compressedSizesFit (std::istream& stream, std::uintmax_t bytes, const Header& header)
{
  std::uint32_t sizes[2];
  stream.clear();
  stream.seekg (static_cast<std::streamoff> (header.data_begin));
  return stream.read (reinterpret_cast<char*> (sizes), sizeof (sizes)) &&
         header.data_begin + sizeof (sizes) + sizes[0] <= bytes &&
         sizes[1] == header.cloud.data.size();
}

/** PCDReader::read crashes or hangs where one of these is not as it should be. */
void
checkFile (const std::string& file)
{
  std::error_code error;
  const auto bytes = std::filesystem::file_size (file, error);
  std::ifstream stream (file, std::ios::binary);
  if (error || !stream)
    throw AppError (file + ": cannot open this file: " +
                    (error ? error.message() : std::strerror (errno)));
  const Header header = readHeader (stream, file);
  const auto& cloud = header.cloud;
  for (const std::string name : {"x", "y", "z"}) {
    const auto* field = findField (cloud, name);
    if (!field || field->datatype != pcl::PCLPointField::FLOAT32)
      throw AppError (file + ": the cloud has no 32-bit field '" + name +
                      "'; write it with x y z as floats");
  }
  if (cloud.height < 2 || cloud.width < 2)
    throw AppError (file + ": the cloud is unorganized (" +
                    std::to_string (cloud.width) + " x " +
                    std::to_string (cloud.height) +
                    "); record organized clouds (an image of points, missing ones as "
                    "NaN), or give the depth image");
  const auto size = std::uint64_t{cloud.width} * cloud.height * cloud.point_step;
  if (cloud.data.size() != size ||
      (header.compressed && !compressedSizesFit (stream, bytes, header)))
    throw damaged (file);
}

pcl::PCLPointCloud2
readCloud (const std::string& file,
           Eigen::Vector4f& origin,
           Eigen::Quaternionf& orientation)
{
  pcl::PCLPointCloud2 cloud;
  int version = 0;
  try {
    if (pcl::PCDReader().read (file, cloud, origin, orientation, version) == 0)
      return cloud;
  }
  catch (const pcl::IOException&) {
    // Said below.
  }
  throw damaged (file);
}

} // namespace

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readOrganizedPcd (const std::string& file)
{
  const QuietPcl quiet;
  checkFile (file);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  const pcl::PCLPointCloud2 blob =
      readCloud (file, cloud->sensor_origin_, cloud->sensor_orientation_);
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
  return cloud;
}

std::vector<std::uint32_t>
readPcdLabels (const std::string& file)
{
  const QuietPcl quiet;
  checkFile (file);
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  const pcl::PCLPointCloud2 blob = readCloud (file, origin, orientation);
  const auto* field = findField (blob, "label");
  std::vector<std::uint32_t> labels;
  if (!field || field->datatype != pcl::PCLPointField::UINT32)
    return labels;
  labels.resize (std::size_t{blob.width} * blob.height);
  for (std::size_t i = 0; i < labels.size(); ++i)
    std::memcpy (&labels[i],
                 blob.data.data() + i * blob.point_step + field->offset,
                 sizeof (labels[i]));
  return labels;
}

} // namespace rgbd_planes
} // namespace pcl
