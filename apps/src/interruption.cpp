// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/interruption.h>

#include <csignal>

namespace pcl {
namespace rgbd_planes {

namespace {

volatile std::sig_atomic_t interrupted = 0;

} // namespace

void
catchInterruption ()
{
  const auto interrupt = [] (int) { interrupted = 1; };
  for (const int signal : {SIGINT, SIGTERM})
    std::signal (signal, interrupt);
  if (std::signal (SIGHUP, interrupt) == SIG_IGN) // under nohup
    std::signal (SIGHUP, SIG_IGN);
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal (signal, SIG_IGN);
}

bool
isInterrupted ()
{
  return interrupted != 0;
}

void
stopIfInterrupted ()
{
  if (interrupted)
    throw AppError ("interrupted; nothing was written");
}

} // namespace rgbd_planes
} // namespace pcl
