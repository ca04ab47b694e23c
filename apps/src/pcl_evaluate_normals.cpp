// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_source.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/apps/normal_report.h>
#include <pcl/apps/output_files.h>

#include <boost/program_options.hpp>

#include <iostream>

namespace fs = std::filesystem;
namespace po = boost::program_options;
using namespace pcl::rgbd_planes;

namespace {

struct Options {
  std::vector<InputOptions> inputs;
  std::vector<std::uint32_t> steps{1, 2, 4};
  bool far_reference = false;
  std::optional<fs::path> json;
};

const char usage[] = "pcl_evaluate_normals INPUT... [options]\n\n"
                     "Compares the normals of our method, of PCL and of OpenCV with "
                     "true ones where the\n"
                     "input is simulated, and elsewhere with two-run principal "
                     "component analysis of the\n"
                     "full image. All frames of all inputs count together; without "
                     "--resolution, each of\n"
                     "the three is tried. Times are of one thread.\n\n";

po::variables_map
parseCommandLine (int argc, char** argv, const po::options_description& options)
{
  po::options_description all;
  all.add (options).add_options() ("input", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add ("input", -1);
  po::variables_map values;
  try {
    po::store (po::command_line_parser (argc, argv)
                   .options (all)
                   .positional (positional)
                   .run(),
               values);
  }
  catch (const po::error& error) {
    throw AppError (std::string (error.what()) + "; see --help");
  }
  return values;
}

/** Nothing where only help was asked for, which is printed. */
std::optional<Options>
readOptions (int argc, char** argv)
{
  po::options_description options ("Options");
  options.add_options() ("help", "print this help") (
      "far-reference",
      "let the radius of the reference grow as max (0.01 m + 0.01 z, 0.0085 z^2 / m) "
      "instead of 0.01 m + 0.01 z: for scenes beyond 2.5 m") (
      "json", po::value<std::string>()->value_name ("FILE"), "write the table as JSON");
  options.add (inputOptionsDescription());
  const po::variables_map values = parseCommandLine (argc, argv, options);
  if (values.count ("help")) {
    std::cout << usage << input_help << '\n' << options;
    return std::nullopt;
  }
  if (!values.count ("input"))
    throw AppError ("no INPUT given; see --help");

  Options result;
  for (const auto& input : values["input"].as<std::vector<std::string>>()) {
    result.inputs.push_back (readInputOptions (input, values));
    if (!values["resolution"].defaulted())
      result.steps = {result.inputs.back().step};
    result.inputs.back().step = 1;
  }
  result.far_reference = values.count ("far-reference") > 0;
  if (values.count ("json"))
    result.json = values["json"].as<std::string>();
  return result;
}

void
showProgress (std::size_t done, std::size_t all)
{
  if (all > 1 && ::isatty (STDERR_FILENO))
    std::cerr << "\rframe " << done << " of " << all << (done == all ? "\n" : "")
              << std::flush;
}

void
evaluateNormals (int argc, char** argv)
{
  const auto options = readOptions (argc, argv);
  if (!options)
    return;
  std::vector<FrameSource> sources;
  std::size_t all = 0, done = 0;
  for (const auto& input : options->inputs) {
    sources.emplace_back (input);
    all += sources.back().size();
  }
  OutputFiles files;
  // An unwritable place is known before the work is done.
  if (options->json)
    files.write (*options->json, "");

  NormalComparison comparison (options->steps, options->far_reference);
  for (const auto& source : sources)
    for (std::size_t i = 0; i < source.size(); ++i) {
      comparison.add (source.read (i));
      showProgress (++done, all);
    }

  const std::vector<NormalResult> results = comparison.results();
  printNormalTable (std::cout, results);
  if (options->json)
    files.write (*options->json, normalTableJson (results));
  if (!std::cout.flush())
    throw AppError ("cannot write to standard output");
  files.commit();
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_normals", [&] { evaluateNormals (argc, argv); });
}
