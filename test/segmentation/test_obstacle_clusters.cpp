// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/obstacle_clusters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using pcl::rgbd_planes::DepthNoise;
using pcl::rgbd_planes::ObstacleClass;
using pcl::rgbd_planes::ObstacleClusters;
using pcl::rgbd_planes::OrganizedPoints;
using pcl::rgbd_planes::PixelAngles;
using pcl::rgbd_planes::RowLinks;

namespace {

constexpr std::size_t height = 20;

/** Random classes, links and points, some of which are close to each other. */
struct Image {
  std::size_t width;
  std::vector<float> xyz;
  std::vector<ObstacleClass> classes;
  std::vector<bool> to_left, to_above;
  PixelAngles angles{0.012f, 0.03f};

  Image (std::size_t columns, unsigned seed, double excluded) : width (columns)
  {
    std::mt19937 random (seed);
    std::discrete_distribution<int> what ({2., 1., 6., 2., 0., excluded});
    std::uniform_real_distribution<float> depth (1.f, 1.1f);
    std::bernoulli_distribution is_linked (0.7);
    for (std::size_t i = 0; i < width * height; ++i) {
      xyz.insert (xyz.end(), {0.f, 0.f, depth (random), 1.f});
      classes.push_back (static_cast<ObstacleClass> (what (random)));
      to_left.push_back (is_linked (random));
      to_above.push_back (is_linked (random));
    }
  }

  OrganizedPoints
  points () const
  {
    return {xyz.data(), 4, static_cast<int> (width), static_cast<int> (height)};
  }

  RowLinks
  links (std::size_t v) const
  {
    RowLinks row;
    row.to_left.resize ((width + 63) / 64);
    row.to_above.resize (row.to_left.size());
    for (std::size_t u = 0; u < width; ++u) {
      row.to_left[u / 64] |= std::uint64_t{to_left[v * width + u]} << u % 64;
      row.to_above[u / 64] |= std::uint64_t{to_above[v * width + u]} << u % 64;
    }
    return row;
  }

  bool
  isThing (std::size_t i) const
  {
    return classes[i] == ObstacleClass::obstacle ||
           classes[i] == ObstacleClass::excluded;
  }

  bool
  isSameThing (std::size_t i, std::size_t j) const
  {
    return (isThing (i) && isThing (j)) ||
           (classes[i] == ObstacleClass::drop_off && classes[j] == classes[i]);
  }

  /** Whether points whose rays are so many pixels apart are close. */
  bool
  areClose (std::size_t i, std::size_t j, float angle) const
  {
    const float z = xyz[4 * i + 2], other = xyz[4 * j + 2];
    return std::abs (z - other) <=
           std::max (0.05f, 2.f * angle * z) + 3.f * DepthNoise().sigmaAtSquare (z * z);
  }

  /** Whether a point is connected with the next but one before it. */
  bool
  isBridged (std::size_t i, std::size_t step, float angle) const
  {
    return isSameThing (i, i - 2 * step) &&
           classes[i - step] == ObstacleClass::unmeasured &&
           areClose (i, i - 2 * step, 2.f * angle);
  }

  bool
  isLinkedUp (std::size_t i) const
  {
    return to_above[i] && isSameThing (i, i - width);
  }

  /** Whether a point is connected with the one above it and \a aside columns further right. */
  bool
  isDiagonal (std::size_t i, int aside) const
  {
    const std::size_t beside = i + static_cast<std::size_t> (aside);
    return isSameThing (i, beside - width) && !isLinkedUp (i) && !isLinkedUp (beside) &&
           areClose (i, beside - width, std::hypot (angles.in_row, angles.in_column));
  }
};

/** The first point of the cluster of each point, found by going round until nothing changes. */
std::vector<std::size_t>
firstPoints (const Image& image)
{
  std::vector<std::size_t> first (image.classes.size());
  std::iota (first.begin(), first.end(), std::size_t{0});
  bool has_changed = true;
  const auto join = [&] (std::size_t i, std::size_t j) {
    has_changed = has_changed || first[i] != first[j];
    first[i] = first[j] = std::min (first[i], first[j]);
  };
  while (has_changed) {
    has_changed = false;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const std::size_t u = i % image.width, v = i / image.width;
      if (u >= 1 && image.to_left[i] && image.isSameThing (i, i - 1))
        join (i, i - 1);
      if (v >= 1 && image.isLinkedUp (i))
        join (i, i - image.width);
      for (const int aside : {-1, 1})
        if (v >= 1 && (aside < 0 ? u >= 1 : u + 1 < image.width) &&
            image.isDiagonal (i, aside))
          join (i, i - image.width + static_cast<std::size_t> (aside));
      if (u >= 2 && image.isBridged (i, 1, image.angles.in_row))
        join (i, i - 2);
      if (v >= 2 && image.isBridged (i, image.width, image.angles.in_column))
        join (i, i - 2 * image.width);
    }
  }
  return first;
}

} // namespace

TEST (ObstacleClusters, AreTheConnectedPointsOfAnImage)
{
  constexpr std::size_t min_points = 3;
  ObstacleClusters clusters;
  for (const std::size_t width : {1u, 2u, 63u, 64u, 65u, 128u, 150u})
    for (const double excluded : {0., 2., 20.}) {
      const Image image (width, static_cast<unsigned> (width), excluded);
      clusters.start (
          image.points(), DepthNoise(), image.angles, min_points, 0, excluded > 0.);
      for (std::size_t v = 0; v < height; ++v)
        clusters.addRow (image.points(), &image.classes[v * width], image.links (v));
      std::vector<ObstacleClass> classes = image.classes;
      clusters.finish (classes);

      const auto isExcluded = [&] (std::size_t i) {
        return image.classes[i] == ObstacleClass::excluded;
      };
      const auto first = firstPoints (image);
      std::vector<std::size_t> sizes (first.size()), excluded_sizes (first.size());
      for (std::size_t i = 0; i < first.size(); ++i)
        ++(isExcluded (i) ? excluded_sizes : sizes)[first[i]];
      std::vector<std::uint32_t> cluster (first.size(), ObstacleClusters::none);
      for (const auto& run : clusters.runs())
        std::fill_n (cluster.begin() + static_cast<std::ptrdiff_t> (run.first),
                     run.length,
                     run.cluster);
      std::vector<std::uint32_t> expected (first.size(), ObstacleClusters::none);
      for (std::size_t i = 0; i < first.size(); ++i) {
        const bool is_thing = image.isSameThing (i, i) && !isExcluded (i);
        const std::size_t points = sizes[first[i]];
        const bool is_rim = 4 * points < excluded_sizes[first[i]];
        if (is_thing && !is_rim && points >= min_points) {
          ASSERT_LT (cluster[i], clusters.sizes().size()) << width << ' ' << i;
          if (expected[first[i]] == ObstacleClusters::none)
            expected[first[i]] = cluster[i];
          EXPECT_EQ (cluster[i], expected[first[i]]) << width << ' ' << i;
          EXPECT_EQ (clusters.sizes()[cluster[i]], points) << width << ' ' << i;
          EXPECT_EQ (classes[i], image.classes[i]) << width << ' ' << i;
        }
        else {
          const auto other = is_rim ? ObstacleClass::excluded : ObstacleClass::speck;
          EXPECT_EQ (cluster[i], ObstacleClusters::none) << width << ' ' << i;
          EXPECT_EQ (classes[i], is_thing ? other : image.classes[i]);
        }
      }
    }
}
