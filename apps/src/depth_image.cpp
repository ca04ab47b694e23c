// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <png.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_image.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

/** What libpng needs while it reads; it leaves through longjmp, so nothing with a
 * destructor may live in the functions it leaves. */
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  char error[128] = "";
  bool is_depth = false;

  ~PngReader() { png_destroy_read_struct (&png, &info, nullptr); }
};

[[noreturn]] void
onPngError (png_structp png, png_const_charp message)
{
  auto* reader = static_cast<PngReader*> (png_get_error_ptr (png));
  std::strncpy (reader->error, message, sizeof (reader->error) - 1);
  png_longjmp (png, 1);
}

void
onPngWarning (png_structp, png_const_charp)
{}

using File = std::unique_ptr<std::FILE, int (*) (std::FILE*)>;

/** Null where the file cannot be opened. */
File
open (const std::string& path, PngReader& reader)
{
  reader.png =
      png_create_read_struct (PNG_LIBPNG_VER_STRING, &reader, onPngError, onPngWarning);
  reader.info = reader.png ? png_create_info_struct (reader.png) : nullptr;
  if (!reader.info)
    throw std::bad_alloc();
  return {std::fopen (path.c_str(), "rb"), &std::fclose};
}

bool
readHeader (PngReader& reader, std::FILE* file, DepthImage& image)
{
  if (setjmp (png_jmpbuf (reader.png)))
    return false;
  png_init_io (reader.png, file);
  png_read_info (reader.png, reader.info);
  image.width = png_get_image_width (reader.png, reader.info);
  image.height = png_get_image_height (reader.png, reader.info);
  reader.is_depth = png_get_bit_depth (reader.png, reader.info) == 16 &&
                    png_get_color_type (reader.png, reader.info) == PNG_COLOR_TYPE_GRAY;
  return true;
}

bool
readPixels (PngReader& reader, DepthImage& image)
{
  if (setjmp (png_jmpbuf (reader.png)))
    return false;
  png_set_swap (reader.png);
  const int passes = png_set_interlace_handling (reader.png);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t v = 0; v < image.height; ++v)
      png_read_row (reader.png,
                    reinterpret_cast<png_bytep> (&image.depth[v * image.width]),
                    nullptr);
  png_read_end (reader.png, nullptr);
  return true;
}

} // namespace

bool
isOtherPng (const std::string& path)
{
  PngReader reader;
  const File file = open (path, reader);
  DepthImage image;
  return file && readHeader (reader, file.get(), image) && !reader.is_depth;
}

DepthImage
readDepthPng (const std::string& path)
{
  PngReader reader;
  const File file = open (path, reader);
  if (!file)
    throw cannotOpen (path);

  DepthImage image;
  if (!readHeader (reader, file.get(), image))
    throw AppError (path + ": not a readable PNG file (" + reader.error +
                    "); copy or record it again");
  if (!reader.is_depth)
    throw AppError (path +
                    ": not a depth image, which is 16-bit greyscale; is this the "
                    "colour image? Give the depth image or its folder");
  // One byte of the file stands for 1032 at most (RFC 1951).
  const std::size_t pixels = std::size_t{image.width} * image.height;
  std::error_code error;
  const bool can_hold = pixels * sizeof (std::uint16_t) / 1032 <=
                        std::filesystem::file_size (path, error);
  if (can_hold)
    image.depth.resize (pixels);
  if (!can_hold || !readPixels (reader, image))
    throw AppError (path + ": the PNG file is incomplete or damaged (" +
                    (can_hold ? reader.error : "too small for its pixels") +
                    "); copy or record it again");
  return image;
}

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
toCloud (const DepthImage& image, const Intrinsics& intrinsics, float units_per_metre)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (image.width, image.height);
  cloud->is_dense = false;
  std::size_t i = 0;
  for (std::uint32_t v = 0; v < image.height; ++v)
    for (std::uint32_t u = 0; u < image.width; ++u, ++i) {
      const std::uint16_t depth = image.depth[i];
      const float z = depth == 0 || depth == 65535
                          ? nan
                          : static_cast<float> (depth) / units_per_metre;
      auto& point = (*cloud)[i];
      point.x = (static_cast<float> (u) - intrinsics.cx) * z / intrinsics.fx;
      point.y = (static_cast<float> (v) - intrinsics.cy) * z / intrinsics.fy;
      point.z = z;
    }
  return cloud;
}

} // namespace rgbd_planes
} // namespace pcl
