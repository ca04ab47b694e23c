// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/impl/sensor_points.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pcl {

/** \brief Measures the depth noise of a camera on frames of any indoor scene, for setDepthNoise
 * of normals, planes, objects and obstacles.
 *
 * \code
 * pcl::DepthNoiseEstimation estimation;
 * estimation.addFrame (*cloud); // some ten frames, with surfaces near and far
 * pcl::rgbd_planes::DepthNoise noise;
 * if (estimation.estimate (noise))
 *   segmentation.setDepthNoise (noise);
 * \endcode
 *
 * A plane is fitted to the inverse ranges in each small block of the image, a fortieth of its
 * longer side, or a tenth of the shorter one where that is less, but at least 8 pixels. What it
 * leaves is the noise where a block sees one smooth surface, as most do, and more at edges and on
 * small things. So the first quartile of blocks at similar ranges counts, and twice that, for
 * larger surfaces come out bent by as much again: on recordings of Kinects, Xtions and a RealSense
 * this gives what DepthNoise::kinectV1 () and activeStereo () have. Not in the paper.
 * Blocks whose points all have one z count only if there are no others: depth is told in steps
 * there that are larger than its noise.
 *
 * Where pixels share their errors, planes of blocks turn by more than those errors would make
 * them if each pixel had its own. The first quartile of turns between a block and the one
 * below, in standard deviations of depth, tells how normals scatter, as so many times that of a
 * Kinect v1. In images of less than 320 columns, blocks are larger, and it is told too small.
 *
 * \ingroup segmentation
 */
class PCL_RGBD_PLANES_EXPORTS DepthNoiseEstimation {
public:
  /** \brief What blocks at similar ranges leave, in metres. */
  struct Level {
    float range;
    std::size_t blocks;
    float sigma;
  };

  /** \brief Adds a frame, of which some 10 kB are kept; false after an error message where it is
   * not organized or empty, or its \c sensor_origin_ is not finite.
   * \param[in] cloud in metres, with the place of the sensor as \c sensor_origin_; in the frame of
   * the camera where depth is told in steps, for only there the points of one step have one z
   */
  template <typename PointT>
  bool
  addFrame (const pcl::PointCloud<PointT>& cloud)
  {
    if (rgbd_planes::isFault ("DepthNoiseEstimation::addFrame",
                              rgbd_planes::faultOfInput (&cloud, nullptr)))
      return false;
    addPoints (rgbd_planes::SensorPoints().of (cloud));
    return true;
  }

  /** \brief Forgets all frames: for another camera. */
  void
  clearFrames ()
  {
    frames_ = 0;
    blocks_.clear();
    blocks_of_one_depth_.clear();
    turns_.clear();
  }

  std::size_t
  getNumberOfFrames () const
  {
    return frames_;
  }

  /** \brief By increasing range, where at least 20 blocks and a hundredth of all are. */
  std::vector<Level>
  getLevels () const;

  /** \brief The noise that fits all levels, no less than 0.1 mm + 0.2 mm z^2, with no limit to the
   * range; false after an error message, and \a noise stays as it is, where there are no levels. */
  bool
  estimate (rgbd_planes::DepthNoise& noise) const;

private:
  void
  addPoints (const rgbd_planes::OrganizedPoints& points);

  /** Ranges, added up, and standard deviations of blocks. */
  struct Blocks {
    double ranges = 0.;
    std::vector<float> sigmas;
  };

  static std::vector<Level>
  levelsOf (const std::map<int, Blocks>& all_blocks);

  std::size_t frames_ = 0;
  /** By steps of range. */
  std::map<int, Blocks> blocks_, blocks_of_one_depth_;
  /** Between blocks and those below. */
  std::vector<float> turns_;
};

} // namespace pcl
