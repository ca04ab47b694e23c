// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

pcl::PointCloud<pcl::PointXYZRGBL>
someCloud ()
{
  pcl::PointCloud<pcl::PointXYZRGBL> cloud (16, 12);
  for (std::uint32_t v = 0; v < cloud.height; ++v)
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      auto& point = cloud (u, v);
      point.x = 0.01f * static_cast<float> (u) - 0.1f;
      point.y = 0.02f * static_cast<float> (v);
      point.z = 1.f + 0.001f * static_cast<float> (u * v);
      point.r = static_cast<std::uint8_t> (u);
      point.g = static_cast<std::uint8_t> (v);
      point.b = 200;
      point.label = u;
    }
  cloud (3, 4).x = cloud (3, 4).y = cloud (3, 4).z = missing;
  cloud.sensor_orientation_ = Eigen::Quaternionf (0.f, 1.f, 0.f, 0.f);
  return cloud;
}

template <typename PointT>
void
expectSameAsSomeCloud (const std::filesystem::path& file, bool coloured)
{
  pcl::PointCloud<PointT> cloud;
  pcl::copyPointCloud (someCloud(), cloud);
  for (int format = 0; format < 3; ++format) {
    pcl::PCDWriter writer;
    if (format == 0)
      writer.writeASCII (file, cloud, 9);
    else if (format == 1)
      writer.writeBinary (file, cloud);
    else
      writer.writeBinaryCompressed (file, cloud);
    const auto read = readOrganizedPcd (file);
    const auto truth = someCloud();
    ASSERT_EQ (read->width, truth.width);
    ASSERT_EQ (read->height, truth.height);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (std::isnan (truth[i].x)) {
        EXPECT_TRUE (std::isnan ((*read)[i].x) && std::isnan ((*read)[i].z));
        continue;
      }
      EXPECT_EQ ((*read)[i].getVector3fMap(), truth[i].getVector3fMap()) << i;
      EXPECT_EQ ((*read)[i].r, coloured ? truth[i].r : 0) << i;
      EXPECT_EQ ((*read)[i].g, coloured ? truth[i].g : 0) << i;
      EXPECT_EQ ((*read)[i].b, coloured ? truth[i].b : 0) << i;
    }
    EXPECT_EQ (read->sensor_orientation_.coeffs(), truth.sensor_orientation_.coeffs());
  }
}

std::string
messageOf (const std::filesystem::path& file)
{
  try {
    readOrganizedPcd (file);
  }
  catch (const AppError& error) {
    const std::string message = error.what();
    EXPECT_EQ (message.rfind (file.string() + ": ", 0), 0u) << message;
    EXPECT_EQ (message.find ('\n'), std::string::npos) << message;
    return message;
  }
  return "";
}

} // namespace

TEST (OrganizedPcd, CoordinatesAndColourAreRead)
{
  const TemporaryFolder folder;
  expectSameAsSomeCloud<pcl::PointXYZ> (folder / "xyz.pcd", false);
  expectSameAsSomeCloud<pcl::PointXYZRGB> (folder / "rgb.pcd", true);
  expectSameAsSomeCloud<pcl::PointXYZRGBA> (folder / "rgba.pcd", true);
  expectSameAsSomeCloud<pcl::PointXYZRGBL> (folder / "label.pcd", true);
}

TEST (OrganizedPcd, FieldsMayComeInAnyOrder)
{
  const TemporaryFolder folder;
  writeFile (folder / "order.pcd",
             asciiPcd ("label z rgba y x",
                       2,
                       2,
                       "7 3 66051 2 1\n7 6 1 5 4\n"
                       "7 9 2 8 7\n7 12 3 11 10\n"));
  const auto cloud = readOrganizedPcd (folder / "order.pcd");
  EXPECT_EQ ((*cloud)[0].getVector3fMap(), Eigen::Vector3f (1.f, 2.f, 3.f));
  EXPECT_EQ ((*cloud)[3].getVector3fMap(), Eigen::Vector3f (10.f, 11.f, 12.f));
  EXPECT_EQ ((*cloud)[0].r, 1); // 66051 is 0x010203
  EXPECT_EQ ((*cloud)[0].g, 2);
  EXPECT_EQ ((*cloud)[0].b, 3);
}

TEST (OrganizedPcd, MissingDepthIsNaN)
{
  const TemporaryFolder folder;
  writeFile (folder / "missing.pcd",
             asciiPcd ("x y z", 2, 2, "0 0 0\n1 2 inf\nnan 1 1\n0 0 1\n"));
  const auto cloud = readOrganizedPcd (folder / "missing.pcd");
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE (std::isnan ((*cloud)[i].x) && std::isnan ((*cloud)[i].y) &&
                 std::isnan ((*cloud)[i].z))
        << i;
  EXPECT_EQ ((*cloud)[3].getVector3fMap(), Eigen::Vector3f (0.f, 0.f, 1.f));
}

TEST (OrganizedPcd, OtherFilesAreRefused)
{
  const TemporaryFolder folder;
  EXPECT_NE (messageOf (folder / "missing.pcd").find ("cannot open"),
             std::string::npos);
  EXPECT_NE (messageOf (folder.path()).find ("cannot open"), std::string::npos);
  writeFile (folder / "empty.pcd", "");
  EXPECT_NE (messageOf (folder / "empty.pcd").find ("not a PCD"), std::string::npos);
  writeFile (folder / "text.pcd", "no cloud\nat all\n");
  EXPECT_NE (messageOf (folder / "text.pcd").find ("not a PCD"), std::string::npos);
  writeFile (folder / "row.pcd", asciiPcd ("x y z", 2, 1, "1 1 1\n2 2 2\n"));
  EXPECT_NE (messageOf (folder / "row.pcd").find ("unorganized"), std::string::npos);
  writeFile (folder / "flat.pcd", asciiPcd ("x y", 2, 2, "1 1\n1 1\n1 1\n1 1\n"));
  EXPECT_NE (messageOf (folder / "flat.pcd").find ("'z'"), std::string::npos);
  // The product of these is 0 in 32 bits.
  std::string huge = asciiPcd ("x y z", 2, 2, "1 1 1\n");
  huge.replace (huge.find ("WIDTH 2"), 16, "WIDTH 65536\nHEIGHT 65536");
  huge.replace (huge.find ("POINTS 4"), 8, "POINTS 0");
  writeFile (folder / "huge.pcd", huge);
  EXPECT_NE (messageOf (folder / "huge.pcd").find ("damaged"), std::string::npos);
  std::string doubles = asciiPcd ("x y z", 2, 2, "1 1 1\n1 1 1\n1 1 1\n1 1 1\n");
  doubles.replace (doubles.find ("SIZE 4"), 6, "SIZE 8");
  writeFile (folder / "double.pcd", doubles);
  EXPECT_NE (messageOf (folder / "double.pcd").find ("'x'"), std::string::npos);
}

TEST (OrganizedPcd, NoMemoryIsTakenForPointsThatTheFileCannotHold)
{
  const TemporaryFolder folder;
  for (const std::string points : {"4294901760", "-65536"}) {
    std::string huge = asciiPcd ("x y z", 2, 2, "1 1 1\n");
    huge.replace (huge.find ("WIDTH 2"), 16, "WIDTH 65535\nHEIGHT 65536");
    huge.replace (huge.find ("POINTS 4"), 8, "POINTS " + points);
    writeFile (folder / "huge.pcd", huge);
    EXPECT_NE (messageOf (folder / "huge.pcd").find ("damaged"), std::string::npos);
  }
}

TEST (OrganizedPcd, NoMemoryIsTakenForValuesThatTheFileCannotHold)
{
  const TemporaryFolder folder;
  for (const std::string count :
       {"2147483647", "16666666666E666", "-1e666", "nan 1e9", "0-11"}) {
    std::string huge = asciiPcd ("x y z", 2, 2, "1 1 1\n");
    const std::size_t line = huge.find ("COUNT");
    huge.replace (line, huge.find ('\n', line) - line, "COUNT 1 " + count + " 1");
    writeFile (folder / "huge.pcd", huge);
    EXPECT_NE (messageOf (folder / "huge.pcd").find ("damaged"), std::string::npos)
        << count;
  }
}

TEST (OrganizedPcd, NoMemoryIsTakenForFieldsOfAnySize)
{
  const TemporaryFolder folder;
  for (const std::string size : {"2147483647", "1e666"}) {
    std::string huge = asciiPcd ("x y z", 2, 2, "1 1 1\n");
    huge.replace (huge.find ("SIZE 4 4"), 8, "SIZE 4 " + size);
    huge.replace (huge.find ("COUNT 1 1"), 9, "COUNT 1 0");
    writeFile (folder / "huge.pcd", huge);
    EXPECT_NE (messageOf (folder / "huge.pcd").find ("damaged"), std::string::npos)
        << size;
  }
}

TEST (OrganizedPcd, FieldsThatAreNamedTwiceAreRefused)
{
  const TemporaryFolder folder;
  for (const std::string other : {"FIELDS a b c d\n", "COLUMNS x y z\n"}) {
    std::string text = asciiPcd ("x y z", 2, 2, "1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
    text.insert (text.find ("TYPE"), other);
    writeFile (folder / "twice.pcd", text);
    EXPECT_NE (messageOf (folder / "twice.pcd").find ("damaged"), std::string::npos)
        << other;
  }
}

TEST (OrganizedPcd, ViewpointsMayBeNegativeAndFieldsWithoutSizes)
{
  const TemporaryFolder folder;
  std::string text = asciiPcd ("x y z", 2, 2, "1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
  const auto viewpoint = text.find ("POINTS");
  text.insert (viewpoint, "VIEWPOINT 0 0 0 0 -1 0 0\n");
  writeFile (folder / "viewpoint.pcd", text);
  EXPECT_EQ (readOrganizedPcd (folder / "viewpoint.pcd")->sensor_orientation_.x(),
             -1.f);
  writeFile (folder / "sizes.pcd",
             "VERSION .7\nFIELDS x y z\nWIDTH 65535\nHEIGHT 65536\n"
             "POINTS 4294901760\nDATA ascii\n");
  EXPECT_NE (messageOf (folder / "sizes.pcd").find ("damaged"), std::string::npos);
}

TEST (OrganizedPcd, CloudsInOtherFramesAreRefused)
{
  const TemporaryFolder folder;
  for (const std::string origin : {"-1 0 0", "0 0 1e-3"}) {
    std::string text = asciiPcd ("x y z", 2, 2, "1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
    text.insert (text.find ("POINTS"), "VIEWPOINT " + origin + " 1 0 0 0\n");
    writeFile (folder / "base.pcd", text);
    EXPECT_NE (messageOf (folder / "base.pcd").find ("VIEWPOINT"), std::string::npos)
        << origin;
  }
}

TEST (OrganizedPcd, EachLineOfTextIsAPoint)
{
  const TemporaryFolder folder;
  const auto message = [&] (const std::string& lines) {
    writeFile (folder / "text.pcd", asciiPcd ("x y z", 2, 2, lines));
    return messageOf (folder / "text.pcd");
  };
  EXPECT_EQ (message ("1 1 1\r\n\n 2\t2  2 \n-nan inf 3e-1\n4 4 4\n\n"), "");
  for (const std::string second : {"2 2", "2 2 2 2", "2,5 2 2", "2 2 b", "2 2 2x"})
    EXPECT_NE (message ("1 1 1\n" + second + "\n3 3 3\n4 4 4\n").find ("damaged"),
               std::string::npos)
        << second;
}

TEST (OrganizedPcd, EveryTruncationIsRefused)
{
  const TemporaryFolder folder;
  pcl::PCDWriter writer;
  writer.writeBinary (folder / "binary.pcd", someCloud());
  writer.writeBinaryCompressed (folder / "compressed.pcd", someCloud());
  for (const std::string name : {"binary.pcd", "compressed.pcd"}) {
    const std::string whole = readFile (folder / name);
    const std::size_t header = whole.find ("DATA") + 50;
    for (std::size_t size = 0; size < whole.size(); size += size < header ? 1 : 97) {
      writeFile (folder / "part.pcd", whole.substr (0, size));
      EXPECT_NE (messageOf (folder / "part.pcd"), "") << name << ", first " << size;
    }
  }
}

TEST (OrganizedPcd, WrongSizesOfCompressedDataAreRefused)
{
  const TemporaryFolder folder;
  pcl::PCDWriter().writeBinaryCompressed (folder / "whole.pcd", someCloud());
  const std::string whole = readFile (folder / "whole.pcd");
  const std::size_t sizes = whole.find ("binary_compressed\n") + 18;
  for (std::size_t i = sizes; i < sizes + 8; ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char> (damaged[i] ^ 0x7f);
    writeFile (folder / "damaged.pcd", damaged);
    EXPECT_NE (messageOf (folder / "damaged.pcd"), "") << "byte " << i - sizes;
  }
}

TEST (OrganizedPcd, FramesWithoutDepthMayHaveFieldsOfAnySize)
{
  const TemporaryFolder folder;
  pcl::PCLPointCloud2 cloud;
  const auto addField = [&] (const std::string& name, std::uint8_t datatype) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = datatype;
    field.count = 1;
    cloud.fields.push_back (field);
    cloud.point_step += static_cast<std::uint32_t> (pcl::getFieldSize (datatype));
  };
  for (const std::string name : {"x", "y", "z"})
    addField (name, pcl::PCLPointField::FLOAT32);
  addField ("timestamp", pcl::PCLPointField::FLOAT64);
  for (const std::string name : {"ring", "channel", "return", "flags"})
    addField (name, pcl::PCLPointField::UINT8);
  cloud.width = 1024;
  cloud.height = 64;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.assign (std::size_t{cloud.row_step} * cloud.height, 0);
  pcl::PCDWriter().writeBinaryCompressed (folder / "dark.pcd", cloud);
  EXPECT_EQ (messageOf (folder / "dark.pcd"), "");
}

TEST (OrganizedPcd, IntensitiesAreRead)
{
  const TemporaryFolder folder;
  pcl::PointCloud<pcl::PointXYZI> cloud (6, 4);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].intensity = 0.25f * static_cast<float> (i);
  pcl::io::savePCDFileBinaryCompressed (folder / "some.pcd", cloud);
  const auto read = readIntensityPcd (folder / "some.pcd");
  ASSERT_EQ (read.width, 6u);
  ASSERT_EQ (read.height, 4u);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ (read[i].intensity, cloud[i].intensity);
  pcl::io::savePCDFileBinary (folder / "other.pcd", someCloud());
  EXPECT_THROW (readIntensityPcd (folder / "other.pcd"), AppError);
}
