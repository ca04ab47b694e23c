// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/segmentation/impl/plane_assignment.h>
#include <pcl/segmentation/impl/plane_intersections.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

// Loops over points in the instructions of the machine that they run on.

inline PlaneEquation
equationOf (const Plane& plane)
{
  return {plane.normal[0], plane.normal[1], plane.normal[2], plane.d};
}

/** A plane that is seen at a flatter angle than that of this cosine counts as seen at it:
 * otherwise points hardly off it would be far. */
constexpr float min_view_cosine = 0.1f;

/** From the points of \a samples, (0, 0, 0) where there is none, their normals and
 * curvatures, fills in all else; normals that are none become (0, 0, 0). */
void
judgeSamples (PlaneSamples& samples, const DepthNoise& noise, float max_curvature);

/** Marks the free samples of \a tile that lie on a plane and whose normals agree.
 * \param[out] claimed the weight of each sample of the tile that does, 0 for others
 * \return their number
 */
std::uint8_t
claimTile (const PlaneSamples& samples,
           std::size_t tile,
           const PlaneEquation& plane,
           float max_sigmas,
           float* claimed);

/** Marks the free samples of \a tile that are of \a own, likewise.
 * \return these samples
 */
unsigned
claimPart (const PlaneSamples& samples, std::size_t tile, unsigned own, float* claimed);

/** Gives the claimed samples of \a tile to \a owner: they are no longer free. */
void
takeTile (PlaneSamples& samples,
          std::size_t tile,
          const float* claimed,
          std::int32_t owner,
          std::int32_t* owners);

/** Sums, weighted by \a claimed, of 1, x, y, z, xx, xy, xz, yy, yz, zz, relative to
 * \a reference. */
void
sumSamples (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double* reference,
            double (&sums)[10]);

/** The same over samples with a trusted normal, followed by the sums of the components
 * of their normals, and of these times x, y and z: nx, ny, nz, nx x, nx y, ... nz z. */
void
sumNormals (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double* reference,
            double (&sums)[22]);

/** For each sample of the tile that begins with sample \a begin, a bit: the cosine between
 * its normal and that of the plane is large enough, or at least \a enough. */
unsigned
compatibleSamples (const PlaneSamples& samples,
                   std::size_t begin,
                   const PlaneEquation& plane,
                   float enough);

/** For each sample of a tile, a bit: it has a normal, trusted or not; this is as near to
 * that of a plane as on most points of a flat surface. */
struct NormalsAtPlane {
  unsigned known = 0, near = 0;
};

/** Looks at the tile that begins with sample \a begin, where normals scatter so many times
 * as far as those of a Kinect v1. */
NormalsAtPlane
normalsAtPlane (const PlaneSamples& samples,
                std::size_t begin,
                const PlaneEquation& plane,
                float scatter);

/** For each sample of a tile, a bit: it lies near a plane; its trusted normal is nearly that
 * of the plane. */
struct SamplesAtPlane {
  unsigned near = 0, along = 0;
};

/** Looks at the tile that begins with sample \a begin, at the free samples and at the others.
 */
SamplesAtPlane
samplesAtPlane (const PlaneSamples& samples,
                std::size_t begin,
                const PlaneEquation& plane,
                const DepthNoise& tolerance,
                float least_cosine);

/** Points in arrays of their coordinates, as many as fill vectors of
 * PlaneSamples::tile_size; NaN where there is none. */
struct PointBlock {
  const float *x = nullptr, *y = nullptr, *z = nullptr;
  std::size_t size = 0;
};

/** The samples of the tile that begins with sample \a begin. */
inline PointBlock
samplesFrom (const PlaneSamples& samples, std::size_t begin)
{
  return {
      &samples.x[begin], &samples.y[begin], &samples.z[begin], PlaneSamples::tile_size};
}

/** Copies pixels from an image into arrays.
 * \param[in] first x, y, z of a pixel
 * \param[in] stride floats from one pixel to the next in a row
 * \param[in] offsets of the pixels from the first one, in pixels; those in a row of
 * \a run lie side by side
 */
void
loadPixels (const float* first,
            std::size_t stride,
            const std::vector<std::int32_t>& offsets,
            std::size_t run,
            float* x,
            float* y,
            float* z);

/** Gives each point the nearest one of \a planes, or \ref unlabelled.
 * \param[in] samples the sample in the tile whose normal stands for that of the point
 * \param[in] equations by the numbers of planes
 * \param[in] tolerance how far from its plane a point may lie
 */
void
assignPoints (const PointBlock& points,
              const std::int32_t* samples,
              const TilePlanes& planes,
              const PlaneEquation* equations,
              const DepthNoise& tolerance,
              std::uint32_t* labels);

/** By how many more points with no label are in front of \a plane than behind it. */
std::ptrdiff_t
unlabelledInFront (const PointBlock& points,
                   const std::uint32_t* labels,
                   const PlaneEquation& plane,
                   float max_squared_range);

/** Takes the label of \a plane from points that are in front of it by more than \a tolerance, and
 * whose normals do not agree.
 * \param[in] samples as in assignPoints()
 */
void
leaveFootPoints (const PointBlock& points,
                 const std::int32_t* samples,
                 const TilePlane& plane,
                 const PlaneEquation& equation,
                 const DepthNoise& tolerance,
                 std::uint32_t* labels);

/** Looks at the points with \a label that clearly lie on \a plane, and clearly not on
 * \a other. */
SideCounts
countSides (const PointBlock& points,
            const std::uint32_t* labels,
            std::uint32_t label,
            const PlaneEquation& plane,
            const PlaneEquation& other,
            const DepthNoise& tolerance);

/** Labels anew the points of planes \a a and \a b that lie on both: by which one is nearer
 * along their viewing rays.
 * \param[in] seen which one they belong to
 */
void
splitPoints (const PointBlock& points,
             std::uint32_t a,
             std::uint32_t b,
             const PlaneEquation* equations,
             const DepthNoise& tolerance,
             SeenPlane seen,
             std::uint32_t* labels);

/** Takes the label from the points with \a label near the line in which their \a plane meets
 * \a other: where the planes are not clearly apart along the viewing ray, or the other one
 * should be seen.
 * \param[in] seen which one is seen
 */
void
dropUnclear (const PointBlock& points,
             std::uint32_t label,
             const PlaneEquation& plane,
             const PlaneEquation& other,
             const DepthNoise& tolerance,
             SeenPlane seen,
             std::uint32_t* labels);

/** Sums over the points with \a label relative to \a reference, as sumSamples().
 * \return their number; \a sums are left as they are where there is none
 */
std::size_t
sumPoints (const PointBlock& points,
           const float* weights,
           const std::uint32_t* labels,
           std::uint32_t label,
           const double* reference,
           double (&sums)[10]);

/** How many of \a size labels, one or more, are the same as the first one up to the first
 * that differs. */
std::size_t
lengthOfRun (const std::uint32_t* labels, std::size_t size);

} // namespace rgbd_planes
} // namespace pcl
