// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/segmentation/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

// Loops over points in the instructions of the machine that they run on.

/** The plane x, y, z * p + d = 0. */
struct PlaneEquation {
  float x, y, z, d;
};

/** Nearer points have no direction. */
constexpr float min_squared_range = 1e-12f;
/** Squares of larger numbers are no floats. */
constexpr float max_squared_range = 1e18f;

/** Points lie on a plane up to this many standard deviations of depth away along the
 * viewing ray; seen flatter than this cosine, a plane gets no nearer. */
constexpr float min_view_cosine = 0.1f;

/** Marks the free samples of \a tiles that lie on a plane and whose normals agree.
 * \param[out] claimed the weight of each sample of the tiles that does, 0 for others
 * \param[out] counts their number in each tile of \a tiles
 */
void
claimSamples (const PlaneSamples& samples,
              const std::vector<std::uint32_t>& tiles,
              const PlaneEquation& plane,
              float max_sigmas,
              float* claimed,
              std::uint8_t* counts);

/** Sums, weighted by \a claimed, of 1, x, y, z, xx, xy, xz, yy, yz, zz, relative to
 * \a reference. */
void
sumSamples (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double (&reference)[3],
            double (&sums)[10]);

/** The same over samples with a trusted normal, followed by the sums of the components
 * of their normals, and of these times x, y and z: nx, ny, nz, nx x, nx y, ... nz z. */
void
sumNormals (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double (&reference)[3],
            double (&sums)[22]);

/** A plane that the points of a tile may lie on. */
struct TilePlane {
  std::uint32_t number = 0;
  PlaneEquation equation{};
  /** For each sample of the tile, a bit: its normal agrees with that of the plane. */
  std::uint16_t compatible = 0;
};

/** The pixels of a tile of samples. */
struct TilePixels {
  const float* first = nullptr; /**< x, y, z of the upper left one */
  std::size_t stride = 0;       /**< floats from one point to the next in a row */
  std::size_t image_width = 0;
  int width = 0, height = 0; /**< of the tile, less at the borders of the image */
  int step = 1;              /**< pixels between samples */
};

/** Gives each pixel of a tile the nearest one of \a planes, or \a none.
 * \param[out] labels of the upper left pixel, of an image as wide as that of the points
 */
void
assignPixels (const TilePixels& pixels,
              const TilePlane* planes,
              std::size_t number,
              const DepthNoise& noise,
              float max_sigmas,
              std::uint32_t none,
              std::uint32_t* labels);

/** Sums over the pixels with \a label relative to \a reference, as sumSamples(): with
 * weights of 1, and with the inverse squares of relative standard deviations. */
void
sumPixels (const TilePixels& pixels,
           const std::uint32_t* labels,
           std::uint32_t label,
           const DepthNoise& noise,
           const double (&reference)[3],
           double (&sums)[10],
           double (&weighted)[10]);

} // namespace rgbd_planes
} // namespace pcl
