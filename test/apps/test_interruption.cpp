// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/detection_comparison.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/apps/object_comparison.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/plane_comparison.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

using namespace pcl::rgbd_planes;

namespace {

const std::vector<std::uint32_t> steps{1};

/** A wall, and what is true about it. */
Frame
wall ()
{
  Frame frame;
  frame.name = "wall";
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (80, 60);
  frame.truth = pcl::make_shared<pcl::PointCloud<TruthPoint>> (80, 60);
  for (std::uint32_t v = 0; v < 60; ++v)
    for (std::uint32_t u = 0; u < 80; ++u) {
      const Eigen::Vector3f point (
          0.01f * static_cast<float> (u), 0.01f * static_cast<float> (v), 1.f);
      (*frame.cloud) (u, v).getVector3fMap() = point;
      (*frame.truth) (u, v).getVector3fMap() = point;
    }
  frame.camera_to_base = Eigen::Affine3f::Identity();
  return frame;
}

/** Ends the program: \a comparison gets a frame after a signal. */
template <typename Comparison>
void
addInterrupted (Comparison comparison)
{
  const Frame frame = wall();
  catchInterruption();
  std::raise (SIGINT);
  try {
    comparison.add (frame);
  }
  catch (const AppError& error) {
    std::cerr << error.what();
    std::exit (1);
  }
  std::exit (0);
}

/** Ends the program: one that does not listen gets a signal, and seconds later another one. */
void
sleepInterrupted ()
{
  catchInterruption();
  std::raise (SIGTERM);
  std::this_thread::sleep_for (std::chrono::seconds (4));
  std::raise (SIGINT);
  std::exit (0);
}

/** Ends the program: one that writes files gets the same signal again and again. */
void
writeInterrupted (const std::filesystem::path& file)
{
  catchInterruption();
  const int code = runApp ("app", [&] {
    OutputFiles files;
    files.write (file, "contents");
    for (const int signal : {SIGINT, SIGINT, SIGTERM, SIGTERM})
      std::raise (signal);
    stopIfInterrupted();
    files.commit();
  });
  std::exit (code);
}

} // namespace

TEST (Interruption, ImpatienceLeavesNoTemporaryFiles)
{
  const TemporaryFolder folder;
  EXPECT_EXIT (writeInterrupted (folder / "result.csv"),
               testing::ExitedWithCode (1),
               "app: interrupted; nothing was written");
  EXPECT_EQ (listFolder (folder.path()), std::vector<std::string>{});
}

TEST (Interruption, PatienceEnds)
{
  EXPECT_EXIT (sleepInterrupted(), testing::KilledBySignal (SIGINT), "");
}

TEST (Interruption, ComparisonsStopWithinAFrame)
{
  const auto stops = testing::ExitedWithCode (1);
  const auto radius = [] (float) { return 0.02f; };
  const DepthNoise noise = DepthNoise::kinectV1();
  EXPECT_EXIT (addInterrupted (NormalComparison (steps, radius)), stops, "interrupted");
  EXPECT_EXIT (addInterrupted (PlaneComparison (steps, {}, {})), stops, "interrupted");
  EXPECT_EXIT (
      addInterrupted (DetectionComparison (steps, noise)), stops, "interrupted");
  EXPECT_EXIT (addInterrupted (ObjectComparison (steps, noise)), stops, "interrupted");
}
