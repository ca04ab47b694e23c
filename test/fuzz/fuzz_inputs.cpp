// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// What a user types: the options of an INPUT, names of inputs, and the list of a TUM RGB-D
// folder with the frames in it.

#include "scratch_file.h"
#include <fuzzer/FuzzedDataProvider.h>

#include <pcl/apps/command_line.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/input_options.h>

#include <boost/program_options/value_semantic.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl::rgbd_planes;

namespace {

InputOptions
parse (const std::string& input, FuzzedDataProvider& data)
{
  po::options_description options;
  options.add (inputOptionsDescription());
  std::vector<std::string> words{"app"};
  while (data.remaining_bytes() > 0 && words.size() < 10)
    words.push_back (
        data.PickValueInArray<std::string> (
            {"", "--intrinsics=", "--depth-scale=", "--resolution=", "--frames="}) +
        data.ConsumeRandomLengthString (60).c_str());
  std::vector<char*> arguments;
  for (auto& word : words)
    arguments.push_back (word.data());
  const auto values = parseCommandLine (
      static_cast<int> (arguments.size()), arguments.data(), options, "input", -1);
  InputOptions result = readInputOptions (input, values);
  const auto positive = [] (float x) { return x > 0.f && std::isfinite (x); };
  if ((result.intrinsics &&
       !(positive (result.intrinsics->fx) && positive (result.intrinsics->fy))) ||
      (result.units_per_metre && !positive (*result.units_per_metre)) ||
      result.max_frames == 0)
    std::abort();
  return result;
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* bytes, std::size_t size)
{
  static const fs::path folder = fuzz::scratchFolder ("tum");
  FuzzedDataProvider data (bytes, size);
  const auto kind = data.ConsumeIntegralInRange (0, 3);
  std::string text = data.ConsumeRandomLengthString (300);
  if (kind < 3)
    text = text.c_str(); // no argument goes beyond a zero
  fuzz::mayBeRefused ([&] {
    switch (kind) {
    case 0:
      FrameSource (parse ("sim:" + text, data));
      break;
    case 1:
      if (!parseBaseTransform (text).matrix().allFinite())
        std::abort();
      break;
    case 2:
      FrameSource (parse (text, data));
      break;
    default:
      std::ofstream (folder / "depth.txt") << text;
      FrameSource (parse (folder, data)).read (0);
    }
  });
  return 0;
}
