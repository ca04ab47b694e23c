// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/apps/output_files.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The command line of an evaluation: inputs, and what to do with them. */
struct EvaluationCommand {
  std::vector<InputOptions> inputs;
  /** The resolutions asked for: every step-th pixel. Frames are read in full. */
  std::vector<std::uint32_t> steps{1, 2, 4};
  std::optional<std::string> json;
  /** The folder of --pictures, an option that an application may have. */
  std::optional<std::filesystem::path> pictures;
  boost::program_options::variables_map values;
};

/** \brief Reads INPUT..., --json, the options of inputOptionsDescription() and \a own.
 * \param[in] usage printed before the list of options where only help is asked for;
 * nothing is returned then, nor for the version
 * Throws AppError where something is malformed.
 */
std::optional<EvaluationCommand>
readEvaluationCommand (int argc,
                       char** argv,
                       const std::string& usage,
                       const boost::program_options::options_description& own);

/** \brief Shows all frames of all inputs to \a add, then writes \a json () where
 * --json says and prints \a table (). After an AppError nothing is written, unless it is that
 * the table could not be printed.
 * \param[in] add may write to the folder of --pictures, which is there; pictures appear
 * before the file of --json
 * \param[in] before each of them is shown all frames first, one after the other
 */
void
runEvaluation (const EvaluationCommand& command,
               const std::function<void (const Frame&, OutputFiles&)>& add,
               const std::function<std::string()>& table,
               const std::function<std::string()>& json,
               const std::vector<std::function<void (const Frame&)>>& before = {});

} // namespace rgbd_planes
} // namespace pcl
