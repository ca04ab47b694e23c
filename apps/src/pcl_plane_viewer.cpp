// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/display.h>
#include <pcl/apps/frame_files.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/live_grabber.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/parse_number.h>
#include <pcl/apps/plane_viewer.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl::rgbd_planes;

namespace {

struct Options {
  InputOptions input;
  ViewerOptions viewer;
  /** Frames per second. */
  double rate;
  bool loop;
  std::optional<fs::path> screenshot;
};

const char usage[] =
    R"(pcl_plane_viewer INPUT [options]

Shows RGB-D frames with what is found in them: planes, normals, objects, obstacles and a
virtual laser scan. Recordings are played as fast as they were taken; frames for which
there is no time are left out, and counted. A window needs a display; a screenshot does
without one where the package xvfb is installed.

  pcl_plane_viewer sim:room
  pcl_plane_viewer folder_of_pcds --rate 10 --loop
  pcl_plane_viewer folder_of_pcds --corrected warp/warp.pcd
  pcl_plane_viewer sim:table_cluttered --show planes,objects --screenshot table.png

)";

po::options_description
describeOptions ()
{
  const auto text = [] (const char* name) {
    return po::value<std::string>()->value_name (name);
  };
  po::options_description options ("Options", help_width);
  addHelpOptions (options);
  options.add_options() (
      "show",
      text ("LAYERS")->default_value ("planes,contours,objects,scan"),
      "what to show at first: names from the list of keys, between commas, or none") (
      "screenshot",
      text ("FILE.png"),
      "write a picture of the first frame (of the last one of --frames N), 1024 x 768 "
      "pixels, PNG, and exit") (
      "output", text ("DIR")->default_value ("."), "where the key s saves") (
      "rate",
      text ("HZ")->default_value ("30"),
      "frames per second where the recording does not know its times") (
      "loop", "start again at the end") (
      "corrected",
      text ("frame|FILE"),
      "take points that DepthWarpCorrection corrects. The planes of each frame tell "
      "the error of depth, or FILE.pcd does, the warp.pcd that pcl_segment_planes "
      "wrote for this camera; the key w switches. Not with --depth-noise") (
      "base-transform", text ("x,y,z,roll,pitch,yaw"), base_transform_help);
  addDepthNoiseOption (options);
  return options.add (inputOptionsDescription());
}

double
parseRate (const std::string& text)
{
  const auto rate = parseNumber<double> ("--rate", text);
  if (!std::isfinite (rate) || rate < 0.01)
    throw AppError ("--rate: '" + text + "' must be 0.01 frames per second or more");
  return rate;
}

fs::path
readScreenshot (const fs::path& file)
{
  if (!hasExtension (file, ".png"))
    throw AppError ("--screenshot: '" + file.string() +
                    "' must end in .png, the format that is written");
  return file;
}

/** Nothing where only help or the version was asked for, which is printed. */
std::optional<Options>
readOptions (int argc, char** argv)
{
  const auto given =
      readCommandLine (argc,
                       argv,
                       describeOptions(),
                       "input",
                       1,
                       usage + inputHelp() + "\nKeys\n" + viewerKeysHelp());
  if (!given)
    return std::nullopt;
  const po::variables_map& values = *given;
  const auto value = [&] (const char* name) { return values[name].as<std::string>(); };
  Options options;
  options.input =
      readInputOptions (values["input"].as<std::vector<std::string>>().front(), values);
  options.viewer.step = std::exchange (options.input.step, 1);
  options.viewer.layers = parseLayers (value ("show"));
  options.viewer.output = value ("output");
  if (!values["output"].defaulted() && !values.count ("screenshot")) {
    // An unwritable place is known before the key s.
    OutputFiles files;
    files.createFolder (options.viewer.output);
    files.reserve (options.viewer.output / "FRAME_view.png");
  }
  options.rate = parseRate (value ("rate"));
  options.loop = values.count ("loop") != 0;
  if (values.count ("base-transform"))
    options.viewer.camera_to_base = parseBaseTransform (value ("base-transform"));
  options.viewer.depth_noise = readDepthNoise (values);
  options.viewer.corrected = readCorrected (values);
  if (options.viewer.corrected &&
      options.viewer.corrected->source == WarpSource::camera)
    throw AppError (
        "--corrected camera: the viewer shows frames as they come; give the warp.pcd "
        "that pcl_segment_planes writes with --corrected camera");
  if (values.count ("screenshot"))
    options.screenshot = readScreenshot (value ("screenshot"));
  return options;
}

void
takeScreenshot (const Options& options)
{
  InputOptions input = options.input;
  if (input.max_frames == InputOptions().max_frames)
    input.max_frames = 1;
  const FrameSource source (input);
  catchInterruption();
  {
    // An unwritable place is known before the work is done.
    OutputFiles files;
    files.protect (source.files());
    files.reserve (*options.screenshot);
  }
  provideDisplay();
  PlaneViewer viewer (options.viewer);
  for (std::size_t i = 0; i < source.size(); ++i) {
    viewer.show (source.read (i));
    stopIfInterrupted();
  }
  OutputFiles files;
  files.write (*options.screenshot, encodePng (viewer.window().picture()));
  files.commit();
}

void
playInput (const Options& options)
{
  ViewerOptions viewer_options = options.viewer;
  std::unique_ptr<pcl::Grabber> grabber;
  if (const auto device = liveDevice (options.input.input)) {
    grabber = openLiveGrabber (*device);
    viewer_options.max_frames = options.input.max_frames;
  }
  else {
    auto player =
        std::make_unique<FrameGrabber> (options.input, options.rate, options.loop);
    viewer_options.inputs = player->source().files();
    grabber = std::move (player);
  }
  catchInterruption();
  PlaneViewer viewer (viewer_options);
  viewer.play (*grabber);
  while (viewer.update() && !isInterrupted())
    ;
}

void
viewPlanes (int argc, char** argv)
{
  const auto options = readOptions (argc, argv);
  if (!options)
    return;
  if (options->screenshot)
    takeScreenshot (*options);
  else
    playInput (*options);
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_plane_viewer", [&] { viewPlanes (argc, argv); });
}
