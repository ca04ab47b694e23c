// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/segmentation/supported_object_extraction.h>
#include <pcl/simulation/simulate.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief An object as it was found. */
struct FoundObject {
  pcl::Indices indices;
  /** Sides of its box, height last; metres. */
  Eigen::Vector3f size = Eigen::Vector3f::Zero();
  bool graspable = false;
};

std::vector<FoundObject>
foundObjects (const std::vector<pcl::SupportedObject>& objects);

/** \brief The objects of a frame as they truly are. */
struct ObjectTruth {
  /** The object of each point, 0 for none. */
  std::vector<std::uint32_t> ids;
  /** Sizes, where they are known; empty otherwise. */
  std::vector<TrueObject> objects;
  /** Ids of those with another one within 2 cm. */
  std::set<std::uint32_t> touching;
  /** Ids of those that ObjectEvaluation asks for in the image of full resolution. */
  std::set<std::uint32_t> full_size;
};

/** \brief Objects of one kind: how many there are, how many of them were found with an
 * intersection over union of points of at least 0.5 and 0.8, and how many are in pieces: two or
 * more clusters have at least half of their points on them. */
struct ObjectCounts {
  std::size_t objects = 0;
  std::size_t found_50 = 0;
  std::size_t found_80 = 0;
  std::size_t in_pieces = 0;

  ObjectCounts&
  operator+= (const ObjectCounts& other);
};

/** \brief Finds out which objects touch another one and which are asked for, in an image of full
 * resolution: with fewer points, those that touch would seem to stand apart.
 * \param[in] points as measured; only measured points count
 * \param[in] positions where the points truly are, or \a points where this is unknown
 */
void
lookAtFullSize (const OrganizedPoints& points,
                const OrganizedPoints& positions,
                ObjectTruth& truth);

/** \brief How well found objects match true ones, pooled over frames.
 *
 * Objects are asked for when they have at least 50 measured points, their centre is within 3.5 m
 * of the camera, and they are 1 to 30 cm high where this is known: what is higher is no object
 * but an obstacle (Holz et al. 2011, sections 5.1 and 6). A found object is false when less than
 * half of its points lie on any object, asked for or not.
 */
class ObjectEvaluation {
public:
  /** \param[in] points as measured; only measured points count
   * \param[in] positions where the points truly are, or \a points where this is unknown
   */
  void
  add (const OrganizedPoints& points,
       const OrganizedPoints& positions,
       const ObjectTruth& truth,
       const std::vector<FoundObject>& found);

  ObjectCounts apart;
  ObjectCounts touching;
  /** Those that are asked for at full resolution, few as their points may be here. */
  std::size_t full_size_objects = 0;
  /** Of these, with an intersection over union of at least 0.5. */
  std::size_t full_size_found = 0;
  std::size_t found = 0;
  std::size_t false_objects = 0;
  /** Of objects apart that were found and whose size is known. */
  std::size_t sized = 0;
  /** Of \ref sized, those whose graspable flag is right: smallest side 1 to 10 cm. */
  std::size_t graspable_right = 0;
  /** Boxes among \ref sized. */
  std::size_t boxes = 0;
  /** Of \ref boxes, those whose three sides are right within 1 cm or 10 %. */
  std::size_t boxes_right = 0;
  /** Of \ref boxes, those whose measured points are spread, within 1 cm or 10 %, over both
   * horizontal sides and up to the top: no part that matters is hidden behind another object,
   * in a shadow of the sensor, or outside of the image. */
  std::size_t boxes_seen = 0;
  /** Of \ref boxes_seen, those whose three sides are right within 1 cm or 10 %. */
  std::size_t boxes_seen_right = 0;

  ObjectCounts
  all () const;

  /** \brief Points of false objects, in percent of the measured points; NaN where there are
   * none. */
  double
  falsePointsPercent () const;

private:
  void
  countSize (const TrueObject& object,
             const std::vector<Eigen::Vector3f>& positions,
             const FoundObject& found);

  std::size_t measured_ = 0;
  std::size_t false_points_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
