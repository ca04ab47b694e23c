// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <X11/Xlib.h>

#include <pcl/apps/app_error.h>
#include <pcl/apps/display.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>

namespace pcl {
namespace rgbd_planes {

namespace {

std::string
displayName ()
{
  const char* name = std::getenv ("DISPLAY");
  return name ? name : "";
}

/** At once: what VTK would clean up needs the display, and crashes without. */
int
endWithoutDisplay (Display*)
{
  std::cerr << "pcl_plane_viewer: the display has gone; start it again" << std::endl;
  std::_Exit (1);
}

/** Becomes a display without a screen that ends with the program, not at Ctrl-C, and writes its
 * number to a file. */
[[noreturn]] void
becomeServer (int number_file)
{
  ::setsid();
  ::prctl (PR_SET_PDEATHSIG, SIGTERM);
  const int nowhere = ::open ("/dev/null", O_RDWR);
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::dup2 (nowhere, file);
  ::execlp ("Xvfb",
            "Xvfb",
            "-displayfd",
            std::to_string (number_file).c_str(),
            "-screen",
            "0",
            "1280x1024x24",
            "-nolisten",
            "tcp",
            nullptr);
  std::_Exit (1);
}

} // namespace

void
checkDisplay ()
{
  // Kept open: a server like Xvfb starts anew when its last client goes, and cannot be reached
  // for a moment.
  static Display* const display = XOpenDisplay (nullptr);
  if (display) {
    XSetIOErrorHandler (endWithoutDisplay);
    return;
  }
  const std::string name = displayName();
  throw AppError ((name.empty() ? "there is no display (DISPLAY is not set)"
                                : "cannot open the display '" + name + "'") +
                  "; start it in a desktop session, or under 'xvfb-run -a' without a "
                  "screen");
}

void
provideDisplay ()
{
  if (!displayName().empty())
    return;
  int number_pipe[2];
  if (::pipe (number_pipe) != 0)
    throw AppError ("cannot open a pipe; close other programs");
  const pid_t child = ::fork();
  if (child < 0)
    throw AppError ("cannot start Xvfb; close other programs");
  if (child == 0)
    becomeServer (number_pipe[1]);
  ::close (number_pipe[1]);
  std::string number;
  for (char c; ::read (number_pipe[0], &c, 1) == 1 && c != '\n';)
    number += c;
  ::close (number_pipe[0]);
  if (number.empty())
    throw AppError (
        "there is no display, and no Xvfb to do without: install the package xvfb");
  ::setenv ("DISPLAY", (':' + number).c_str(), 1);
}

} // namespace rgbd_planes
} // namespace pcl
