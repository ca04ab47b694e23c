// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/plane_tracker.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tracked_rows {

constexpr std::uint32_t unlabelled = std::numeric_limits<std::uint32_t>::max();

struct Image {
  std::vector<pcl::ModelCoefficients> models;
  pcl::PointCloud<pcl::Label> labels;
};

inline pcl::ModelCoefficients
plane (float a, float b, float c, float d)
{
  pcl::ModelCoefficients model;
  model.values = {a, b, c, d};
  return model;
}

inline const auto wall = plane (0.f, 0.f, -1.f, 2.f);
inline const auto ground = plane (0.f, -1.f, 0.f, 1.f);

/** One row of pixels: a letter for each, 'a' for the first plane, '.' for none. */
inline Image
row (const std::vector<pcl::ModelCoefficients>& models, const std::string& pixels)
{
  Image image{models, {}};
  image.labels.resize (static_cast<std::uint32_t> (pixels.size()), 1);
  std::transform (
      pixels.begin(), pixels.end(), image.labels.begin(), [] (const char letter) {
        pcl::Label label;
        label.label =
            letter == '.' ? unlabelled : static_cast<std::uint32_t> (letter - 'a');
        return label;
      });
  return image;
}

inline std::vector<std::uint32_t>
track (pcl::PlaneTracker& tracker, const Image& image)
{
  std::vector<std::uint32_t> ids;
  tracker.track (image.models, image.labels, ids);
  return ids;
}

using Ids = std::vector<std::uint32_t>;

} // namespace tracked_rows
