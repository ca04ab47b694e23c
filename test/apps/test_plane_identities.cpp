// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/apps/fit_camera.h>
#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/statistics.h>
#include <pcl/segmentation/plane_tracker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

using namespace pcl::rgbd_planes;

namespace {

/** From the camera of one frame to that of the next. */
using Motion = Eigen::Isometry3f;

struct Segmented {
  std::string name;
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud;
  pcl::PointCloud<pcl::Label> labels;
  /** Number of pixels and identity of each plane. */
  std::vector<std::size_t> pixels;
  std::vector<std::uint32_t> ids;
};

std::vector<Segmented>
segmentAndTrack (const InputOptions& input)
{
  const FrameSource source (input);
  FrameSegmenter segmenter{SegmenterOptions{}};
  pcl::PlaneTracker tracker;
  std::vector<Segmented> sequence;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Frame frame = source.read (i);
    const FrameSummary summary = segmenter.segment (frame);
    Segmented segmented{frame.name, frame.cloud, segmenter.labels(), {}, {}};
    for (const auto& plane : summary.planes)
      segmented.pixels.push_back (plane.points);
    tracker.track (segmenter.models(), segmented.labels, segmented.ids);
    sequence.push_back (std::move (segmented));
  }
  return sequence;
}

/** The pixel of \a b that shows point \a i of \a a, or -1 where it is out of view or
 * something else is in front of it. Without a known motion, the same pixel. */
std::ptrdiff_t
pixelInNext (const Segmented& a,
             std::size_t i,
             const Segmented& b,
             const Intrinsics& camera,
             const std::optional<Motion>& motion)
{
  if (!motion)
    return static_cast<std::ptrdiff_t> (i);
  const Eigen::Vector3f p = *motion * (*a.cloud)[i].getVector3fMap();
  const auto u = std::lround (camera.fx * p.x() / p.z() + camera.cx);
  const auto v = std::lround (camera.fy * p.y() / p.z() + camera.cy);
  if (u < 0 || v < 0 || u >= b.cloud->width || v >= b.cloud->height)
    return -1;
  const float noise = 0.02f + 0.01f * p.z() * p.z();
  const auto j = v * b.cloud->width + u;
  return std::fabs ((*b.cloud)[static_cast<std::size_t> (j)].z - p.z()) < noise ? j
                                                                                : -1;
}

/** How many points of each plane of \a a, in rows, lie on each plane of \a b. */
std::vector<std::vector<std::size_t>>
sharedPoints (const Segmented& a,
              const Segmented& b,
              const std::optional<Motion>& motion)
{
  const Intrinsics camera = fitCamera (*b.cloud);
  std::vector<std::vector<std::size_t>> shared (
      a.pixels.size(), std::vector<std::size_t> (b.pixels.size()));
  for (std::size_t i = 0; i < a.labels.size(); ++i) {
    const auto j =
        a.labels[i].label == unlabelled ? -1 : pixelInNext (a, i, b, camera, motion);
    if (j >= 0 && b.labels[static_cast<std::size_t> (j)].label != unlabelled)
      ++shared[a.labels[i].label][b.labels[static_cast<std::size_t> (j)].label];
  }
  return shared;
}

struct Switches {
  std::size_t large = 0;    /**< planes over 5 % of the image */
  std::size_t seen = 0;     /**< those that the next frame shows as well */
  std::size_t switched = 0; /**< those whose identity is another one there */

  /** Plane p is seen again as plane q of the next frame if most of the points of either
   * that both frames show on planes are of the other. */
  void
  add (const Segmented& a, const Segmented& b, const std::optional<Motion>& motion)
  {
    const auto shared = sharedPoints (a, b, motion);
    for (std::size_t p = 0; p < a.pixels.size(); ++p) {
      if (a.pixels[p] * 20 <= a.labels.size())
        continue;
      ++large;
      const auto of_p =
          std::accumulate (shared[p].begin(), shared[p].end(), std::size_t{0});
      for (std::size_t q = 0; q < b.pixels.size(); ++q) {
        std::size_t of_q = 0;
        for (const auto& row : shared)
          of_q += row[q];
        if (2 * shared[p][q] > std::max (of_p, of_q)) {
          ++seen;
          switched += a.ids[p] != b.ids[q];
        }
      }
    }
  }
};

void
expectFewSwitches (const std::vector<Segmented>& sequence,
                   const std::vector<std::optional<Motion>>& motions)
{
  Switches switches;
  for (std::size_t k = 0; k + 1 < sequence.size(); ++k)
    switches.add (sequence[k], sequence[k + 1], motions[k]);
  std::printf (
      "%zu planes over 5 %% of the image, %zu of them in the next frame as well, "
      "%zu with another identity (%.1f %%)\n",
      switches.large,
      switches.seen,
      switches.switched,
      percentOf (switches.switched, switches.seen));
  EXPECT_GE (switches.seen, 50u);
  EXPECT_GE (10 * switches.seen, 9 * switches.large) << "too few to judge by";
  EXPECT_LE (50 * switches.switched, switches.seen);
  for (const auto& frame : sequence) {
    const std::set<std::uint32_t> different (frame.ids.begin(), frame.ids.end());
    EXPECT_EQ (different.size(), frame.ids.size()) << "frame " << frame.name;
  }
}

/** How the camera moves after each frame of a TUM recording, from its ground truth: the
 * poses nearest in time. */
std::vector<std::optional<Motion>>
readMotions (const std::string& file, const std::vector<Segmented>& sequence)
{
  std::vector<std::pair<double, Motion>> poses;
  std::ifstream stream (file);
  for (std::string line; std::getline (stream, line);) {
    std::istringstream words (line);
    double time;
    Eigen::Vector3f t;
    Eigen::Quaternionf q;
    if (words >> time >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w())
      poses.push_back ({time, Eigen::Translation3f (t) * q.normalized()});
  }
  const auto at = [&] (const Segmented& frame) {
    const double time = std::stod (frame.name);
    return std::min_element (poses.begin(),
                             poses.end(),
                             [&] (const auto& a, const auto& b) {
                               return std::fabs (a.first - time) <
                                      std::fabs (b.first - time);
                             })
        ->second;
  };
  std::vector<std::optional<Motion>> motions;
  for (std::size_t k = 0; k + 1 < sequence.size(); ++k)
    motions.push_back (at (sequence[k + 1]).inverse() * at (sequence[k]));
  return motions;
}

} // namespace

TEST (PlaneIdentities, StayInARecordingWithPoses)
{
  SKIP_WITHOUT_RECORDINGS();
  InputOptions input;
  input.input = synthetic::dataFolder() + "/tum_fr3_structure_notexture_far";
  const auto sequence = segmentAndTrack (input);
  expectFewSwitches (sequence,
                     readMotions (input.input + "/groundtruth.txt", sequence));
}

TEST (PlaneIdentities, AFarBoardThatTheCameraBendsIsInEachFrame)
{
  SKIP_WITHOUT_RECORDINGS();
  InputOptions input;
  input.input = synthetic::dataFolder() + "/tum_fr3_structure_notexture_far";
  for (const Segmented& frame : segmentAndTrack (input)) {
    std::map<std::uint32_t, std::size_t> pixels;
    for (std::uint32_t v = 50; v < 200; ++v)
      for (std::uint32_t u = 520; u < 600; ++u)
        ++pixels[frame.labels (u, v).label];
    pixels.erase (unlabelled);
    std::size_t most = 0;
    for (const auto& plane : pixels)
      most = std::max (most, plane.second);
    EXPECT_GT (most, 150u * 80u * 3 / 4) << frame.name;
  }
}

TEST (PlaneIdentities, StayInACorridor)
{
  SKIP_WITHOUT_RECORDINGS();
  InputOptions input;
  input.input = synthetic::dataFolder() + "/icsl_corridor/depth";
  input.intrinsics = Intrinsics{537.60f, 539.03f, 316.15f, 245.52f};
  input.units_per_metre = 1000.f;
  const auto sequence = segmentAndTrack (input);
  expectFewSwitches (
      sequence, std::vector<std::optional<Motion>> (sequence.size(), std::nullopt));
}
