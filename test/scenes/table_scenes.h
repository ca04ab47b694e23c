// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <Eigen/Geometry>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace table_scenes {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

/** A box in the base frame (x forward, y left, z up), turned about the vertical. */
struct Box {
  Eigen::Vector3f bottom_center;
  Eigen::Vector3f size;
  float yaw = 0.f;
};

struct Camera {
  float height = 1.4f;
  float pitch_down = 0.65f;
  float roll = 0.f;
  std::uint32_t width = 320;
  std::uint32_t image_height = 240;

  Eigen::Affine3f
  toBase () const;
};

/** What a camera sees of boxes, and the planes of their faces. */
struct View {
  Eigen::Affine3f camera_to_base;
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  Normals::Ptr normals = pcl::make_shared<Normals>();
  /** The box that each pixel sees, or -1. */
  std::vector<int> box;
  /** Faces with at least 300 pixels. */
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  /** The plane on top of each box, where it is one. */
  std::map<int, std::size_t> top;

  std::set<pcl::index_t>
  pixelsOf (int which) const;
};

/** The first face of \a box that a ray meets: its distance, and 2 * axis + side. */
std::pair<float, int>
meet (const Box& box, const Eigen::Vector3f& eye, const Eigen::Vector3f& ray);

/** \param[in] noise depth has Gaussian noise of this many times 1 mm + 2 mm z^2 */
View
look (const std::vector<Box>& boxes, const Camera& camera = {}, float noise = 0.f);

} // namespace table_scenes
