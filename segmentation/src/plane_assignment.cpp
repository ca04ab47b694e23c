// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "tile_bits.h"

#include <pcl/segmentation/plane_assignment.h>

#include <algorithm>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

void
PlaneAssignment::layOutTiles (const PlaneSamples& samples,
                              const OrganizedPoints& points)
{
  if (image_width_ == points.width && image_height_ == points.height)
    return;
  image_width_ = points.width;
  image_height_ = points.height;
  const int side = PlaneSamples::tile_side * samples.step;
  const int last_width = image_width_ - (samples.tiles_u - 1) * side;
  const int last_height = image_height_ - (samples.tiles_v - 1) * side;
  for (int k = 0; k < 4; ++k) {
    TilePixels& pixels = layouts_[static_cast<std::size_t> (k)];
    pixels.width = k % 2 ? last_width : side;
    pixels.height = k / 2 ? last_height : side;
    pixels.offsets.clear();
    pixels.samples.clear();
    for (int v = 0; v < pixels.height; ++v)
      for (int u = 0; u < pixels.width; ++u) {
        pixels.offsets.push_back (v * image_width_ + u);
        pixels.samples.push_back (v / samples.step * PlaneSamples::tile_side +
                                  u / samples.step);
      }
    while (pixels.offsets.size() % PlaneSamples::tile_size != 0) {
      pixels.offsets.push_back (0);
      pixels.samples.push_back (0);
    }
  }
  const auto pixels = static_cast<std::size_t> (side * side);
  for (auto* values : {&x_, &y_, &z_})
    values->resize (pixels);
  tile_labels_.resize (std::max (pixels, PlaneSamples::tile_size));
}

void
PlaneAssignment::assignSamples (const PlaneSamples& samples,
                                const std::vector<Plane>& planes,
                                const DepthNoise& noise,
                                float max_sigmas)
{
  moments_.assign (planes.size(), PlaneMoments{});
  weighted_moments_.assign (planes.size(), PlaneMoments{});
  normals_.assign (planes.size(), {});
  intersections_.clear();
  sample_labels_.resize (samples.size());
  tile_labels_.resize (std::max (tile_labels_.size(), PlaneSamples::tile_size));
  std::int32_t own[PlaneSamples::tile_size];
  std::iota (own, std::end (own), 0);
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    const std::size_t begin = tile * PlaneSamples::tile_size;
    if (first_candidate_[tile] == first_candidate_[tile + 1])
      continue;
    const PointBlock points = samplesFrom (samples, begin);
    assignTile (points, own, samples, tile, planes, noise, max_sigmas);
    compareNormals (samples, planes, tile);
    std::copy_n (tile_labels_.begin(), PlaneSamples::tile_size, &sample_labels_[begin]);
  }
}

/** Counts the normals of the samples of the tile, which was assigned last. */
void
PlaneAssignment::compareNormals (const PlaneSamples& samples,
                                 const std::vector<Plane>& planes,
                                 std::size_t tile)
{
  for (std::size_t k = first_candidate_[tile]; k < first_candidate_[tile + 1]; ++k) {
    const std::uint32_t plane = candidates_[k].plane;
    const unsigned own = samplesWhere (
        tile_labels_.data(), [plane] (std::uint32_t label) { return label == plane; });
    if (own == 0)
      continue;
    const NormalsAtPlane at_plane = normalsAtPlane (
        samples, tile * PlaneSamples::tile_size, equationOf (planes[plane]));
    normals_[plane].known += count (own & at_plane.known);
    normals_[plane].near += count (own & at_plane.near);
  }
}

/** The planes that points of the tile may lie on. */
void
PlaneAssignment::findTilePlanes (const std::vector<Plane>& planes, std::size_t tile)
{
  tile_planes_.clear();
  for (std::size_t k = first_candidate_[tile]; k < first_candidate_[tile + 1]; ++k) {
    const Candidate& candidate = candidates_[k];
    tile_planes_.push_back (
        {candidate.plane, equationOf (planes[candidate.plane]), candidate.compatible});
  }
}

void
PlaneAssignment::assignPixels (const OrganizedPoints& points,
                               const std::vector<std::uint8_t>& selected,
                               const PlaneSamples& samples,
                               const std::vector<Plane>& planes,
                               const DepthNoise& noise,
                               float max_sigmas)
{
  layOutTiles (samples, points);
  moments_.assign (planes.size(), PlaneMoments{});
  weighted_moments_.assign (planes.size(), PlaneMoments{});
  labels_.resize (points.size());
  const auto width = static_cast<std::size_t> (points.width);
  const auto side = static_cast<std::size_t> (layouts_[0].width);
  std::size_t tile = 0;
  for (int v = 0; v < samples.tiles_v; ++v)
    for (int u = 0; u < samples.tiles_u; ++u, ++tile) {
      const std::size_t first =
          (static_cast<std::size_t> (v) * width + static_cast<std::size_t> (u)) * side;
      const bool at_right = u + 1 == samples.tiles_u, below = v + 1 == samples.tiles_v;
      const TilePixels& pixels = layouts_[(below ? 2u : 0u) + (at_right ? 1u : 0u)];
      if (first_candidate_[tile] == first_candidate_[tile + 1])
        std::fill (tile_labels_.begin(), tile_labels_.end(), unlabelled);
      else {
        loadTile (points, selected, pixels, first);
        assignTile ({x_.data(), y_.data(), z_.data(), pixels.offsets.size()},
                    pixels.samples.data(),
                    samples,
                    tile,
                    planes,
                    noise,
                    max_sigmas);
      }
      const auto row = static_cast<std::size_t> (pixels.width);
      for (std::size_t k = 0; k < static_cast<std::size_t> (pixels.height); ++k)
        std::copy_n (&tile_labels_[k * row], row, &labels_[first + k * width]);
    }
}

void
PlaneAssignment::loadTile (const OrganizedPoints& points,
                           const std::vector<std::uint8_t>& selected,
                           const TilePixels& pixels,
                           std::size_t first)
{
  loadPixels (points[first],
              points.stride,
              pixels.offsets,
              static_cast<std::size_t> (pixels.width),
              x_.data(),
              y_.data(),
              z_.data());
  const auto number = static_cast<std::size_t> (pixels.width * pixels.height);
  std::fill (x_.begin() + static_cast<std::ptrdiff_t> (number),
             x_.begin() + static_cast<std::ptrdiff_t> (pixels.offsets.size()),
             std::numeric_limits<float>::quiet_NaN());
  if (!selected.empty())
    for (std::size_t k = 0; k < number; ++k)
      if (!selected[first + static_cast<std::size_t> (pixels.offsets[k])])
        x_[k] = std::numeric_limits<float>::quiet_NaN();
}

/** Leaves the labels of the points, and adds to the moments. */
void
PlaneAssignment::assignTile (const PointBlock& points,
                             const std::int32_t* samples_of_points,
                             const PlaneSamples& samples,
                             std::size_t tile,
                             const std::vector<Plane>& planes,
                             const DepthNoise& noise,
                             float max_sigmas)
{
  findTilePlanes (planes, tile);
  assignPoints (points,
                samples_of_points,
                tile_planes_.data(),
                tile_planes_.size(),
                noise,
                max_sigmas,
                unlabelled,
                tile_labels_.data());
  splitTile (points, noise, max_sigmas);
  sumTile (points, samples, tile, noise, moments_, weighted_moments_);
}

/** Adds the points to the moments of the planes whose labels they have. */
void
PlaneAssignment::sumTile (const PointBlock& points,
                          const PlaneSamples& samples,
                          std::size_t tile,
                          const DepthNoise& noise,
                          std::vector<PlaneMoments>& moments,
                          std::vector<PlaneMoments>& weighted) const
{
  // Near points differ by little, and single precision is enough.
  const Eigen::Vector3d reference = samples.measuredPoint (tile).cast<double>();
  for (const TilePlane& plane : tile_planes_) {
    double sums[10];
    sumPoints (points,
               tile_labels_.data(),
               plane.number,
               {reference[0], reference[1], reference[2]},
               sums);
    if (!(sums[0] > 0.))
      continue;
    PlaneMoments of_tile;
    of_tile.add (sums, reference, static_cast<std::size_t> (sums[0]));
    moments[plane.number] += of_tile;
    const auto squared_range = static_cast<float> (of_tile.mean().squaredNorm());
    const float sigma = noise.sigma (squared_range);
    weighted[plane.number] += of_tile.scaled (squared_range / (sigma * sigma));
  }
}

} // namespace rgbd_planes
} // namespace pcl
