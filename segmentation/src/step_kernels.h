// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/step_finder.h>

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

// Loops of StepFinder in the instructions of the machine that they run on.

/** For places \a begin to \a end of a grid and some more, the difference between the mean error
 * of samples up to that place and of those behind it; 0 where there are too few.
 * \param[in] errors 0 where there is no sample
 * \param[in] own 1 where there is one, else 0
 * \param[in] across from one place to the next across lines
 */
void
findJumps (const float* errors,
           const float* own,
           std::size_t begin,
           std::size_t end,
           std::size_t across,
           float* jumps);

/** Sums over samples of the products of any two of 1, u, v, uu, uv, vv and the error. */
void
sumProducts (const SurfaceSamples& samples, float (&sums)[7][7]);

/** Sums over the samples behind a line of 1, u, v, uu, uv, vv and the error. */
void
sumBehind (const SurfaceSamples& samples, const GridLine& line, float (&sums)[7]);

} // namespace rgbd_planes
} // namespace pcl
