// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_assignment.h>

#include <algorithm>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Pixels are on a plane up to so many times the tolerance away from it: in tiles of which it owns
 * all samples, and elsewhere, as points within noise may be on the foot of what stands there. */
constexpr float inner_reach = 1.15f, border_reach = 0.9f;
/** Something stands on a plane where more points that are on none are in front of it than behind
 * it, as noise is: by this share of the pixels of a tile. The foot of it may be what is in front of
 * the plane there by more than so many times the tolerance, and has another normal. */
constexpr double min_standing_share = 0.1;
constexpr float foot_reach = 0.35f;

/** Sums over the points with \a label; near \a reference they differ by little, and single
 * precision is enough.
 * \return the number of points; \a sums are left as they are where there is none
 */
std::size_t
sumPointsAround (const Eigen::Vector3d& reference,
                 const PointBlock& points,
                 const float* weights,
                 const std::uint32_t* labels,
                 std::uint32_t label,
                 double (&sums)[10])
{
  const std::size_t number =
      sumPoints (points, weights, labels, label, reference.data(), sums);
  if (number != 0)
    shiftSums (reference, sums);
  return number;
}

} // namespace

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
    pixels.width = k % 2 ? last_width : std::min (side, image_width_);
    pixels.height = k / 2 ? last_height : std::min (side, image_height_);
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
  const std::size_t pixels = layouts_[0].offsets.size(); // the largest
  for (auto* values : {&x_, &y_, &z_})
    values->resize (pixels);
  ones_.assign (pixels, 1.f);
  tile_labels_.resize (std::max (pixels, PlaneSamples::tile_size));
}

void
PlaneAssignment::assignSamples (const PlaneSamples& samples,
                                const std::vector<Plane>& planes,
                                const DepthNoise& tolerance)
{
  weighted_moments_.assign (planes.size(), PlaneMoments{});
  normals_.assign (planes.size(), {});
  setEquations (planes);
  intersections_.clear();
  sample_labels_.resize (samples.size());
  tile_labels_.resize (std::max (tile_labels_.size(), PlaneSamples::tile_size));
  std::int32_t own[PlaneSamples::tile_size];
  std::iota (own, std::end (own), 0);
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    const std::size_t begin = tile * PlaneSamples::tile_size;
    if (planesOf (tile).size() == 0)
      continue;
    const PointBlock points = samplesFrom (samples, begin);
    assignTile (points, own, tile, tolerance);
    sumSamples (samples, tile, weighted_moments_);
    compareNormals (samples, tile, tolerance.normal_scatter);
    std::copy_n (tile_labels_.begin(), PlaneSamples::tile_size, &sample_labels_[begin]);
  }
}

/** Counts the normals of the samples of the tile, which was assigned last. */
void
PlaneAssignment::compareNormals (const PlaneSamples& samples,
                                 std::size_t tile,
                                 float scatter)
{
  for (const TilePlane& plane : planesOf (tile)) {
    const unsigned own =
        samplesWhere (tile_labels_.data(),
                      [&plane] (std::uint32_t label) { return label == plane.number; });
    if (own == 0)
      continue;
    const NormalsAtPlane at_plane = normalsAtPlane (
        samples, tile * PlaneSamples::tile_size, equations_[plane.number], scatter);
    normals_[plane.number].known += count (own & at_plane.known);
    normals_[plane.number].near += count (own & at_plane.near);
  }
}

void
PlaneAssignment::setEquations (const std::vector<Plane>& planes)
{
  equations_.resize (planes.size());
  std::transform (planes.begin(), planes.end(), equations_.begin(), equationOf);
}

void
PlaneAssignment::assignPixels (const OrganizedPoints& points,
                               const std::vector<std::uint8_t>& selected,
                               const PlaneSamples& samples,
                               const std::vector<Plane>& planes,
                               const DepthNoise& noise,
                               float max_sigmas)
{
  const DepthNoise inner = noise.times (inner_reach * max_sigmas),
                   border = noise.times (border_reach * max_sigmas),
                   foot = noise.times (foot_reach * max_sigmas);
  layOutTiles (samples, points);
  moments_.assign (planes.size(), PlaneMoments{});
  weighted_moments_.assign (planes.size(), PlaneMoments{});
  setEquations (planes);
  labels_.resize (points.size());
  const auto width = static_cast<std::size_t> (points.width);
  const auto side = static_cast<std::size_t> (PlaneSamples::tile_side * samples.step);
  std::size_t tile = 0;
  for (int v = 0; v < samples.tiles_v; ++v)
    for (int u = 0; u < samples.tiles_u; ++u, ++tile) {
      const std::size_t first =
          (static_cast<std::size_t> (v) * width + static_cast<std::size_t> (u)) * side;
      const bool at_right = u + 1 == samples.tiles_u, below = v + 1 == samples.tiles_v;
      const TilePixels& pixels = layouts_[(below ? 2u : 0u) + (at_right ? 1u : 0u)];
      if (planesOf (tile).size() == 0)
        std::fill (tile_labels_.begin(), tile_labels_.end(), unlabelled);
      else {
        loadTile (points, selected, pixels, first);
        const PointBlock block = {
            x_.data(), y_.data(), z_.data(), pixels.offsets.size()};
        assignTile (
            block, pixels.samples.data(), tile, is_inner_[tile] ? inner : border);
        sumPixels (block, pixels, samples, tile, noise, foot);
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

/** Leaves the labels of the points. */
void
PlaneAssignment::assignTile (const PointBlock& points,
                             const std::int32_t* samples_of_points,
                             std::size_t tile,
                             const DepthNoise& tolerance)
{
  assignPoints (points,
                samples_of_points,
                planesOf (tile),
                equations_.data(),
                tolerance,
                tile_labels_.data());
  splitTile (points, tile, tolerance);
}

/** Adds the samples of the tile to the moments of the planes whose labels they have. */
void
PlaneAssignment::sumSamples (const PlaneSamples& samples,
                             std::size_t tile,
                             std::vector<PlaneMoments>& moments) const
{
  const std::size_t begin = tile * PlaneSamples::tile_size;
  const Eigen::Vector3d reference = samples.nearestPoint (tile).cast<double>();
  for (const TilePlane& plane : planesOf (tile)) {
    double sums[10];
    const std::size_t number = sumPointsAround (reference,
                                                samplesFrom (samples, begin),
                                                &samples.weight[begin],
                                                tile_labels_.data(),
                                                plane.number,
                                                sums);
    if (number != 0)
      moments[plane.number].add (sums, number);
  }
}

/** Adds the pixels of the tile, likewise. Feet of what stands in it lose their labels, but planes
 * are fitted to them as well: noise in front of a plane weighs as much as that behind. */
void
PlaneAssignment::sumPixels (const PointBlock& points,
                            const TilePixels& pixels,
                            const PlaneSamples& samples,
                            std::size_t tile,
                            const DepthNoise& noise,
                            const DepthNoise& foot)
{
  const Eigen::Vector3d reference = samples.nearestPoint (tile).cast<double>();
  for (const TilePlane& plane : planesOf (tile)) {
    double sums[10];
    const auto sumUp = [&] {
      return sumPointsAround (
          reference, points, ones_.data(), tile_labels_.data(), plane.number, sums);
    };
    std::size_t number = sumUp();
    if (number == 0)
      continue;
    const double square = sums[1] * sums[1] + sums[2] * sums[2] + sums[3] * sums[3];
    const auto squared_range = static_cast<float> (square / (sums[0] * sums[0]));
    const float sigma = noise.sigmaAtSquare (squared_range);
    weighted_moments_[plane.number].add (sums, number, squared_range / (sigma * sigma));
    if (!is_inner_[tile] && leaveFeet (points, pixels, samples, tile, plane, foot))
      number = sumUp();
    if (number != 0)
      moments_[plane.number].add (sums, number);
  }
}

/** Takes the labels of feet off a plane in the tile, if something stands on it there.
 * \return whether something does */
bool
PlaneAssignment::leaveFeet (const PointBlock& points,
                            const TilePixels& pixels,
                            const PlaneSamples& samples,
                            std::size_t tile,
                            const TilePlane& plane,
                            const DepthNoise& foot)
{
  const PlaneEquation& equation = equations_[plane.number];
  const std::ptrdiff_t standing =
      unlabelledInFront (points, tile_labels_.data(), equation, foot.maxSquaredRange());
  if (static_cast<double> (standing) <
      min_standing_share * static_cast<double> (points.size))
    return false;
  const NormalsAtPlane normals = normalsAtPlane (
      samples, tile * PlaneSamples::tile_size, equation, foot.normal_scatter);
  leaveFootPoints (points,
                   pixels.samples.data(),
                   {plane.number, normals.near},
                   equation,
                   foot,
                   tile_labels_.data());
  return true;
}

} // namespace rgbd_planes
} // namespace pcl
