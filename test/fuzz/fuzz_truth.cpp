// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// The readers of what is true about a simulated frame: the file of the scene, or that of the
// pixels beside a good one of the scene.

#include "scratch_file.h"

#include <pcl/apps/frame_truth.h>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using namespace pcl::rgbd_planes;

namespace {

void
write (const fs::path& file, const std::string& bytes)
{
  std::ofstream (file, std::ios::binary) << bytes;
}

const std::string pixels =
    "VERSION 0.7\n"
    "FIELDS x y z normal_x normal_y normal_z label object obstacle edge\n"
    "SIZE 4 4 4 4 4 4 4 4 4 4\n"
    "TYPE F F F F F F U U U U\n"
    "COUNT 1 1 1 1 1 1 1 1 1 1\n"
    "WIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n"
    "0 0 1 0 0 -1 1 0 1 0\n"
    "1 0 1 0 0 -1 1 1 1 1\n"
    "0 1 1 0 0 -1 0 2 0 0\n"
    "nan nan nan nan nan nan 0 0 1 0\n";

} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* bytes, std::size_t size)
{
  static const fs::path file = fuzz::scratchFolder ("truth") / "frame.pcd";
  static const auto good_scene = [] {
    SimulatedFrame frame;
    frame.camera_to_base = Eigen::Affine3f::Identity();
    frame.planes.push_back ({0.f, 0.f, -1.f, 1.f});
    frame.objects.emplace_back();
    return encodeSceneTruth (frame);
  }();
  const std::string text (reinterpret_cast<const char*> (bytes), size);
  const bool is_scene = text.find ("FIELDS") == std::string::npos;
  const fs::path start = file.parent_path() / "frame_truth";
  write (start.string() + ".json", is_scene ? text : good_scene);
  write (start.string() + ".pcd", is_scene ? pixels : text);
  fuzz::mayBeRefused ([&] {
    Frame frame;
    frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (2, 2);
    readTruth (file, frame);
    if (!frame.truth || frame.truth->size() != frame.cloud->size() ||
        !frame.camera_to_base)
      std::abort();
    for (const TruthPoint& point : *frame.truth)
      if (point.label > frame.true_planes.size())
        std::abort();
  });
  return 0;
}
