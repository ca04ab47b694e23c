// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/progress.h>

#include <boost/program_options/value_semantic.hpp>

#include <iostream>
#include <set>

namespace po = boost::program_options;

namespace pcl {
namespace rgbd_planes {

namespace {

void
preparePictures (const EvaluationCommand& command,
                 const std::vector<FrameSource>& sources,
                 OutputFiles& files)
{
  for (const auto& source : sources)
    refuseInputFolder (source.folders(), *command.pictures);
  std::set<std::string> names;
  for (const auto& source : sources)
    for (std::size_t i = 0; i < source.size(); ++i)
      if (!names.insert (source.name (i)).second)
        throw AppError ("--pictures: frames of two inputs are named '" +
                        source.name (i) +
                        "'; evaluate them in runs with a folder each");
  files.createFolder (*command.pictures);
}

} // namespace

std::optional<EvaluationCommand>
readEvaluationCommand (int argc,
                       char** argv,
                       const std::string& usage,
                       const po::options_description& own)
{
  po::options_description options ("Options", help_width);
  addHelpOptions (options);
  options.add_options() (
      "json", po::value<std::string>()->value_name ("FILE"), "write the table as JSON");
  if (!own.options().empty())
    options.add (own);
  options.add (inputOptionsDescription());
  EvaluationCommand command;
  const auto given =
      readCommandLine (argc, argv, options, "input", -1, usage + '\n' + inputHelp());
  if (!given)
    return std::nullopt;
  command.values = *given;
  const po::variables_map& values = command.values;
  for (const auto& input : values["input"].as<std::vector<std::string>>()) {
    command.inputs.push_back (readInputOptions (input, values));
    if (!values["resolution"].defaulted())
      command.steps = {command.inputs.back().step};
    command.inputs.back().step = 1;
  }
  if (values.count ("json"))
    command.json = values["json"].as<std::string>();
  if (values.count ("pictures"))
    command.pictures = values["pictures"].as<std::string>();
  return command;
}

void
runEvaluation (const EvaluationCommand& command,
               const std::function<void (const Frame&, OutputFiles&)>& add,
               const std::function<std::string()>& table,
               const std::function<std::string()>& json,
               const std::vector<std::function<void (const Frame&)>>& before)
{
  const std::vector<FrameSource> sources (command.inputs.begin(), command.inputs.end());
  catchInterruption();
  OutputFiles files;
  for (const auto& source : sources) {
    files.protect (source.files());
    if (!before.empty())
      source.refusePipes();
  }
  if (command.values.count ("corrected"))
    files.protect ({command.values["corrected"].as<std::string>()});
  // An unwritable place is known before the work is done.
  if (command.pictures)
    preparePictures (command, sources, files);
  if (command.json)
    files.reserve (*command.json);
  for (const auto& body : before)
    forEachFrame (sources, body);
  forEachFrame (sources, [&] (const Frame& frame) { add (frame, files); });
  if (command.json)
    files.write (*command.json, json());
  const std::string printed = table();
  files.commit();
  std::cout << printed;
  flushOutput(); // so that notices about the measures come only behind a table that was written
}

} // namespace rgbd_planes
} // namespace pcl
