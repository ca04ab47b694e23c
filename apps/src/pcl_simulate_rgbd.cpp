// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_truth.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/parse_number.h>
#include <pcl/apps/pictures.h>
#include <pcl/segmentation/impl/plane_extraction.h>
#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <iostream>
#include <optional>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl::rgbd_planes;

namespace {

struct Options {
  std::string scene;
  unsigned seed;
  std::optional<unsigned> camera;
  Sensor sensor;
  std::uint32_t step;
  fs::path output;
  std::optional<fs::path> json;
  /** The start of all file names. */
  std::string name;
};

Sensor
parseSensor (const std::string& text)
{
  if (text == "ideal")
    return Sensor::ideal;
  if (text == "kinect")
    return Sensor::kinect;
  if (text == "active_stereo")
    return Sensor::active_stereo;
  throw AppError ("--sensor: '" + text + "' must be ideal, kinect or active_stereo");
}

std::string
helpText ()
{
  return R"(pcl_simulate_rgbd SCENE --output DIR [options]

Renders a frame of an RGB-D camera and what is true about it. Writes, with NAME for
SCENE_SEED_SENSOR_RESOLUTION, or SCENE_SEED_CAMERA_... with --camera,
  NAME.pcd         the organized cloud, x y z rgb, in metres: z forward, y down
  NAME_truth.pcd   x y z and normal of what each pixel truly sees, the label of its plane
                   (0: none), its object (0: none), obstacle (1: not the floor), edge (1: near one)
  NAME_truth.json  where the camera, the planes and the objects are
  NAME_colour.png, NAME_depth.png and NAME_planes.png, pictures in colour
The other applications take NAME.pcd, and what is true about it with it, as sim:SCENE.

  pcl_simulate_rgbd room --output simulated
  pcl_simulate_rgbd table_cluttered --seed 7 --sensor ideal --resolution qvga --output simulated

SCENE is one of )" +
         boost::join (sceneNames(), " ") + '\n';
}

/** Nothing where only help or the version was asked for, which is printed. */
std::optional<Options>
readOptions (int argc, char** argv)
{
  const auto text = [] (const char* name) {
    return po::value<std::string>()->value_name (name);
  };
  po::options_description options ("Options", help_width);
  addHelpOptions (options);
  options.add_options() ("seed",
                         text ("S")->default_value ("1"),
                         "a whole number: another layout, viewpoint and noise") (
      "camera",
      text ("C"),
      "a whole number: frames with the same one share the smooth error of depth that a "
      "Kinect has; without it, each seed has its own; not for other sensors") (
      "sensor",
      text ("ideal|kinect|active_stereo")->default_value ("kinect"),
      "depth without errors, with those of Microsoft's first Kinect, or of a RealSense "
      "D4xx") ("resolution",
               text ("vga|qvga|qqvga")->default_value ("vga"),
               "take every 1st, 2nd or 4th pixel") (
      "output", text ("DIR"), "write the files there") (
      "json", text ("FILE"), "write NAME_truth.json to FILE, too");
  const auto given = readCommandLine (argc, argv, options, "scene", 1, helpText());
  if (!given)
    return std::nullopt;
  const po::variables_map& values = *given;
  if (!values.count ("output"))
    throw AppError ("no --output given; see --help");

  const auto value = [&] (const char* name) { return values[name].as<std::string>(); };
  const auto seed = parseNumber<unsigned> ("--seed", value ("seed"));
  std::optional<unsigned> camera;
  if (values.count ("camera"))
    camera = parseNumber<unsigned> ("--camera", value ("camera"));
  const Sensor sensor = parseSensor (value ("sensor"));
  if (camera && sensor != Sensor::kinect)
    throw AppError ("--camera: only --sensor kinect has a smooth error of depth; leave "
                    "out --camera");
  std::optional<fs::path> json;
  if (values.count ("json"))
    json = value ("json");
  const std::string scene = values["scene"].as<std::vector<std::string>>().front();
  return Options{scene,
                 seed,
                 camera,
                 sensor,
                 parseResolution (value ("resolution")),
                 value ("output"),
                 json,
                 scene + '_' + std::to_string (seed) +
                     (camera ? '_' + std::to_string (*camera) : std::string()) + '_' +
                     value ("sensor") + '_' + value ("resolution")};
}

/** The true planes, numbered as a segmentation does. */
pcl::PointCloud<pcl::Label>
planeLabels (const pcl::PointCloud<TruthPoint>& truth)
{
  pcl::PointCloud<pcl::Label> labels (truth.width, truth.height);
  for (std::size_t i = 0; i < truth.size(); ++i)
    labels[i].label = truth[i].label == 0 ? unlabelled : truth[i].label - 1;
  return labels;
}

void
simulateRgbd (int argc, char** argv)
{
  const auto options = readOptions (argc, argv);
  if (!options)
    return;
  catchInterruption();
  OutputFiles files;
  // An unwritable place is known before the work is done.
  files.createFolder (options->output);
  const auto frame =
      simulate (options->scene, options->seed, options->sensor, options->camera);
  stopIfInterrupted();
  const auto cloud = subsample (*frame.cloud, options->step);
  const auto truth = subsample (*frame.truth, options->step);
  const auto write = [&] (const char* ending, const std::string& contents) {
    files.write (options->output / (options->name + ending), contents);
  };
  write (".pcd", encodePcd (cloud));
  write ("_truth.pcd", encodePcd (truth));
  const std::string scene_truth = encodeSceneTruth (frame);
  write ("_truth.json", scene_truth);
  if (options->json)
    files.write (*options->json, scene_truth);
  write ("_colour.png", encodePng (colourPicture (cloud)));
  write ("_depth.png", encodePng (depthPicture (cloud)));
  write ("_planes.png", encodePng (planesPicture (cloud, planeLabels (truth))));
  stopIfInterrupted();
  files.commit();
  std::cout
      << "Wrote " << (options->output / options->name).string()
      << ".pcd, _truth.pcd, _truth.json, _colour.png, _depth.png and _planes.png\n";
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_simulate_rgbd", [&] { simulateRgbd (argc, argv); });
}
