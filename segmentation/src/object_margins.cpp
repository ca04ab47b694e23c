// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"

#include <pcl/segmentation/impl/object_clusters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Whether a point is close to none of its neighbours: noise, which tells nothing of what is
 * there. */
bool
isSpeck (const OrganizedPoints& points, std::uint32_t i, const LinkLimit& limit)
{
  const std::ptrdiff_t width = points.width;
  const std::array<std::ptrdiff_t, 4> steps{-width, -1, 1, width};
  return std::none_of (steps.begin(), steps.end(), [&] (std::ptrdiff_t step) {
    const std::uint32_t j = nextPixel (points, i, step);
    return j != i && isMeasured (points[j]) && limit.allows (points[i], points[j]);
  });
}

} // namespace

template <typename Visit>
void
ObjectClusters::visitMargin (const PointRun& run, const Visit& visit) const
{
  constexpr std::uint32_t at_once = 8;
  const std::uint8_t* own = &place_[run.first];
  const std::uint8_t* up = &place_[nextPixel (points_, run.first, -points_.width)];
  const std::uint8_t* down = &place_[nextPixel (points_, run.first, points_.width)];
  for (std::uint32_t k = 0; k < run.length; ++k) {
    while (k > 0 && k + at_once < run.length &&
           std::memcmp (own + k, up + k, at_once) == 0 &&
           std::memcmp (own + k, down + k, at_once) == 0)
      k += at_once;
    if (k == 0 || k + 1 == run.length || own[k] != up[k] || own[k] != down[k])
      visit (run.first + k);
  }
}

/** With \a up from a pixel to the one above it. */
void
ObjectClusters::lookAtMargin (const PointRun& run,
                              std::ptrdiff_t up,
                              const LinkLimit& limit,
                              Sums& sums) const
{
  visitMargin (run, [&] (std::uint32_t i) {
    countLeak (i, run, limit, sums);
    countTop (i, up, limit, sums);
  });
}

void
ObjectClusters::countLeak (std::uint32_t i,
                           const PointRun& run,
                           const LinkLimit& limit,
                           Sums& sums) const
{
  bool leaks = false, is_at_background = false;
  const auto lookAt = [&] (std::ptrdiff_t step) {
    const std::uint32_t j = nextPixel (points_, i, step);
    if ((is_background_[j] || place_[j] == outside) && isMeasured (points_[j]) &&
        limit.allows (points_[i], points_[j]))
      (is_background_[j] ? is_at_background : leaks) = true;
  };
  lookAt (-points_.width);
  lookAt (points_.width);
  if (i == run.first)
    lookAt (-1);
  if (i == run.first + run.length - 1)
    lookAt (1);
  sums.leaks += leaks;
  sums.at_background += is_at_background;
}

void
ObjectClusters::countTop (std::uint32_t i,
                          std::ptrdiff_t up,
                          const LinkLimit& limit,
                          Sums& sums) const
{
  const SupportSurface& support = supports_->planes()[sums.support];
  std::uint32_t last = i, k = nextPixel (points_, i, up);
  if (place_[k] == place_[i])
    return;
  const std::ptrdiff_t side = alongRow (up) ? points_.width : 1;
  const auto goesOnBeside = [&] (std::ptrdiff_t step) {
    const std::uint32_t j = nextPixel (points_, k, step);
    return j != k && place_[j] == place_[i] && limit.allows (points_[i], points_[j]);
  };
  // What leans has sides, not tops, that end there.
  if (goesOnBeside (side) || goesOnBeside (-side))
    return;
  for (; k != last && place_[k] != place_[i] &&
         (!isMeasured (points_[k]) || isSpeck (points_, k, limit));
       k = nextPixel (points_, k, up))
    last = k;
  if (k == last || place_[k] == place_[i])
    return;
  const bool is_on_plane = place_[k] == nowhere && !is_background_[k];
  const bool is_on_own =
      is_on_plane &&
      mayBeOnPlane (points_[k], support.plane, heightAbove (support, k), parameters_);
  ++sums.tops;
  sums.passing += is_on_own && hasNoStep (i, k, support);
  sums.going_on += limit.allows (points_[i], points_[k])
                       ? place_[k] == outside || (is_on_plane && !is_on_own)
                       : squaredRange (points_[k]) < squaredRange (points_[i]);
}

/** Whether \a i is not higher than \a k by more than a step of the depth of a camera shows. */
bool
ObjectClusters::hasNoStep (std::uint32_t i,
                           std::uint32_t k,
                           const SupportSurface& support) const
{
  constexpr float step_sigmas = 2.f;
  return heightAbove (support, i) - heightAbove (support, k) <
         step_sigmas * parameters_.noise.sigmaAtSquare (squaredRange (points_[i])) *
             std::fabs (elevationOf (points_[i], bases_.back()->plane.normal));
}

} // namespace rgbd_planes
} // namespace pcl
