// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace synthetic {

/** A part of the plane through \a point, in the base frame: x forward, y left, z up. */
struct Patch {
  Eigen::Vector3f normal;
  Eigen::Vector3f point;
  std::function<bool (const Eigen::Vector3f&)> covers = [] (const auto&) {
    return true;
  };
};

Patch
floorAt (float height);

/** The six faces of a box. */
std::vector<Patch>
box (const Eigen::Vector3f& min, const Eigen::Vector3f& max);

void
addBox (const Eigen::Vector3f& min,
        const Eigen::Vector3f& max,
        std::vector<Patch>& patches);

/** What a camera with the field of view of a Kinect sees of patches up to 8 m away, with
 * true normals and planes. */
struct FloorScene {
  Eigen::Affine3f camera_to_base;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  pcl::PointCloud<pcl::Normal>::Ptr normals;
  std::vector<pcl::ModelCoefficients> planes; // one for each patch
  pcl::PointCloud<pcl::Label>::Ptr labels;    // the patch of each point

  FloorScene (const std::vector<Patch>& patches,
              const Eigen::Affine3f& pose,
              std::uint32_t width = 160,
              const std::function<float (float)>& sigma = {});

  Eigen::Vector3f
  inBase (std::size_t i) const;

private:
  pcl::ModelCoefficients
  planeOf (const Patch& patch) const;

  void
  see (const std::vector<Patch>& patches, const Eigen::Vector3f& ray, std::size_t i);
};

} // namespace synthetic
