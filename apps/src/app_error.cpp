// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

namespace pcl {
namespace rgbd_planes {

namespace {

/** What runApp() runs. */
std::string app_name;

} // namespace

AppError
cannotOpen (const std::string& file)
{
  return AppError (file + ": cannot open this file: " + std::strerror (errno));
}

void
flushOutput ()
{
  if (!std::cout.flush())
    throw AppError ("cannot write to standard output");
}

void
printNotice (const std::string& line)
{
  std::cerr << app_name << ": " << line << '\n';
}

int
runApp (const std::string& name, const std::function<void()>& body)
{
  app_name = name;
  std::string message;
  try {
    body();
    flushOutput();
    return 0;
  }
  catch (const std::bad_alloc&) {
    message = "not enough memory for this input";
  }
  catch (const std::filesystem::filesystem_error& error) {
    message = error.path1().string() + ": " + error.code().message() +
              "; change its permissions or give another place";
  }
  catch (const std::exception& error) {
    message = error.what();
  }
  // A file name may hold line breaks.
  std::replace (message.begin(), message.end(), '\n', ' ');
  std::cerr << name << ": " << message << std::endl;
  return 1;
}

} // namespace rgbd_planes
} // namespace pcl
