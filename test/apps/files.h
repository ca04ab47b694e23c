// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/** A new folder that goes with all it holds when the test ends. */
class TemporaryFolder {
public:
  TemporaryFolder();
  TemporaryFolder (const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator= (const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all (path_); }

  std::filesystem::path
  operator/ (const std::string& name) const
  {
    return path_ / name;
  }

  const std::filesystem::path&
  path () const
  {
    return path_;
  }

private:
  std::filesystem::path path_;
};

void
writeFile (const std::filesystem::path& file, const std::string& contents);

std::string
readFile (const std::filesystem::path& file);

/** The names of the files in a folder, hidden ones as well, sorted. */
std::vector<std::string>
listFolder (const std::filesystem::path& folder);

/** What the files in a folder and below hold; nothing for folders, pipes and the like. */
std::map<std::filesystem::path, std::string>
readFolder (const std::filesystem::path& folder);

struct PngFormat {
  int bits = 16;
  int channels = 1;
  bool interlaced = false;
  /** Of the gAMA chunk; none where 0. */
  double gamma = 0.;
};

/** Writes a PNG of so many pixels a row; samples of 8 bits are the low bytes. */
void
writePng (const std::filesystem::path& file,
          std::uint32_t width,
          const std::vector<std::uint16_t>& samples,
          const PngFormat& format = {});

struct RgbImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  /** Red, green, blue of each pixel. */
  std::vector<std::uint8_t> samples;
};

/** Reads an 8-bit RGB PNG. */
RgbImage
readRgbPng (const std::filesystem::path& file);

/** The text of an ascii PCD file, of a header for \a fields of floats and \a points. */
std::string
asciiPcd (const std::string& fields, int width, int height, const std::string& points);
