// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"

#include <pcl/segmentation/plane_assignment.h>
#include <pcl/segmentation/plane_growth.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Normals at creases may be off by 35 degrees, where their estimator averages over them. */
constexpr float max_min_cosine = 0.82f;
/** The samples of the tile that begins with sample \a begin whose normals agree. */
std::uint16_t
compatibleSamples (const PlaneSamples& samples,
                   const std::vector<std::int32_t>& owners,
                   std::size_t begin,
                   const Plane& plane)
{
  unsigned bits = 0, curved = 0;
  for (std::size_t k = 0; k < PlaneSamples::tile_size; ++k) {
    const std::size_t i = begin + k;
    const float cosine = std::abs (samples.normal_x[i] * plane.normal[0] +
                                   samples.normal_y[i] * plane.normal[1] +
                                   samples.normal_z[i] * plane.normal[2]);
    const bool agrees = cosine >= std::min (samples.min_cosine[i], max_min_cosine);
    bits |= static_cast<unsigned> (agrees) << k;
    const bool is_curved = owners[i] == PlaneGrowth::curved_surface;
    curved |= static_cast<unsigned> (is_curved) << k;
  }
  // A crease may run between a sample and its pixels.
  constexpr unsigned not_last = 0x7777, not_first = 0xeeee;
  bits |= (bits & not_last) << 1 | (bits & not_first) >> 1;
  bits |= bits << PlaneSamples::tile_side | bits >> PlaneSamples::tile_side;
  return static_cast<std::uint16_t> (bits & ~curved);
}

void
maskUnselected (const TilePixels& pixels,
                const std::uint8_t* selected,
                std::uint32_t* labels)
{
  for (int v = 0; v < pixels.height; ++v)
    for (int u = 0; u < pixels.width; ++u) {
      const std::size_t i = static_cast<std::size_t> (v) * pixels.image_width +
                            static_cast<std::size_t> (u);
      if (!selected[i])
        labels[i] = unlabelled;
    }
}

void
fillLabels (const TilePixels& pixels, std::uint32_t* labels)
{
  for (int v = 0; v < pixels.height; ++v)
    std::fill_n (labels + static_cast<std::size_t> (v) * pixels.image_width,
                 pixels.width,
                 unlabelled);
}

/** The first pixel with \a label, or null. */
const float*
findPixel (const TilePixels& pixels, const std::uint32_t* labels, std::uint32_t label)
{
  for (int v = 0; v < pixels.height; ++v) {
    const std::size_t row = static_cast<std::size_t> (v) * pixels.image_width;
    const std::uint32_t* end = labels + row + pixels.width;
    const std::uint32_t* found = std::find (labels + row, end, label);
    if (found != end)
      return pixels.first + static_cast<std::size_t> (found - labels) * pixels.stride;
  }
  return nullptr;
}

void
addMoments (const TilePixels& pixels,
            const std::uint32_t* labels,
            std::uint32_t label,
            const DepthNoise& noise,
            PlaneMoments& moments,
            PlaneMoments& weighted_moments)
{
  const float* p = findPixel (pixels, labels, label);
  if (!p)
    return;
  // Near points differ by little, and single precision is enough.
  const Eigen::Vector3d reference (p[0], p[1], p[2]);
  double sums[10], weighted[10];
  sumPixels (pixels, labels, label, noise, {p[0], p[1], p[2]}, sums, weighted);
  const auto number = static_cast<std::size_t> (sums[0]);
  moments.add (sums, reference, number);
  weighted_moments.add (weighted, reference, number);
}

} // namespace

void
PlaneAssignment::findPresentPlanes (const PlaneSamples& samples,
                                    const std::vector<std::int32_t>& owners)
{
  const std::size_t tiles = samples.size() / PlaneSamples::tile_size;
  present_.clear();
  first_.clear();
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    first_.push_back (present_.size());
    std::int32_t own[PlaneSamples::tile_size];
    std::copy_n (&owners[tile * PlaneSamples::tile_size], PlaneSamples::tile_size, own);
    if (std::all_of (
            own, std::end (own), [&] (std::int32_t o) { return o == own[0]; })) {
      if (own[0] >= 0)
        present_.push_back (static_cast<std::uint32_t> (own[0]));
      continue;
    }
    std::sort (own, std::end (own));
    for (std::size_t k = 0; k + min_samples_in_tile <= PlaneSamples::tile_size; ++k)
      if (own[k] >= 0 && own[k] == own[k + min_samples_in_tile - 1] &&
          (k == 0 || own[k - 1] != own[k]))
        present_.push_back (static_cast<std::uint32_t> (own[k]));
  }
  first_.push_back (present_.size());
}

/** The planes of the tile and of the eight around it. */
std::size_t
PlaneAssignment::findPlanesAround (const PlaneSamples& samples,
                                   const std::vector<std::int32_t>& owners,
                                   const std::vector<Plane>& planes,
                                   int tile_u,
                                   int tile_v,
                                   TilePlane* around) const
{
  const auto begin = static_cast<std::size_t> (tile_v * samples.tiles_u + tile_u) *
                     PlaneSamples::tile_size;
  std::size_t number = 0;
  const int last_v = std::min (tile_v + 1, samples.tiles_v - 1);
  const int last_u = std::min (tile_u + 1, samples.tiles_u - 1);
  for (int v = std::max (tile_v - 1, 0); v <= last_v; ++v)
    for (int u = std::max (tile_u - 1, 0); u <= last_u; ++u) {
      const auto tile = static_cast<std::size_t> (v * samples.tiles_u + u);
      for (std::size_t k = first_[tile]; k < first_[tile + 1]; ++k) {
        const std::uint32_t id = present_[k];
        const auto is_known = [id] (const TilePlane& plane) {
          return plane.number == id;
        };
        if (std::any_of (around, around + number, is_known))
          continue;
        const Plane& plane = planes[id];
        around[number++] = {
            id,
            {plane.normal[0], plane.normal[1], plane.normal[2], plane.d},
            compatibleSamples (samples, owners, begin, plane)};
      }
    }
  return number;
}

void
PlaneAssignment::compute (const OrganizedPoints& points,
                          const std::vector<std::uint8_t>& selected,
                          const PlaneSamples& samples,
                          const std::vector<std::int32_t>& owners,
                          const std::vector<Plane>& planes,
                          const DepthNoise& noise,
                          float max_sigmas,
                          Pixels which)
{
  findPresentPlanes (samples, owners);
  labels_.resize (points.size());
  moments_.assign (planes.size(), PlaneMoments{});
  weighted_moments_.assign (planes.size(), PlaneMoments{});
  const int every = which == Pixels::all ? 1 : samples.step;
  const int width = (points.width - every / 2 + every - 1) / every;
  const int height = (points.height - every / 2 + every - 1) / every;
  const int side = PlaneSamples::tile_side * samples.step / every;
  const auto image_width = static_cast<std::size_t> (points.width);
  for (int tile_v = 0; tile_v < samples.tiles_v; ++tile_v)
    for (int tile_u = 0; tile_u < samples.tiles_u; ++tile_u) {
      const auto row = static_cast<std::size_t> (tile_v * side);
      const auto column = static_cast<std::size_t> (tile_u * side);
      const auto begin = static_cast<std::size_t> (every / 2) * (image_width + 1);
      const std::size_t first = row * image_width + column;
      TilePixels pixels;
      pixels.first = points[begin + first * static_cast<std::size_t> (every)];
      pixels.stride = points.stride * static_cast<std::size_t> (every);
      pixels.image_width = image_width;
      pixels.width = std::min (side, width - tile_u * side);
      pixels.height = std::min (side, height - tile_v * side);
      pixels.step = samples.step / every;
      if (pixels.width <= 0 || pixels.height <= 0)
        continue;

      TilePlane around[max_planes_around];
      const std::size_t number =
          findPlanesAround (samples, owners, planes, tile_u, tile_v, around);
      if (number == 0) {
        fillLabels (pixels, &labels_[first]);
        continue;
      }
      assignPixels (
          pixels, around, number, noise, max_sigmas, unlabelled, &labels_[first]);
      if (!selected.empty() && which == Pixels::all)
        maskUnselected (pixels, &selected[first], &labels_[first]);
      for (std::size_t k = 0; k < number; ++k) {
        const std::uint32_t id = around[k].number;
        addMoments (
            pixels, &labels_[first], id, noise, moments_[id], weighted_moments_[id]);
      }
    }
}

} // namespace rgbd_planes
} // namespace pcl
