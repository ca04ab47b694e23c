// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <unistd.h>
#include <X11/Xlib.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/display.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

std::string
displayName ()
{
  const char* name = std::getenv ("DISPLAY");
  return name ? name : "";
}

} // namespace

void
checkDisplay ()
{
  // Kept open: a server like Xvfb starts anew when its last client goes, and cannot be reached
  // for a moment.
  static Display* const display = XOpenDisplay (nullptr);
  if (display)
    return;
  const std::string name = displayName();
  throw AppError ((name.empty() ? "there is no display (DISPLAY is not set)"
                                : "cannot open the display '" + name + "'") +
                  "; start it in a desktop session, or under 'xvfb-run -a' without a "
                  "screen");
}

void
provideDisplay (char** argv)
{
  if (!displayName().empty())
    return;
  std::vector<char*> command;
  std::string launcher[] = {"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24"};
  for (auto& word : launcher)
    command.push_back (word.data());
  for (; *argv; ++argv)
    command.push_back (*argv);
  command.push_back (nullptr);
  ::execvp (command.front(), command.data());
  throw AppError ("there is no display, and no xvfb-run to do without: install the "
                  "packages xvfb and xauth");
}

} // namespace rgbd_planes
} // namespace pcl
