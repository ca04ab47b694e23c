// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/interruption.h>

#include <csignal>
#include <ctime>

namespace pcl {
namespace rgbd_planes {

namespace {

volatile std::sig_atomic_t interrupted = 0;
volatile std::time_t interrupted_at = 0;

void
interrupt (int signal)
{
  constexpr std::time_t enough_to_clean_up = 2; // seconds
  const std::time_t now = std::time (nullptr);
  if (!interrupted) {
    interrupted = 1;
    interrupted_at = now;
  }
  else if (now - interrupted_at > enough_to_clean_up) {
    std::signal (signal, SIG_DFL);
    std::raise (signal);
  }
}

} // namespace

void
catchInterruption ()
{
  struct sigaction action = {};
  action.sa_handler = interrupt;
  // Without SA_RESTART: who waits for a pipe wakes up.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    sigaction (signal, nullptr, &before);
    // It is ignored under nohup, or in the background of a script.
    if (before.sa_handler != SIG_IGN)
      sigaction (signal, &action, nullptr);
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
