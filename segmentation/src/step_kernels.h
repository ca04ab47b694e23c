// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/step_finder.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

// Loops of StepFinder in the instructions of the machine that they run on.

/** For places \a begin to \a end of a grid and some more, the difference between the mean error
 * of samples up to that place in its row and of those behind it; 0 where there are too few.
 * \param[in] errors 0 where there is no sample
 * \param[in] own 1 where there is one, else 0
 */
void
findJumps (const float* errors,
           const float* own,
           std::size_t begin,
           std::size_t end,
           float* jumps);

/** Finds places, from \a begin to \a end and up to a multiple of all vectors, whose jumps are
 * \a least or more and the largest of them and their neighbours in the row.
 * \param[out] peaks these places, with room for as many as are looked at
 * \return how many these are
 */
std::size_t
findPeaks (
    const float* jumps, std::size_t begin, std::size_t end, float least, int* peaks);

/** \brief What a line needs for a step: votes, and jumps of so much in the mean of so many places
 * along it. */
struct LineLimits {
  float min_votes, min_jump, min_places;
};

/** Finds lines of one slope along which errors jump.
 * \param[in] jumps the first one of the first row
 * \param[in] width,stride of a row: on both sides of the \a width there are zeros
 * \param[in] starts for each row, the line of its first place
 * \param[in] votes for each line, and 0 where there is none, up to a multiple of all vectors
 * \param[out] lines those found, with room for as many as there are votes
 * \return how many these are
 */
std::size_t
findLines (const float* jumps,
           int width,
           std::size_t stride,
           const std::vector<int>& starts,
           const std::vector<float>& votes,
           const LineLimits& limits,
           int* lines);

/** Sums over samples of the products of any two of 1, u, v, uu, uv, vv and the error. */
void
sumProducts (const SurfaceSamples& samples, float (&sums)[7][7]);

/** Sums over the samples behind a line of 1, u, v, uu, uv, vv and the error. */
void
sumBehind (const SurfaceSamples& samples, const GridLine& line, float (&sums)[7]);

} // namespace rgbd_planes
} // namespace pcl
