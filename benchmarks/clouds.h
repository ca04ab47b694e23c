// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Clouds = std::vector<Cloud::ConstPtr>;

/** \brief Where the camera of each frame is, where this is known. */
using BaseTransforms = std::vector<std::optional<Eigen::Affine3f>>;

/** \brief All frames of all inputs, and their \a camera_to_base. AppError where they are not of
 * one size, or too small for a method at a quarter of it. */
Clouds
readClouds (const std::vector<InputOptions>& inputs, BaseTransforms& camera_to_base);

/** \brief Every step-th pixel of every step-th row of each cloud. */
Clouds
subsample (const Clouds& clouds, std::uint32_t step);

/** \brief What a camera of that many pixels sees of the surfaces of \a cloud, by
 * bilinear interpolation; missing points leave gaps between their neighbours. */
Cloud::ConstPtr
resample (const Cloud& cloud, std::uint32_t width, std::uint32_t height);

} // namespace rgbd_planes
} // namespace pcl
