// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <omp.h>

#include <pcl/features/impl/threads.h>

#include <algorithm>

namespace {

/** More only take memory. */
constexpr unsigned int max_threads = 256;

} // namespace

unsigned int
pcl::rgbd_planes::numberOfThreads (unsigned int nr_threads)
{
  return nr_threads > 0 ? std::min (nr_threads, max_threads)
                        : static_cast<unsigned int> (omp_get_num_procs());
}
