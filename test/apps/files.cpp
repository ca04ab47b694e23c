// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <png.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder()
{
  std::string name = fs::temp_directory_path() / "pcl_rgbd_planes_XXXXXX";
  if (!::mkdtemp (name.data()))
    throw std::runtime_error ("cannot create a temporary folder");
  path_ = fs::canonical (name);
}

void
writeFile (const fs::path& file, const std::string& contents)
{
  std::ofstream (file, std::ios::binary) << contents;
}

std::string
readFile (const fs::path& file)
{
  std::ostringstream contents;
  contents << std::ifstream (file, std::ios::binary).rdbuf();
  return contents.str();
}

std::vector<std::string>
listFolder (const fs::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator (folder))
    names.push_back (entry.path().filename());
  std::sort (names.begin(), names.end());
  return names;
}

std::map<fs::path, std::string>
readFolder (const fs::path& folder)
{
  std::map<fs::path, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator (folder))
    contents[entry.path()] = entry.is_regular_file() ? readFile (entry.path()) : "";
  return contents;
}

void
writePng (const fs::path& path,
          std::uint32_t width,
          const std::vector<std::uint16_t>& samples,
          const PngFormat& format)
{
  const std::size_t row_samples = std::size_t{width} * format.channels;
  const std::size_t height = samples.size() / row_samples;
  std::vector<std::vector<std::uint8_t>> rows (height);
  for (std::size_t i = 0; i < height * row_samples; ++i) {
    if (format.bits == 16)
      rows[i / row_samples].push_back (static_cast<std::uint8_t> (samples[i] >> 8));
    rows[i / row_samples].push_back (static_cast<std::uint8_t> (samples[i] & 0xff));
  }
  std::vector<png_bytep> pointers;
  for (auto& row : rows)
    pointers.push_back (row.data());

  const std::unique_ptr<std::FILE, int (*) (std::FILE*)> file (
      std::fopen (path.c_str(), "wb"), &std::fclose);
  png_structp png =
      png_create_write_struct (PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct (png);
  png_init_io (png, file.get());
  png_set_IHDR (png,
                info,
                width,
                static_cast<png_uint_32> (height),
                format.bits,
                format.channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                format.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                PNG_COMPRESSION_TYPE_DEFAULT,
                PNG_FILTER_TYPE_DEFAULT);
  if (format.gamma > 0.)
    png_set_gAMA (png, info, format.gamma);
  png_write_info (png, info);
  png_write_image (png, pointers.data());
  png_write_end (png, nullptr);
  png_destroy_write_struct (&png, &info);
}

RgbImage
readRgbPng (const fs::path& file)
{
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file (&image, file.c_str()) ||
      image.format != PNG_FORMAT_RGB)
    throw std::runtime_error (file.string() + " is no RGB picture");
  RgbImage result{image.width, image.height, {}};
  result.samples.resize (PNG_IMAGE_SIZE (image));
  if (!png_image_finish_read (&image, nullptr, result.samples.data(), 0, nullptr))
    throw std::runtime_error (file.string() + ": " + image.message);
  return result;
}

std::string
asciiPcd (const std::string& fields, int width, int height, const std::string& points)
{
  std::istringstream words (fields);
  std::string sizes, types, counts;
  for (std::string field; words >> field;) {
    sizes += " 4";
    types += field == "rgba" || field == "label" ? " U" : " F";
    counts += " 1";
  }
  std::ostringstream pcd;
  pcd << "VERSION .7\nFIELDS " << fields << "\nSIZE" << sizes << "\nTYPE" << types
      << "\nCOUNT" << counts << "\nWIDTH " << width << "\nHEIGHT " << height
      << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << width * height << "\nDATA ascii\n"
      << points;
  return pcd.str();
}
