// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/linked_runs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using pcl::rgbd_planes::LinkedRuns;
using pcl::rgbd_planes::RunBits;

namespace {

/** Whether points are of runs, and close to those to the left and above. */
struct Image {
  std::size_t width, height;
  std::vector<bool> inside, to_left, to_above, can_bridge;

  Image (std::size_t w, std::size_t h, unsigned seed) : width (w), height (h)
  {
    std::mt19937 generator (seed);
    std::bernoulli_distribution often (0.8);
    for (std::size_t i = 0; i < w * h; ++i) {
      inside.push_back (often (generator));
      to_left.push_back (often (generator));
      to_above.push_back (often (generator));
      can_bridge.push_back (often (generator));
    }
  }

  bool
  isLinked (std::size_t i) const
  {
    return i % width > 0 && inside[i] && inside[i - 1] && to_left[i];
  }

  bool
  isJoined (std::size_t i) const
  {
    return i >= width && inside[i] && inside[i - width] && to_above[i];
  }

  bool
  isGap (std::size_t before, std::size_t after) const
  {
    const std::size_t i = (before + after) / 2;
    return inside[before] && !inside[i] && inside[after] && can_bridge[i];
  }

  RunBits
  bits (std::size_t row, std::size_t block) const
  {
    RunBits bits;
    for (std::size_t k = 0; k < LinkedRuns::block_size; ++k) {
      const std::size_t u = block * LinkedRuns::block_size + k, i = row * width + u;
      const auto bit = static_cast<std::uint16_t> (u < width ? 1u << k : 0u);
      bits.inside |= bit && inside[i] ? bit : 0;
      bits.linked |= bit && isLinked (i) ? bit : 0;
      bits.to_above |= bit && to_above[i] ? bit : 0; // whatever is there, or nothing
    }
    return bits;
  }

  /** The first point that each one hangs together with, over gaps of a pixel on demand, by
   * passing it on until nothing changes. */
  std::vector<std::size_t>
  firstPoints (bool are_bridged) const
  {
    std::vector<std::size_t> first (inside.size());
    for (std::size_t i = 0; i < first.size(); ++i)
      first[i] = i;
    const auto share = [&] (std::size_t i, std::size_t j) {
      const bool differ = first[i] != first[j];
      first[i] = first[j] = std::min (first[i], first[j]);
      return differ;
    };
    for (bool changes = true; changes;) {
      changes = false;
      for (std::size_t i = 0; i < first.size(); ++i) {
        changes |= isLinked (i) && share (i, i - 1);
        changes |= isJoined (i) && share (i, i - width);
        if (are_bridged && i % width >= 2)
          changes |= isGap (i - 2, i) && share (i, i - 2);
        if (are_bridged && i >= 2 * width)
          changes |= isGap (i - 2 * width, i) && share (i, i - 2 * width);
      }
    }
    return first;
  }
};

void
addRows (const Image& image, LinkedRuns& runs)
{
  runs.start (image.width);
  for (std::size_t row = 0; row < image.height; ++row) {
    for (std::size_t block = 0; block < runs.bits().size(); ++block)
      runs.bits()[block] = image.bits (row, block);
    runs.addRow (static_cast<std::uint32_t> (row * image.width));
  }
}

} // namespace

class LinkedRunsTest : public testing::TestWithParam<bool> {};

TEST_P (LinkedRunsTest, AreThoseFoundPointByPoint)
{
  LinkedRuns runs; // from images before, nothing stays
  for (const std::size_t width : {1u, 2u, 15u, 16u, 17u, 31u, 50u, 96u})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Image image (width, 20, seed);
      addRows (image, runs);
      if (GetParam())
        runs.bridge (static_cast<std::uint32_t> (width),
                     [&] (std::size_t before, std::size_t after) {
                       return image.isGap (before, after);
                     });
      const auto first = image.firstPoints (GetParam());
      std::size_t next = 0; // run
      for (std::size_t i = 0; i < image.inside.size(); ++i) {
        if (!image.inside[i] || image.isLinked (i))
          continue;
        std::size_t end = i + 1;
        while (end < image.inside.size() && image.isLinked (end))
          ++end;
        ASSERT_LT (next, runs.runs().size());
        const auto root = runs.root (static_cast<std::uint32_t> (next));
        EXPECT_EQ (runs.runs()[next].first, i) << width;
        EXPECT_EQ (runs.runs()[next].length, end - i) << width;
        EXPECT_EQ (runs.runs()[root].first, first[i]) << width;
        ++next;
      }
      EXPECT_EQ (runs.runs().size(), next);
    }
}

TEST (LinkedRuns, NothingWithoutPoints)
{
  LinkedRuns runs;
  runs.start (20);
  runs.addRow (0);
  EXPECT_TRUE (runs.runs().empty());
  EXPECT_EQ (pcl::rgbd_planes::pointsOf (runs.runs()), 0u);
}

INSTANTIATE_TEST_SUITE_P (BridgedOrNot, LinkedRunsTest, testing::Bool());
