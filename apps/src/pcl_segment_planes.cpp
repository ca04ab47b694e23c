// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/depth_correction.h>
#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/input_notices.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/labelled_point.h>
#include <pcl/apps/object_pictures.h>
#include <pcl/apps/obstacle_pictures.h>
#include <pcl/apps/obstacle_report.h>
#include <pcl/apps/output_files.h>
#include <pcl/apps/pictures.h>
#include <pcl/apps/plane_report.h>
#include <pcl/apps/progress.h>

#include <boost/program_options.hpp>

#include <iostream>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl::rgbd_planes;

namespace {

struct Options {
  InputOptions input;
  SegmenterOptions segmenter;
  std::optional<fs::path> output;
  std::optional<fs::path> json;
  std::optional<CorrectedOption> corrected;
};

const char usage[] =
    R"(pcl_segment_planes INPUT [options]

Finds the planes of RGB-D frames, objects on them, and obstacles. Prints a list of them and
the time of each stage, with memory in place: the first frame is computed twice. Writes
pictures, clouds and tables where --output says so. Files appear when all frames are done,
before the list is printed; after an error until then there are no new ones.

  pcl_segment_planes my.pcd --output result
  pcl_segment_planes depth.png --intrinsics 525,525,319.5,239.5 --depth-scale 1000
  pcl_segment_planes sim:table_single:7 --resolution qvga --objects --obstacles
  pcl_segment_planes recording --corrected camera --output warp
  pcl_segment_planes my.pcd --corrected warp/warp.pcd --output result

)";

po::options_description
describeOptions ()
{
  po::options_description options ("Options", help_width);
  addHelpOptions (options);
  options.add_options() (
      "min-inliers",
      po::value<std::string>()->value_name ("N"),
      "drop planes with fewer points; by default 1000 for 640 x 480 pixels and in "
      "proportion for other sizes") ("objects",
                                     "find objects on horizontal planes up to 1.2 m "
                                     "high: things with at least 40 points "
                                     "at 640 x 480 pixels, 20 at 320 x 240 and less") (
      "obstacles",
      "find what a robot must not drive into, and write a virtual laser scan of it") (
      "base-transform",
      po::value<std::string>()->value_name ("x,y,z,roll,pitch,yaw"),
      base_transform_help) (
      "output",
      po::value<std::string>()->value_name ("DIR"),
      "write there, for each frame, FRAME_planes.png, FRAME_normals.png, "
      "FRAME_depth.png and FRAME_labels.pcd (x y z normal label), with --objects "
      "FRAME_objects.png, with --obstacles FRAME_obstacles.png and FRAME_scan.csv; for "
      "all frames planes.csv, "
      "objects.csv, obstacles.csv and result.json; with --corrected camera warp.pcd, "
      "the error of depth for later runs, and warp.png. Planes and objects have "
      "colours of their own; boxes are white, of what is not graspable red; floor is "
      "green, obstacles red to yellow, drop-offs blue to magenta, specks white; black "
      "is no depth, or beyond the range of the sensor") (
      "json",
      po::value<std::string>()->value_name ("FILE"),
      "write the result as JSON");
  addDepthNoiseOption (options);
  addCorrectedOption (options);
  options.add (inputOptionsDescription());
  return options;
}

/** Nothing where only help or the version was asked for, which is printed. */
std::optional<Options>
readOptions (int argc, char** argv)
{
  const auto given =
      readCommandLine (argc, argv, describeOptions(), "input", 1, usage + inputHelp());
  if (!given)
    return std::nullopt;
  const po::variables_map& values = *given;
  Options result;
  result.input =
      readInputOptions (values["input"].as<std::vector<std::string>>().front(), values);
  if (values.count ("min-inliers"))
    result.segmenter.min_inliers =
        parseCount ("--min-inliers", values["min-inliers"].as<std::string>());
  result.segmenter.find_objects = values.count ("objects") != 0;
  result.segmenter.find_obstacles = values.count ("obstacles") != 0;
  if (values.count ("base-transform"))
    result.segmenter.camera_to_base =
        parseBaseTransform (values["base-transform"].as<std::string>());
  if (values.count ("output"))
    result.output = values["output"].as<std::string>();
  if (values.count ("json"))
    result.json = values["json"].as<std::string>();
  result.segmenter.depth_noise = readDepthNoise (values);
  result.corrected = readCorrected (values);
  result.segmenter.corrected_points = result.corrected.has_value();
  return result;
}

/** These files appear last. */
void
prepareOutput (const Options& options, const FrameSource& source, OutputFiles& files)
{
  if (options.output) {
    refuseInputFolder (source.folders(), *options.output);
    files.createFolder (*options.output);
    files.reserve (*options.output / "result.json");
    files.reserve (*options.output / "planes.csv");
    if (options.segmenter.find_objects)
      files.reserve (*options.output / "objects.csv");
    if (options.segmenter.find_obstacles)
      files.reserve (*options.output / "obstacles.csv");
  }
  if (options.json)
    files.reserve (*options.json);
}

void
writeFrame (const Options& options,
            const Frame& frame,
            const FrameSegmenter& segmenter,
            const FrameSummary& summary,
            OutputFiles& files)
{
  const auto& labels = segmenter.labels();
  const auto write = [&] (const char* ending, const std::string& contents) {
    files.write (*options.output / (frame.name + ending), contents);
  };
  write ("_planes.png", encodePng (planesPicture (*frame.cloud, labels)));
  write ("_normals.png", encodePng (normalsPicture (segmenter.normals())));
  write ("_depth.png", encodePng (depthPicture (*frame.cloud)));
  if (options.segmenter.find_objects)
    write ("_objects.png",
           encodePng (objectsPicture (
               *frame.cloud, summary.objects, segmenter.supportPlanes())));
  if (options.segmenter.find_obstacles) {
    write ("_obstacles.png",
           encodePng (obstaclesPicture (
               *frame.cloud, segmenter.obstacleClasses(), summary.obstacles)));
    write ("_scan.csv", scanCsv (summary.scan));
  }
  write ("_labels.pcd", encodeLabels (*frame.cloud, segmenter.normals(), labels));
}

std::vector<FrameSummary>
segmentFrames (const std::vector<FrameSource>& source,
               const Options& options,
               InputNotices& notices,
               OutputFiles& files)
{
  FrameSegmenter segmenter (options.segmenter);
  std::optional<DepthCorrection> correction;
  if (options.corrected)
    correction.emplace (*options.corrected);
  const auto min_inliers = [&] (const Frame& frame) {
    return minInliers (options.segmenter, frame.cloud->size());
  };
  if (correction)
    for (const auto& calibrate : correction->calibration())
      forEachFrame (source, [&] (const Frame& frame) {
        calibrate (coordinates (frame), min_inliers (frame));
      });
  std::vector<FrameSummary> summaries;
  forEachFrame (source, [&] (const Frame& measured) {
    const Frame frame =
        correction ? correction->correct (measured, min_inliers (measured)) : measured;
    summaries.push_back (segmenter.segment (frame));
    notices.add (measured, summaries.back());
    if (options.output)
      writeFrame (options, frame, segmenter, summaries.back(), files);
    summaries.back().freeIndices();
  });
  if (options.output && options.corrected &&
      options.corrected->source == WarpSource::camera) {
    files.write (*options.output / "warp.pcd", encodePcd (correction->warp()));
    files.write (*options.output / "warp.png",
                 encodePng (warpPicture (correction->warp())));
    notices.addWarp (correction->warp());
  }
  return summaries;
}

void
segmentPlanes (int argc, char** argv)
{
  const auto options = readOptions (argc, argv);
  if (!options)
    return;
  std::vector<FrameSource> source;
  source.emplace_back (options->input);
  catchInterruption();
  OutputFiles files;
  files.protect (source.front().files());
  if (options->corrected) {
    files.protect ({options->corrected->file});
    if (options->corrected->source == WarpSource::camera)
      source.front().refusePipes();
  }
  prepareOutput (*options, source.front(), files);

  InputNotices notices (options->segmenter);
  const auto summaries = segmentFrames (source, *options, notices, files);

  const std::string json = resultJson (source.front().options(), summaries);
  if (options->output) {
    files.write (*options->output / "result.json", json);
    files.write (*options->output / "planes.csv", planesCsv (summaries));
    if (options->segmenter.find_objects)
      files.write (*options->output / "objects.csv", objectsCsv (summaries));
    if (options->segmenter.find_obstacles)
      files.write (*options->output / "obstacles.csv", obstaclesCsv (summaries));
  }
  if (options->json)
    files.write (*options->json, json);
  files.commit();
  for (const auto& summary : summaries) {
    printPlanes (std::cout, summary);
    if (options->segmenter.find_objects)
      printObjects (std::cout, summary);
    if (options->segmenter.find_obstacles)
      printObstacles (std::cout, summary);
  }
  printStageTimes (std::cout, summaries);
  flushOutput();
  for (const auto& line : notices.lines())
    printNotice (line);
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_segment_planes", [&] { segmentPlanes (argc, argv); });
}
