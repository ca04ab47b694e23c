// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/plane_comparison.h>
#include <pcl/apps/plane_comparison_table.h>

#include <boost/program_options/value_semantic.hpp>

#include <string>

namespace po = boost::program_options;

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    R"(pcl_evaluate_planes INPUT... [options]

Compares our planes and those of PCL's OrganizedMultiPlaneSegmentation, with its defaults
and tuned (6 degrees, 5 cm, curvature 0.01), with true ones after Hoover et al. (1996) at
80 % overlap. There are true ones where the input is simulated, or a .pcd file with plane
labels as in SynPEB (field intensity: whole numbers, each that of the points of one plane).
All frames of all inputs count together; without --resolution, each of the three is tried.
Times are of one thread, include the normals, and are the fastest of three runs of a frame;
worst is the slowest frame. Labelled points further than 5 mm + 4 mm z^2 from their plane
are off.

Of .pcd files with objects (field label, as in mOSD) a second table tells how well the
table is found: IoU of its points and the best plane, mean and worst frame; purity: points
that belong to what most points of their plane belong to, the table or one object. Of
simulated frames it tells the share of the points on curved surfaces, such as cylinders and
cups, that carry the label of a plane (curved), and the label of a plane that has most of
its points on such surfaces (shattered).

Of simulated frames a third table tells what the correction of depth by ProjectOntoPlanes
gains: the rms distance to the true planes of all their points at 3.5 to 6 m, away from
edges: as measured, moved along their rays, along the normals, and along their rays onto
planes that least squares fits to the true labels (fit). It also tells how far angles
between walls, vertical true planes of 2 % of the pixels and more in pairs at 30 degrees and
more, are from the true ones: angles between the planes with at least half of their points
(inf: not found), and those of the fits.

With --corrected there is another row: ours on corrected points.

  pcl_evaluate_planes sim:room:{1..10} --json planes.json --corrected frame
  pcl_evaluate_planes folder_of_pcds --right-angles floor
)";

std::optional<RightAngles::Pairs>
readRightAngles (const po::variables_map& values)
{
  if (!values.count ("right-angles"))
    return std::nullopt;
  const auto& pairs = values["right-angles"].as<std::string>();
  if (pairs == "all")
    return RightAngles::Pairs::all;
  if (pairs == "floor")
    return RightAngles::Pairs::with_floor;
  throw AppError ("--right-angles: '" + pairs + "' must be all or floor");
}

void
evaluatePlanes (int argc, char** argv)
{
  po::options_description own ("Planes", help_width);
  own.add_options() ("spherical-grid",
                     "ours once more, with cells of spherical coordinates for the "
                     "normals (section 4.1 of the paper) instead of voxels") (
      "kept-settings",
      "ours once more, with the smoothing size and thresholds of pcl_omps, as in a "
      "program of which nothing but the names of classes changed") (
      "without",
      po::value<std::vector<std::string>>()->value_name ("NAME,..."),
      ("ours once more, without these additions to the two stages of the paper: " +
       planeAdditionNames() + ", or all; may be given several times")
          .c_str()) (
      "pictures",
      po::value<std::string>()->value_name ("DIR"),
      "write there the planes of each frame as FRAME_METHOD_RESOLUTION.png: each in a "
      "colour of its own, grey where there is none, black without depth; no two frames "
      "may share a name") (
      "right-angles",
      po::value<std::string>()->value_name ("all|floor"),
      "the scene is right-angled: how far planes with 2 % of the pixels and more are "
      "from 90 degrees, in pairs within 20 degrees of that, or only those with the "
      "floor, the lowest plane of the image");
  addCorrectedOption (own);
  addDepthNoiseOption (own);
  const auto command = readEvaluationCommand (argc, argv, usage, own);
  if (!command)
    return;
  const po::variables_map& values = command->values;
  PlaneMethodOptions options;
  options.spherical_grid = values.count ("spherical-grid") > 0;
  options.kept_settings = values.count ("kept-settings") > 0;
  if (values.count ("without"))
    options.without = values["without"].as<std::vector<std::string>>();
  options.corrected = readCorrected (values);
  options.noise = readDepthNoise (values);
  PlaneComparison comparison (command->steps, readRightAngles (values), options);
  std::size_t frames = 0, with_truth = 0;
  runEvaluation (
      *command,
      [&] (const Frame& frame, OutputFiles& files) {
        ++frames;
        with_truth += frame.truth || frame.labels.kind != PointLabels::Kind::none;
        comparison.add (frame);
        if (command->pictures)
          comparison.writePictures (frame, *command->pictures, files);
      },
      [&] { return planeComparisonTable (comparison.results()); },
      [&] { return planeComparisonJson (comparison.results()); },
      comparison.calibration());
  if (with_truth == 0)
    printNotice ("no truth in this input: only times, coverage and what is off are "
                 "measured");
  else if (with_truth < frames)
    printNotice (std::to_string (frames - with_truth) + " of " +
                 std::to_string (frames) +
                 " frames have no truth: their planes count as found, but are neither "
                 "correct nor noise; evaluate them apart");
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_planes", [&] { evaluatePlanes (argc, argv); });
}
