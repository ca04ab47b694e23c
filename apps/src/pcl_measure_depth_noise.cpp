// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/apps/quiet_pcl.h>
#include <pcl/segmentation/depth_noise_estimation.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    R"(pcl_measure_depth_noise INPUT... [options]

Measures the noise of a depth camera on frames of any indoor scene, by DepthNoiseEstimation:
all inputs are of one camera. Prints what small blocks of the image leave of planes at each
range and the noise that fits it, twice as large for the sake of large surfaces, as the option
--depth-noise of the other applications takes it. The third number says how many times as far
as with a Kinect v1 normals scatter: 1, or 2 to 3 for stereo cameras. Surfaces should be seen at
all ranges that matter; some ten frames are enough.

  pcl_measure_depth_noise recordings/
)";

/** From the first range to the last one, so that both parts of the noise are told. */
constexpr float told_range = 1.5f;

DepthNoise
estimate (const pcl::DepthNoiseEstimation& estimation)
{
  DepthNoise noise;
  const QuietPcl quiet;
  if (!estimation.estimate (noise))
    throw AppError (
        "no smooth surfaces in any frame, or fewer than 20 pieces of them at one "
        "range; give frames that see floor, walls or tables, in metres, and more of "
        "small images");
  return noise;
}

std::string
noiseTable (const pcl::DepthNoiseEstimation& estimation)
{
  const DepthNoise noise = estimate (estimation);
  std::ostringstream table;
  table << std::fixed << "range m   blocks  noise mm  twice that, fitted\n";
  const auto levels = estimation.getLevels();
  for (const auto& level : levels)
    table << std::setw (7) << std::setprecision (2) << level.range << std::setw (9)
          << level.blocks << std::setw (10) << 1000.f * level.sigma << std::setw (20)
          << 1000.f * noise.sigmaAtSquare (level.range * level.range) << '\n';
  table << std::setprecision (5) << "--depth-noise " << noise.constant << ','
        << noise.quadratic << ',' << std::setprecision (1) << noise.normal_scatter
        << '\n';
  if (levels.back().range < told_range * levels.front().range)
    table << "Surfaces are seen at these ranges only; frames that see nearer or "
             "farther ones tell the noise there.\n";
  return table.str();
}

std::string
noiseJson (const pcl::DepthNoiseEstimation& estimation)
{
  const DepthNoise noise = estimate (estimation);
  nlohmann::ordered_json json = {{"constant", noise.constant},
                                 {"quadratic", noise.quadratic},
                                 {"normal_scatter", noise.normal_scatter},
                                 {"levels", nlohmann::ordered_json::array()}};
  for (const auto& level : estimation.getLevels())
    json["levels"].push_back (
        {{"range_m", level.range}, {"blocks", level.blocks}, {"sigma_m", level.sigma}});
  return json.dump (2) + '\n';
}

void
measureDepthNoise (int argc, char** argv)
{
  const auto command = readEvaluationCommand (argc, argv, usage, {});
  if (!command)
    return;
  const std::uint32_t step = command->steps.size() == 1 ? command->steps.front() : 1;
  pcl::DepthNoiseEstimation estimation;
  runEvaluation (
      *command,
      [&] (const Frame& frame, OutputFiles&) {
        estimation.addFrame (*measuredCloud (frame, step, 2));
      },
      [&] { return noiseTable (estimation); },
      [&] { return noiseJson (estimation); });
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_measure_depth_noise", [&] { measureDepthNoise (argc, argv); });
}
