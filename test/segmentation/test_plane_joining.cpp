// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/plane_joining.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

using pcl::rgbd_planes::PlaneJoining;
using pcl::rgbd_planes::PlaneMoments;
using pcl::rgbd_planes::TilePart;

namespace {

/** In parts of the range. */
constexpr double usual_noise = 0.002;

/** Samples, 1 cm apart, of a square in the plane z = 1 m, whose ranges are too large by
 * \a offset standard deviations, and by \a bend for each metre that x is more than 0; their
 * errors are \a scatter standard deviations. */
PlaneMoments
squareAt (double x,
          double side,
          double offset = 0.,
          double noise = usual_noise,
          double bend = 0.,
          double scatter = 1.)
{
  std::mt19937 random (1);
  std::normal_distribution<double> error (offset, scatter);
  PlaneMoments square;
  for (double u = -side / 2; u <= side / 2; u += 0.01)
    for (double v = -side / 2; v <= side / 2; v += 0.01) {
      const double range = 1. + noise * error (random) + bend * (x + u);
      const Eigen::Vector3f p = (Eigen::Vector3d (x + u, v, 1.) * range).cast<float>();
      square.add (p.data(), 1. / (noise * noise));
    }
  return square;
}

std::vector<std::int32_t>
planesOf (const std::vector<PlaneMoments>& parts)
{
  PlaneJoining joining;
  joining.compute (parts, true);
  return joining.planeOfPart();
}

using Planes = std::vector<std::int32_t>;

/** Of the first part and the second, which own so much of each tile of the image that
 * \a ownOf (tile) gives. */
template <typename OwnOf>
Planes
planesWhere (const std::vector<PlaneMoments>& parts, const OwnOf& ownOf)
{
  std::vector<TilePart> tile_parts;
  for (std::uint32_t tile = 0; tile < parts[1].points / 8; ++tile) {
    const std::pair<std::uint16_t, std::uint16_t> own = ownOf (tile);
    tile_parts.push_back ({0, tile, own.first});
    tile_parts.push_back ({1, tile, own.second});
  }
  PlaneJoining joining;
  joining.computeAlternating (parts, tile_parts);
  return joining.planeOfPart();
}

/** Of a square and a second one at the same place, \a offset standard deviations behind it,
 * which own so much of each tile. */
Planes
planesWhere (std::uint16_t own, std::uint16_t own_of_second, double offset)
{
  return planesWhere ({squareAt (0., 0.4), squareAt (0., 0.2, offset)},
                      [=] (std::uint32_t) { return std::pair (own, own_of_second); });
}

} // namespace

TEST (PlaneJoining, JoinsPartsWhereThePlaneOfTheLargerIsKnown)
{
  EXPECT_EQ (planesOf ({squareAt (-0.3, 0.4), squareAt (0.3, 0.1)}), (Planes{0, 0}));
}

TEST (PlaneJoining, LeavesPartsAFewStandardDeviationsOff)
{
  EXPECT_EQ (planesOf ({squareAt (-0.3, 0.4), squareAt (0.3, 0.1, 3.)}),
             (Planes{0, 1}));
}

/** As far walls, which the error of depth bends. */
TEST (PlaneJoining, JoinsPartsOfASurfaceThatIsBent)
{
  const PlaneMoments larger = squareAt (-0.3, 0.4);
  for (const double bend : {-0.03, 0.03}) // 4.5 standard deviations
    EXPECT_EQ (planesOf ({larger, squareAt (0.3, 0.3, 0., usual_noise, bend)}),
               (Planes{0, 0}));
  for (const double step : {-4.5, 4.5}) // as a door in a wall
    EXPECT_EQ (planesOf ({larger, squareAt (0.3, 0.3, step)}), (Planes{0, 1}));
  // Where the step cannot be told from a bend.
  EXPECT_EQ (planesOf ({larger, squareAt (0.3, 0.1, 0., usual_noise, 0.03)}),
             (Planes{0, 1}));
}

/** As a floor, of which some is seen beside a table: what the bend of depth tilts. */
TEST (PlaneJoining, JoinsSmallPartsBesideALargeOneThatIsKnownWell)
{
  for (const double offset : {-4., 4.}) {
    EXPECT_EQ (planesOf ({squareAt (-0.3, 0.6), squareAt (0.5, 0.2, offset)}),
               (Planes{0, 0}));
    EXPECT_EQ (planesOf ({squareAt (-0.2, 0.4), squareAt (0.5, 0.2, offset)}),
               (Planes{0, 1}));
    // A step in it.
    EXPECT_EQ (planesOf ({squareAt (-0.3, 0.6), squareAt (-0.3, 0.2, offset)}),
               (Planes{0, 1}));
  }
}

/** As a floor in three parts, with things between them. */
TEST (PlaneJoining, JoinsWhatIsOnlyKnownOnceOthersAreJoined)
{
  const PlaneMoments first = squareAt (0., 0.2), between = squareAt (0.4, 0.18),
                     last = squareAt (0.9, 0.19);
  EXPECT_EQ (planesOf ({first, last}), (Planes{0, 1}));
  EXPECT_EQ (planesOf ({first, last, between}), (Planes{0, 0, 0}));
}

TEST (PlaneJoining, LeavesPartsThatMeetAtAnAngle)
{
  const double noise = 10. * usual_noise;
  const PlaneMoments larger = squareAt (-0.2, 0.35, 0., noise);
  EXPECT_EQ (planesOf ({larger, squareAt (0.2, 0.3, 0., noise, std::tan (0.35))}),
             (Planes{0, 1}));
  EXPECT_EQ (planesOf ({larger, squareAt (0.3, 0.3, 0., noise, std::tan (0.15))}),
             (Planes{0, 0}));
}

/** Tops of two boxes: what one says about a plane ends long before the other begins. */
TEST (PlaneJoining, LeavesPartsWhereThePlaneOfTheLargerIsNotKnown)
{
  EXPECT_EQ (planesOf ({squareAt (-0.3, 0.12), squareAt (0.3, 0.1, 1.5)}),
             (Planes{0, 1}));
}

/** With a tenth of the noise, little is not known there in millimetres: a table or a step may part
 * a floor in two. */
TEST (PlaneJoining, JoinsPartsOfPreciseSensors)
{
  const double noise = 0.1 * usual_noise;
  EXPECT_EQ (
      planesOf ({squareAt (-0.3, 0.12, 0., noise), squareAt (0.3, 0.1, 1.5, noise)}),
      (Planes{0, 0}));
  EXPECT_EQ (
      planesOf ({squareAt (-0.3, 0.12, 0., noise), squareAt (0.3, 0.1, 5., noise)}),
      (Planes{0, 1}));
}

TEST (PlaneJoining, JoinsSmallPartsByALargeOne)
{
  EXPECT_EQ (
      planesOf ({squareAt (-0.3, 0.12), squareAt (0.3, 0.1), squareAt (0., 0.3)}),
      (Planes{0, 0, 0}));
}

TEST (PlaneJoining, JoinsPartsThatAlternate)
{
  constexpr std::uint16_t checks = 0xa5a5, other_checks = 0x5a5a;
  EXPECT_EQ (planesWhere (checks, other_checks, 4.5), (Planes{0, 0}));
  // Such as a fence before a wall.
  EXPECT_EQ (planesWhere (checks, other_checks, 8.), (Planes{0, 1}));
}

/** The limit of what a plane takes parts what is noisier. */
TEST (PlaneJoining, JoinsNoisyPartsThatAlternateHereAndThere)
{
  const auto planes = [] (double scatter,
                          double scatter_of_second,
                          std::uint32_t apart) {
    return planesWhere ({squareAt (0., 0.4, 0., usual_noise, 0., scatter),
                         squareAt (0., 0.2, 4., usual_noise, 0., scatter_of_second)},
                        [apart] (std::uint32_t tile) {
                          // Half of the alternating samples lie between others.
                          return tile % apart == 0 ? std::pair (0xa5a5, 0x5a5a)
                                                   : std::pair (0x3333, 0xcccc);
                        });
  };
  EXPECT_EQ (planes (1.5, 1.5, 6), (Planes{0, 0}));
  EXPECT_EQ (planes (1., 1.5, 6), (Planes{0, 1}));
  EXPECT_EQ (planes (1.5, 1., 6), (Planes{0, 1}));
  EXPECT_EQ (planes (1.5, 1.5, 20), (Planes{0, 1}));
  EXPECT_EQ (planes (1., 1., 2), (Planes{0, 0}));
}

/** As a wall in two parts, and a curtain before it that lay on a plane with one of them. */
TEST (PlaneJoining, JoinsSidesOfStepsWithOtherPartsOnly)
{
  const std::vector<PlaneMoments> parts{
      squareAt (0., 0.6), squareAt (0.6, 0.4, 1.), squareAt (0.1, 0.3)};
  PlaneJoining joining;
  joining.computeSides (parts, {false, false, false});
  EXPECT_EQ (joining.planeOfPart(), (Planes{0, 0, 0}));
  joining.computeSides (parts, {true, true, false});
  EXPECT_EQ (joining.planeOfPart(), (Planes{0, 1, 0}));
  joining.computeSides (parts, {false, true, true});
  EXPECT_EQ (joining.planeOfPart(), (Planes{0, 0, 1}));
}

TEST (PlaneJoining, LeavesPartsThatLieSideBySide)
{
  EXPECT_EQ (planesWhere (0x3333, 0xcccc, 4.5), (Planes{0, 1}));
  // Stripes: the one are between the others in rows alone.
  EXPECT_EQ (planesWhere (0x5555, 0xaaaa, 4.5), (Planes{0, 1}));
  EXPECT_EQ (planesWhere (0xf0f0, 0x0f0f, 4.5), (Planes{0, 1}));
}
