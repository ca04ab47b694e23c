// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <optional>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Adds --help and --version. */
void
addHelpOptions (boost::program_options::options_description& options);

/** \brief Exit codes, for --help. */
extern const char exit_help[];

/** \brief Reads a command line: options, and arguments without a name.
 * \param[in] arguments the name under which the latter are found, as a
 * std::vector<std::string>
 * \param[in] max_arguments how many of them there may be, or -1
 * Throws AppError where something is unknown or malformed.
 */
boost::program_options::variables_map
parseCommandLine (int argc,
                  char** argv,
                  const boost::program_options::options_description& options,
                  const std::string& arguments,
                  int max_arguments);

/** \brief The same for an application with addHelpOptions().
 * \param[in] help printed for --help, before the options
 * \return nothing where only help or the version was asked for, which is printed
 * Throws AppError also where there are no arguments.
 */
std::optional<boost::program_options::variables_map>
readCommandLine (int argc,
                 char** argv,
                 const boost::program_options::options_description& options,
                 const std::string& arguments,
                 int max_arguments,
                 const std::string& help);

} // namespace rgbd_planes
} // namespace pcl
