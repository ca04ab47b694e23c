// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <png.h>

#include <pcl/apps/pictures.h>
#include <pcl/common/colors.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

const pcl::RGB black (0, 0, 0);
const pcl::RGB grey (128, 128, 128);

/** \param[in] hue in turns,
 * \param[in] saturation from 0 to 1,
 * \param[in] value 0 to 1
 */
pcl::RGB
fromHsv (float hue, float saturation, float value)
{
  const auto channel = [&] (float offset) {
    const float position = 6.f * std::fmod (hue + offset, 1.f);
    const float pure = std::clamp (std::abs (position - 3.f) - 1.f, 0.f, 1.f);
    return static_cast<std::uint8_t> (
        std::lround (255.f * value * (1.f - saturation + saturation * pure)));
  };
  return {channel (0.f), channel (2.f / 3.f), channel (1.f / 3.f)};
}

} // namespace

pcl::RGB
planeColour (std::uint32_t id)
{
  // The golden angle spreads hues evenly; those that come close differ in shade.
  constexpr float shades[3][2] = {{0.75f, 1.f}, {0.95f, 0.65f}, {0.4f, 1.f}};
  const auto& [saturation, value] = shades[id % 3];
  const double turns = id * 0.3819660112501051;
  return fromHsv (static_cast<float> (turns - std::floor (turns)), saturation, value);
}

Picture
colourPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  Picture picture (cloud.width, cloud.height);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    picture[i] = pcl::RGB (cloud[i].r, cloud[i].g, cloud[i].b);
  return picture;
}

Picture
planesPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
               const pcl::PointCloud<pcl::Label>& labels)
{
  Picture picture (cloud.width, cloud.height);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!std::isfinite (cloud[i].z))
      picture[i] = black;
    else
      picture[i] = labels[i].label == unlabelled ? grey : planeColour (labels[i].label);
  return picture;
}

Picture
normalsPicture (const pcl::PointCloud<pcl::Normal>& normals)
{
  const auto channel = [] (float n) {
    return static_cast<std::uint8_t> (std::lround (127.5f * (n + 1.f)));
  };
  Picture picture (normals.width, normals.height, black);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto& n = normals[i];
    if (std::isfinite (n.normal_x))
      picture[i] = {channel (n.normal_x), channel (n.normal_y), channel (n.normal_z)};
  }
  return picture;
}

Picture
depthPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  std::vector<float> depths;
  for (const auto& point : cloud)
    if (std::isfinite (point.z))
      depths.push_back (point.z);
  Picture picture (cloud.width, cloud.height, black);
  if (depths.empty())
    return picture;
  const auto quantile = [&] (std::size_t percent) {
    const auto nth = depths.begin() +
                     static_cast<std::ptrdiff_t> ((depths.size() - 1) * percent / 100);
    std::nth_element (depths.begin(), nth, depths.end());
    return *nth;
  };
  // The first colours of the map are too dark to tell from black.
  constexpr float first = 40.f, last = 255.f;
  const float near = quantile (2), far = quantile (98);
  const float scale = far > near ? (last - first) / (far - near) : 0.f;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (std::isfinite (cloud[i].z))
      picture[i] = pcl::ViridisLUT::at (static_cast<std::size_t> (
          std::clamp (first + (far - cloud[i].z) * scale, first, last)));
  return picture;
}

Picture
warpPicture (const pcl::PointCloud<pcl::Intensity>& warp)
{
  constexpr float full = 0.01f;
  Picture picture (warp.width, warp.height);
  for (std::size_t i = 0; i < warp.size(); ++i) {
    const float share = std::clamp (warp[i].intensity / full, -1.f, 1.f);
    const auto rest = static_cast<std::uint8_t> (255.f * (1.f - std::fabs (share)));
    picture[i] = share > 0.f ? pcl::RGB (255, rest, rest) : pcl::RGB (rest, rest, 255);
  }
  return picture;
}

std::string
encodePng (const Picture& picture)
{
  std::vector<std::uint8_t> rgb;
  rgb.reserve (3 * picture.size());
  for (const auto& pixel : picture)
    rgb.insert (rgb.end(), {pixel.r, pixel.g, pixel.b});
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = picture.width;
  image.height = picture.height;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX (image);
  std::string bytes (size, '\0');
  if (!png_image_write_to_memory (
          &image, bytes.data(), &size, 0, rgb.data(), 0, nullptr))
    throw std::runtime_error (std::string ("cannot encode a picture: ") +
                              image.message);
  bytes.resize (size);
  return bytes;
}

} // namespace rgbd_planes
} // namespace pcl
