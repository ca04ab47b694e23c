// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <limits>

namespace pcl {
namespace rgbd_planes {

/** \brief Standard deviation of measured depth, constant + quadratic * range^2, in
 * metres, and the range up to which depth is worth using.
 *
 * The defaults are the figures of kinectV1 (), but taken as they are. All presets describe the
 * random error of matt surfaces that face the sensor indoors; sunlight, dark or shiny surfaces
 * and grazing views add to it. So presets are lower bounds (is_least): planes, objects and
 * obstacles measure each frame, and take its noise where it is larger, up to \ref max_ratio times.
 * Figures of your own are taken as they are.
 *
 * For a stereo camera, the quadratic part is the error of disparity divided by focal length and
 * baseline: 0.1 px / (640 px * 0.05 m) = 3.1 mm. Take what this gives for yours, with the
 * normal_scatter of activeStereo (), or what pcl::DepthNoiseEstimation measures: an error twice as
 * large as set makes objects of bare tables. For depth without noise, as simulators give it, and
 * in whole millimetres, take 0.5 mm + 0.5 mm z^2. Below 0.1 mm, single precision is not enough.
 *
 * Setters refuse what is negative, 0 at a range of 1 m, not finite, without a range, or with a
 * scatter of normals that is not 1 to 5: an error message, and the noise before stays.
 */
struct DepthNoise {
  /** In metres. */
  float constant = 0.001f;
  /** In metres at a range of 1 m. */
  float quadratic = 0.002f;
  /** Points further away are not used, in metres; nor are those where the quadratic part
   * of the noise is more than a tenth of the range. */
  float max_range = std::numeric_limits<float>::infinity();
  /** Whether frames may have more, which is measured. */
  bool is_least = false;
  /** How many times as far as with a Kinect v1 the normals of flat surfaces scatter, 1 to 5:
   * where errors of pixels are like those of their neighbours, means over windows have more. */
  float normal_scatter = 1.f;
  static constexpr float max_normal_scatter = 5.f;
  /** Frames count as having at most so many times the least noise: larger errors are those of fine
   * structure, as that of a fence or of leaves. */
  static constexpr float max_ratio = 4.f;
  /** Nearer points, in metres^2, have no direction. */
  static constexpr float min_squared_range = 1e-12f;
  /** The squares of further ones, in metres^2, are too large for sums of floats. */
  static constexpr float max_squared_range = 1e18f;

  /** \brief Points further away, in metres^2, are not used; always less than the squares that
   * floats can hold. */
  float
  maxSquaredRange () const
  {
    return std::min (max_range * max_range, max_squared_range);
  }

  /** \brief The standard deviation in metres at the square root of \a squared_range, in
   * metres^2. */
  float
  sigmaAtSquare (float squared_range) const
  {
    return constant + quadratic * squared_range;
  }

  /** \brief So many times the noise, with the same range. */
  DepthNoise
  times (float factor) const
  {
    DepthNoise result = *this;
    result.constant *= factor;
    result.quadratic *= factor;
    return result;
  }

  /** \brief Kinect v1: 1 mm + 2 mm z^2, the default; all ranges are used.
   *
   * Depth from disparity has an error that grows with the square of the range:
   * 1.43 mm z^2 with the steps of its disparities left out (Khoshelham and Elberink,
   * Accuracy and Resolution of Kinect Depth Data for Indoor Mapping Applications,
   * Sensors 12, 2012), 1.2 mm + 1.9 mm (z - 0.4)^2 with them (Nguyen, Izadi and Lovell,
   * Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking, 3DIMPVT
   * 2012). Ours is the larger of both at every range, for large surfaces come out warped
   * as well.
   */
  static DepthNoise
  kinectV1 ()
  {
    return {0.001f, 0.002f, std::numeric_limits<float>::infinity(), true};
  }

  /** \brief What pcl::DepthWarpCorrection leaves of the errors of a Kinect v1: 0.5 mm +
   * 0.8 mm z^2, for the segmentation of planes with a distance threshold of 7 mm
   * and a minimum share of near normals of 0.4.
   *
   * These are the standard deviation of means over a few pixels, by which planes are told
   * apart; single points scatter by 1.43 mm z^2 (Khoshelham and Elberink, 2012), which
   * the threshold allows for. Chosen for the best planes in simulated rooms; no lower bound.
   */
  static DepthNoise
  kinectV1Corrected ()
  {
    return {0.0005f, 0.0008f};
  }

  /** \brief Structured light at short range, as PrimeSense Carmine, Asus Xtion and Orbbec
   * Astra measure it: 0.5 mm + 1.5 mm z^2, up to 3.5 m.
   *
   * They triangulate as a Kinect v1 does; this is the error that Khoshelham and Elberink
   * (2012) found for it, 1.43 mm z^2, without the reserve that far surfaces need. The
   * range is the one that Asus states for the Xtion. For larger rooms take kinectV1 ().
   */
  static DepthNoise
  structuredLight ()
  {
    return {0.0005f, 0.0015f, 3.5f, true};
  }

  /** \brief Time of flight, as Kinect v2 and Azure Kinect measure it: 1 mm + 0.2 mm z^2, up
   * to 5.5 m.
   *
   * Kinect v2: 1.5 mm - 0.5 mm z + 0.3 mm z^2 for surfaces that face it (Fankhauser,
   * Bloesch, Rodriguez, Kaestner, Hutter and Siegwart, Kinect v2 for Mobile Robot
   * Navigation: Evaluation and Modeling, ICAR 2015). The Azure Kinect stays below its
   * specified 17 mm up to its 5.5 m (Toelgyessy et al., Evaluation of
   * the Azure Kinect and Its Comparison to Kinect V1 and Kinect V2, Sensors 21, 2021). Light
   * that arrives by way of other surfaces bends corners by more than this error.
   */
  static DepthNoise
  timeOfFlight ()
  {
    return {0.001f, 0.0002f, 5.5f, true};
  }

  /** \brief Active stereo, as RealSense D4xx measure it: 0.5 mm + 3 mm z^2, up to 5 m.
   *
   * D435: 0.61 mm + 3.59 mm (z - 0.35)^2 (Ahn et al., Analysis and Noise Modeling of
   * the Intel RealSense D435 for Mobile Robots, Ubiquitous Robots 2019): 8 cm and more
   * beyond 5 m. Stereo compares windows, whose errors neighbours share.
   */
  static DepthNoise
  activeStereo ()
  {
    return {0.0005f, 0.003f, 5.f, true, 2.5f};
  }
};

} // namespace rgbd_planes
} // namespace pcl
