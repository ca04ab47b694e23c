// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <hwy/targets.h>

#include <pcl/segmentation/impl/step_finder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

using pcl::rgbd_planes::GridLine;
using pcl::rgbd_planes::SampleError;
using pcl::rgbd_planes::StepFinder;

namespace {

constexpr int width = 100, height = 60;
constexpr std::size_t min_side = 25;

using Mask = std::function<bool (int, int)>;
using Error = std::function<float (int, int)>;

/** The samples of a mask, whose errors scatter by 0.5 standard deviations. */
std::vector<SampleError>
samplesOf (const Mask& is_own, const Error& error)
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0.f, 0.5f);
  std::vector<SampleError> samples;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      if (is_own (u, v))
        samples.push_back ({u,
                            v,
                            error (u, v) + noise (random),
                            static_cast<std::uint32_t> (samples.size())});
  return samples;
}

bool
isEdge (int, int v)
{
  return v >= 10 && v < 20;
}

constexpr double max_left = 0.95;

bool
isLeg (int u, int v)
{
  return v >= 20 && v < 50 && ((u >= 10 && u < 18) || (u >= 80 && u < 88));
}

bool
isTable (int u, int v)
{
  return isEdge (u, v) || isLeg (u, v);
}

/** A step of the given height, seen as a plane that is tilted between both sides. */
Error
tableWithStep (float step)
{
  return [=] (int u, int v) {
    return (isLeg (u, v) ? step : 0.f) - 0.03f * static_cast<float> (v - 20);
  };
}

bool
hasStep (const std::vector<SampleError>& samples, std::size_t least = min_side)
{
  GridLine step;
  return StepFinder().find (samples, least, step, max_left);
}

void
expectLegsParted (const std::vector<SampleError>& samples, const Mask& is_leg = isLeg)
{
  GridLine step;
  ASSERT_TRUE (StepFinder().find (samples, min_side, step, max_left));
  std::size_t wrong = 0;
  for (const SampleError& sample : samples)
    wrong += step.isBehind (sample.u, sample.v) != is_leg (sample.u, sample.v);
  EXPECT_LE (wrong, samples.size() / 50);
}

} // namespace

TEST (StepFinder, PartsBothLegsFromTheEdgeOfATable)
{
  expectLegsParted (samplesOf (isTable, tableWithStep (2.5f)));
}

TEST (StepFinder, PartsLegsFromAnEdgeTwoSamplesThin)
{
  const auto is_own = [] (int u, int v) {
    return (isEdge (u, v) && v >= 18) || isLeg (u, v);
  };
  expectLegsParted (
      samplesOf (is_own, [] (int u, int v) { return isLeg (u, v) ? 2.5f : 0.f; }));
}

TEST (StepFinder, PartsLegsFromASlantedEdgeTwoSamplesThin)
{
  const auto below = [] (int u, int v) {
    return static_cast<float> (v) - 0.35f * static_cast<float> (u) - 12.6f;
  };
  const auto isSlantedLeg = [&] (int u, int v) {
    return below (u, v) > 0.f && v < 50 && ((u >= 4 && u < 11) || (u >= 78 && u < 85));
  };
  const auto is_own = [&] (int u, int v) {
    return (std::abs (below (u, v) + 1.1f) < 1.1f && u < 88) || isSlantedLeg (u, v);
  };
  const auto error = [&] (int u, int v) {
    return (isSlantedLeg (u, v) ? 1.8f : 0.f) - 0.05f * below (u, v);
  };
  expectLegsParted (samplesOf (is_own, error), isSlantedLeg);
}

TEST (StepFinder, FindsStepsAtAnyAngle)
{
  for (const float slope : {-3.f, -1.f, -0.4f, 0.3f, 0.9f, 5.f}) {
    const auto isBehind = [slope] (int u, int v) {
      return static_cast<float> (v - 30) > slope * static_cast<float> (u - 50);
    };
    const auto samples =
        samplesOf ([] (int u, int v) { return u >= 30 && u < 70 && v >= 10 && v < 50; },
                   [&] (int u, int v) { return isBehind (u, v) ? 2.5f : 0.f; });
    GridLine step;
    ASSERT_TRUE (StepFinder().find (samples, min_side, step, max_left)) << slope;
    std::size_t same = 0;
    for (const SampleError& sample : samples)
      same += step.isBehind (sample.u, sample.v) == isBehind (sample.u, sample.v);
    // Which side is behind depends on the direction of the line.
    EXPECT_GE (std::max (same, samples.size() - same), samples.size() * 97 / 100)
        << slope;
  }
}

TEST (StepFinder, NoiseAndWarpAreNoSteps)
{
  const auto isWall = [] (int, int) { return true; };
  EXPECT_FALSE (hasStep (samplesOf (isWall, [] (int, int) { return 0.f; })));
  EXPECT_FALSE (hasStep (samplesOf (isTable, tableWithStep (0.f))));
  EXPECT_FALSE (hasStep (samplesOf (isWall, [] (int u, int v) {
    const float x = static_cast<float> (u - 50) / 50.f,
                y = static_cast<float> (v - 30) / 30.f;
    return 3.f * x * x - 2.f * y * y + x * y;
  })));
  EXPECT_FALSE (hasStep (samplesOf (isTable, tableWithStep (0.8f))));
}

TEST (StepFinder, SidesHaveEnoughSamples)
{
  const auto samples =
      samplesOf ([] (int u, int v) { return u >= 20 && u < 60 && v >= 10 && v < 50; },
                 [] (int u, int) { return u < 56 ? 0.f : 3.f; });
  EXPECT_TRUE (hasStep (samples, 160));
  EXPECT_FALSE (hasStep (samples, 320));
}

TEST (StepFinder, FewSamplesHaveNoStep)
{
  EXPECT_FALSE (hasStep ({}));
  EXPECT_FALSE (hasStep ({}, 0));
  const auto isPoint = [] (int u, int v) { return u == 0 && v == 0; };
  const auto isLine = [] (int, int v) { return v == height - 1; };
  const auto isBlock = [] (int u, int v) { return u >= 97 && v < 8; };
  const auto step = [] (int, int v) { return v < 4 ? 9.f : 0.f; };
  EXPECT_FALSE (hasStep (samplesOf (isPoint, step), 0));
  EXPECT_FALSE (hasStep (samplesOf (isLine, step), 0));
  EXPECT_FALSE (hasStep (samplesOf (isBlock, step), 0));
}

TEST (StepFinder, KeepsNothingOfThePlaneBefore)
{
  const auto table = samplesOf (isTable, tableWithStep (2.5f));
  const auto edge = samplesOf (isEdge, tableWithStep (0.f));
  StepFinder used;
  GridLine first, again;
  ASSERT_TRUE (used.find (table, min_side, first, max_left));
  EXPECT_FALSE (used.find (edge, min_side, again, max_left));
  ASSERT_TRUE (used.find (table, min_side, again, max_left));
  EXPECT_EQ (first.is_steep, again.is_steep);
  EXPECT_EQ (first.slope, again.slope);
  EXPECT_EQ (first.offset, again.offset);
}

TEST (StepFinder, FindsTheSameWithAnyInstructions)
{
  for (const int first : {0, 1, 5, 30}) { // leaves vectors that are not full
    auto samples = samplesOf (isTable, tableWithStep (2.5f));
    samples.erase (samples.begin(), samples.begin() + first);
    GridLine best, fallback;
    const bool is_found = StepFinder().find (samples, min_side, best, max_left);
    hwy::SetSupportedTargetsForTest (HWY_STATIC_TARGET);
    EXPECT_EQ (StepFinder().find (samples, min_side, fallback, max_left), is_found);
    hwy::SetSupportedTargetsForTest (0);
    EXPECT_TRUE (is_found);
    EXPECT_EQ (best.is_steep, fallback.is_steep);
    EXPECT_EQ (best.slope, fallback.slope);
    EXPECT_EQ (best.offset, fallback.offset);
  }
}
