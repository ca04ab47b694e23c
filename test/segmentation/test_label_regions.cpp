// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/connected_parts.h>
#include <pcl/segmentation/impl/label_runs.h>
#include <pcl/segmentation/impl/region_contour.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

struct Image {
  int width, height;
  std::vector<std::uint32_t> labels;

  bool
  contains (int u, int v) const
  {
    return u >= 0 && u < width && v >= 0 && v < height;
  }
};

/** Each row a string; digits are labels, all else is none. */
Image
makeImage (const std::vector<std::string>& rows)
{
  Image image{static_cast<int> (rows[0].size()), static_cast<int> (rows.size()), {}};
  for (const auto& row : rows)
    for (const char c : row)
      image.labels.push_back (
          c >= '0' && c <= '9' ? static_cast<std::uint32_t> (c - '0') : unlabelled);
  return image;
}

/** Images of every odd size, from sparse dots to solid areas with holes. */
std::vector<Image>
randomImages ()
{
  std::mt19937 generator (3);
  std::vector<Image> images;
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 5}, {17, 12}, {40, 30}})
    for (const unsigned percent : {0u, 20u, 50u, 60u, 90u, 100u})
      for (const std::uint32_t labels : {1u, 3u}) {
        Image image{width, height, {}};
        for (int i = 0; i < width * height; ++i)
          image.labels.push_back (
              generator() % 100 < percent
                  ? static_cast<std::uint32_t> (generator() % labels)
                  : unlabelled);
        images.push_back (image);
      }
  return images;
}

/** All pixels that can be reached from \a start over pixels that \a inside accepts, also
 * around the image, by steps to the side, and \a diagonal ones. */
std::set<std::pair<int, int>>
floodFill (const Image& image,
           std::pair<int, int> start,
           bool diagonal,
           const std::function<bool (int, int)>& inside)
{
  std::set<std::pair<int, int>> found{start};
  std::vector<std::pair<int, int>> open{start};
  while (!open.empty()) {
    const auto [u, v] = open.back();
    open.pop_back();
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du) {
        const int x = u + du, y = v + dv;
        const bool step = diagonal || std::abs (du) + std::abs (dv) == 1;
        if (step && x >= -1 && x <= image.width && y >= -1 && y <= image.height &&
            inside (x, y) && found.insert ({x, y}).second)
          open.emplace_back (x, y);
      }
  }
  return found;
}

std::set<std::pair<int, int>>
regionAround (const Image& image, int u, int v)
{
  const auto label = [&image] (int x, int y) {
    return image.labels[static_cast<std::size_t> (y * image.width + x)];
  };
  return floodFill (image, {u, v}, true, [&] (int x, int y) {
    return image.contains (x, y) && label (x, y) == label (u, v);
  });
}

LabelRuns
findRuns (const Image& image)
{
  LabelRuns runs;
  std::vector<std::uint32_t> labels = image.labels, numbers (10);
  std::iota (numbers.begin(), numbers.end(), 0u);
  runs.find (labels, static_cast<std::size_t> (image.width), numbers);
  return runs;
}

pcl::Indices
contourFrom (const Image& image, pcl::index_t start)
{
  pcl::Indices contour{1, 2, 3};
  traceContour (image.labels, static_cast<std::size_t> (image.width), start, contour);
  return contour;
}

} // namespace

TEST (LabelRuns, AreThePixelsOfEachLabel)
{
  for (const Image& image : randomImages()) {
    const LabelRuns runs = findRuns (image);
    std::vector<std::uint32_t> labels (image.labels.size(), unlabelled);
    std::vector<std::size_t> pixels (10, 0);
    for (const LabelRun& run : runs.runs()) {
      ASSERT_EQ (run.begin / image.width, (run.end - 1) / image.width);
      pcl::Indices list (run.size());
      pcl::index_t* end = list.data();
      run.appendTo (end);
      ASSERT_EQ (end, list.data() + list.size());
      for (const pcl::index_t pixel : list)
        labels[static_cast<std::size_t> (pixel)] = run.label;
      pixels[run.label] += run.size();
    }
    EXPECT_EQ (labels, image.labels);
    EXPECT_EQ (pixels, runs.pixels());
    ASSERT_EQ (runs.rows().size(), static_cast<std::size_t> (image.height) + 1);
    for (int row = 0; row < image.height; ++row)
      for (std::size_t i = runs.rows()[static_cast<std::size_t> (row)];
           i < runs.rows()[static_cast<std::size_t> (row) + 1];
           ++i)
        EXPECT_EQ (runs.runs()[i].begin / image.width, row);
  }
}

TEST (LabelRuns, GiveLabelsNewNumbers)
{
  const std::vector<std::uint32_t> numbers{
      3, unlabelled, 0, 2, unlabelled, 1, 6, 5, 4, 7};
  for (const Image& image : randomImages()) {
    Image expected = image;
    for (std::uint32_t& label : expected.labels)
      label = label == unlabelled ? unlabelled : numbers[label];
    std::vector<std::uint32_t> labels = image.labels;
    LabelRuns runs;
    runs.find (labels, static_cast<std::size_t> (image.width), numbers);
    EXPECT_EQ (labels, expected.labels);
    const LabelRuns expected_runs = findRuns (expected);
    ASSERT_EQ (runs.runs().size(), expected_runs.runs().size());
    for (std::size_t i = 0; i < runs.runs().size(); ++i) {
      EXPECT_EQ (runs.runs()[i].label, expected_runs.runs()[i].label);
      EXPECT_EQ (runs.runs()[i].begin, expected_runs.runs()[i].begin);
      EXPECT_EQ (runs.runs()[i].end, expected_runs.runs()[i].end);
    }
    EXPECT_EQ (runs.pixels(), expected_runs.pixels());
  }
}

TEST (ConnectedParts, AreThoseOfAFloodFill)
{
  ConnectedParts parts;
  for (const Image& image : randomImages()) {
    const LabelRuns runs = findRuns (image);
    parts.find (runs);
    std::vector<std::uint32_t> part_of_pixel (image.labels.size(), unlabelled);
    for (std::size_t i = 0; i < runs.runs().size(); ++i)
      std::fill (part_of_pixel.begin() + runs.runs()[i].begin,
                 part_of_pixel.begin() + runs.runs()[i].end,
                 parts.partOfRun()[i]);
    std::uint32_t expected = 0;
    std::set<std::pair<int, int>> seen;
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u) {
        const auto pixel = static_cast<std::size_t> (v * image.width + u);
        if (image.labels[pixel] == unlabelled || seen.count ({u, v}))
          continue;
        const auto region = regionAround (image, u, v);
        ASSERT_LT (expected, parts.parts().size());
        EXPECT_EQ (parts.parts()[expected].label, image.labels[pixel]);
        EXPECT_EQ (parts.parts()[expected].first, static_cast<pcl::index_t> (pixel));
        EXPECT_EQ (parts.parts()[expected].pixels, region.size());
        for (const auto& [x, y] : region)
          ASSERT_EQ (part_of_pixel[static_cast<std::size_t> (y * image.width + x)],
                     expected);
        seen.insert (region.begin(), region.end());
        ++expected;
      }
    EXPECT_EQ (parts.parts().size(), expected);
  }
}

/** The pixels with a side towards what is outside and reachable without stepping over
 * the region, in an order in which neighbours touch. */
TEST (RegionContour, IsWhereTheOutsideTouchesTheRegion)
{
  for (const Image& image : randomImages()) {
    ConnectedParts parts;
    parts.find (findRuns (image));
    for (const auto& part : parts.parts()) {
      const auto region =
          regionAround (image, part.first % image.width, part.first / image.width);
      const auto outside = floodFill (image, {-1, -1}, false, [&] (int x, int y) {
        return region.count ({x, y}) == 0;
      });
      std::set<std::pair<int, int>> expected, found;
      for (const auto& [u, v] : region)
        if (outside.count ({u - 1, v}) || outside.count ({u + 1, v}) ||
            outside.count ({u, v - 1}) || outside.count ({u, v + 1}))
          expected.emplace (u, v);
      const pcl::Indices contour = contourFrom (image, part.first);
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const pcl::index_t pixel = contour[i], next = contour[(i + 1) % contour.size()];
        found.emplace (pixel % image.width, pixel / image.width);
        EXPECT_LE (std::abs (pixel % image.width - next % image.width), 1);
        EXPECT_LE (std::abs (pixel / image.width - next / image.width), 1);
      }
      EXPECT_EQ (found, expected);
      EXPECT_EQ (contour[0], part.first);
    }
  }
}

TEST (RegionContour, RunsClockwiseAndKnowsNoHoles)
{
  EXPECT_EQ (contourFrom (makeImage ({"1"}), 0), (pcl::Indices{0}));
  EXPECT_EQ (contourFrom (makeImage ({"11", "11"}), 0), (pcl::Indices{0, 1, 3, 2}));
  EXPECT_EQ (contourFrom (makeImage ({".....", //
                                      ".111.",
                                      ".1.1.",
                                      ".111.",
                                      "....."}),
                          6),
             (pcl::Indices{6, 7, 8, 13, 18, 17, 16, 11}));
}

/** Where a region is thin, its contour goes there and back; a first pixel that joins two
 * arms is passed between them. */
TEST (RegionContour, FollowsThinParts)
{
  EXPECT_EQ (contourFrom (makeImage ({"1111"}), 0), (pcl::Indices{0, 1, 2, 3, 2, 1}));
  EXPECT_EQ (contourFrom (makeImage ({"..1..", //
                                      ".1.1.",
                                      "1...1"}),
                          2),
             (pcl::Indices{2, 8, 14, 8, 2, 6, 10, 6}));
}
