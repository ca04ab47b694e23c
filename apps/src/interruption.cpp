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
  struct sigaction interrupt = {};
  interrupt.sa_handler = [] (int) { interrupted = 1; };
  // Without SA_RESTART: who waits for a pipe wakes up.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    sigaction (signal, nullptr, &before);
    // It is ignored under nohup, or in the background of a script.
    if (before.sa_handler != SIG_IGN)
      sigaction (signal, &interrupt, nullptr);
  }
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
