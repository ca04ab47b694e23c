// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Adds --help and --version. */
void
addHelpOptions (boost::program_options::options_description& options);

/** \brief Prints the version where --version asks for it, which is returned. */
bool
printVersion (const boost::program_options::variables_map& values);

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

} // namespace rgbd_planes
} // namespace pcl
