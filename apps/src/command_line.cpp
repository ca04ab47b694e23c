// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/program_options.hpp>

#include <iostream>
#include <vector>

namespace po = boost::program_options;

namespace pcl {
namespace rgbd_planes {

const char exit_help[] = "Exit code: 0 if all went well; 1 if the command line or an "
                         "input is wrong, or a file "
                         "cannot be\nwritten; a line on stderr then says what to do.\n";

void
addHelpOptions (po::options_description& options)
{
  options.add_options() ("help,h", "print this help") ("version", "print the version");
}

po::variables_map
parseCommandLine (int argc,
                  char** argv,
                  const po::options_description& options,
                  const std::string& arguments,
                  int max_arguments)
{
  po::options_description all;
  all.add (options).add_options() (arguments.c_str(),
                                   po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add (arguments.c_str(), -1);
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
  // As options, too, more of them can be given.
  if (max_arguments >= 0 && values.count (arguments) &&
      values[arguments].as<std::vector<std::string>>().size() >
          static_cast<std::size_t> (max_arguments))
    throw AppError ("only " + std::to_string (max_arguments) + ' ' +
                    boost::to_upper_copy (arguments) +
                    " may be given; put numbers that belong together between commas "
                    "without spaces; see --help");
  return values;
}

std::optional<po::variables_map>
readCommandLine (int argc,
                 char** argv,
                 const po::options_description& options,
                 const std::string& arguments,
                 int max_arguments,
                 const std::string& help)
{
  po::variables_map values =
      parseCommandLine (argc, argv, options, arguments, max_arguments);
  if (values.count ("version")) {
    std::cout << "pcl_rgbd_planes " PCL_RGBD_PLANES_VERSION "\n";
    return std::nullopt;
  }
  if (values.count ("help")) {
    std::cout << help << '\n' << options << '\n' << exit_help;
    return std::nullopt;
  }
  if (!values.count (arguments))
    throw AppError ("no " + boost::to_upper_copy (arguments) + " given; see --help");
  return values;
}

} // namespace rgbd_planes
} // namespace pcl
