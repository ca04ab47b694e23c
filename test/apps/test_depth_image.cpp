// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_image.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

/** A picture that uses both bytes, with 0 and the largest number. */
std::vector<std::uint16_t>
someSamples ()
{
  std::vector<std::uint16_t> samples (7 * 5);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::uint16_t> (1871 * i);
  samples[3] = 65535;
  return samples;
}

void
expectRefused (const std::filesystem::path& file, const std::string& reason)
{
  try {
    readDepthPng (file);
    ADD_FAILURE() << file << " was read";
  }
  catch (const AppError& error) {
    const std::string message = error.what();
    EXPECT_EQ (message.rfind (file.string() + ": ", 0), 0u) << message;
    EXPECT_NE (message.find (reason), std::string::npos) << message;
    EXPECT_EQ (message.find ('\n'), std::string::npos) << message;
  }
}

} // namespace

TEST (DepthImage, HoldsTheStoredNumbers)
{
  const TemporaryFolder folder;
  const PngFormat formats[] = {
      {}, {16, 1, true, 0.}, {16, 1, false, 0.45455}, {16, 1, false, 1.}};
  for (const auto& format : formats) {
    writePng (folder / "depth.png", 7, someSamples(), format);
    const DepthImage image = readDepthPng (folder / "depth.png");
    EXPECT_EQ (image.width, 7u);
    EXPECT_EQ (image.height, 5u);
    EXPECT_EQ (image.depth, someSamples());
  }
}

TEST (DepthImage, OtherPicturesAreRefused)
{
  const TemporaryFolder folder;
  writePng (folder / "grey.png", 7, someSamples(), {8, 1, false, 0.});
  expectRefused (folder / "grey.png", "16-bit greyscale");
  writePng (
      folder / "colour.png", 2, std::vector<std::uint16_t> (12), {8, 3, false, 0.});
  expectRefused (folder / "colour.png", "16-bit greyscale");
  writePng (
      folder / "deep.png", 2, std::vector<std::uint16_t> (12), {16, 3, false, 0.});
  expectRefused (folder / "deep.png", "16-bit greyscale");
  writeFile (folder / "text.png", "no picture at all");
  expectRefused (folder / "text.png", "not a readable PNG");
  writeFile (folder / "empty.png", "");
  expectRefused (folder / "empty.png", "not a readable PNG");
  expectRefused (folder / "missing.png", "cannot open");
  expectRefused (folder.path(), "not a readable PNG");
}

TEST (DepthImage, OtherPicturesAreKnown)
{
  const TemporaryFolder folder;
  writePng (folder / "depth.png", 7, someSamples());
  writePng (
      folder / "colour.png", 2, std::vector<std::uint16_t> (12), {8, 3, false, 0.});
  writeFile (folder / "part.png", readFile (folder / "depth.png").substr (0, 20));
  EXPECT_TRUE (isOtherPng (folder / "colour.png"));
  for (const char* name : {"depth.png", "part.png", "missing.png"})
    EXPECT_FALSE (isOtherPng (folder / name)) << name;
}

TEST (DepthImage, NoMemoryIsTakenForPixelsThatTheFileCannotHold)
{
  const TemporaryFolder folder;
  // A header of 60000 x 60000 pixels with its checksum, and nothing else.
  const std::string header (
      "\0\0\0\x0dIHDR\0\0\xea\x60\0\0\xea\x60\x10\0\0\0\0\xf5\x29\xf6\xdd", 25);
  const std::string data ("\0\0\0\0IDAT", 8);
  writeFile (folder / "huge.png", "\x89PNG\r\n\x1a\n" + header + data);
  expectRefused (folder / "huge.png", "too small for its pixels");
}

TEST (DepthImage, EveryTruncationIsRefused)
{
  const TemporaryFolder folder;
  writePng (folder / "whole.png", 7, someSamples());
  const std::string whole = readFile (folder / "whole.png");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    writeFile (folder / "part.png", whole.substr (0, size));
    expectRefused (folder / "part.png", "");
  }
}

TEST (DepthImage, EveryDamageIsRefusedOrHarmless)
{
  const TemporaryFolder folder;
  writePng (folder / "whole.png", 7, someSamples());
  const std::string whole = readFile (folder / "whole.png");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char> (damaged[i] ^ 0x55);
    writeFile (folder / "damaged.png", damaged);
    try {
      EXPECT_EQ (readDepthPng (folder / "damaged.png").depth, someSamples());
    }
    catch (const AppError&) {
    }
  }
}

TEST (DepthImage, PointsFollowThePinholeModel)
{
  DepthImage image{4, 3, std::vector<std::uint16_t> (12, 0)};
  image.depth[0] = 1000;
  image.depth[2 * 4 + 3] = 3000;
  image.depth[1 * 4 + 2] = 65534;
  image.depth[1 * 4 + 3] = 65535; // as some cameras write missing depth
  const auto cloud = toCloud (image, {500.f, 400.f, 1.5f, 1.f}, 2000.f);
  ASSERT_EQ (cloud->width, 4u);
  ASSERT_EQ (cloud->height, 3u);
  EXPECT_FLOAT_EQ ((*cloud) (0, 0).x, -0.0015f);  // (0 - 1.5) * 0.5 / 500
  EXPECT_FLOAT_EQ ((*cloud) (0, 0).y, -0.00125f); // (0 - 1) * 0.5 / 400
  EXPECT_FLOAT_EQ ((*cloud) (0, 0).z, 0.5f);
  EXPECT_FLOAT_EQ ((*cloud) (3, 2).x, 0.0045f);  // (3 - 1.5) * 1.5 / 500
  EXPECT_FLOAT_EQ ((*cloud) (3, 2).y, 0.00375f); // (2 - 1) * 1.5 / 400
  EXPECT_FLOAT_EQ ((*cloud) (3, 2).z, 1.5f);
  EXPECT_FLOAT_EQ ((*cloud) (2, 1).z, 32.767f);
  EXPECT_FLOAT_EQ ((*cloud) (2, 1).y, 0.f);
  int missing = 0;
  for (const auto& point : *cloud)
    missing += std::isnan (point.x) && std::isnan (point.y) && std::isnan (point.z);
  EXPECT_EQ (missing, 9);
  EXPECT_FALSE (cloud->is_dense);
}
