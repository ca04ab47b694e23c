// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief A picture, row by row from the top. */
using Picture = pcl::PointCloud<pcl::RGB>;

/** \brief The colour of plane \a id: the same in every picture, and well apart from
 * those of the 20 planes around it, black and grey. */
pcl::RGB
planeColour (std::uint32_t id);

/** \brief What the camera sees. */
Picture
colourPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud);

/** \brief The planes of a frame: each in its planeColour(), black where depth is
 * missing, grey where there is no plane.
 * \param[in] cloud an organized cloud, NaN where depth is missing
 * \param[in] labels the plane of each point
 */
Picture
planesPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
               const pcl::PointCloud<pcl::Label>& labels);

/** \brief Normals as colours: x, y and z from -1 to 1 are red, green and blue from 0 to
 * 255; black where there is no normal. */
Picture
normalsPicture (const pcl::PointCloud<pcl::Normal>& normals);

/** \brief Depth (z) from yellow (near) to blue (far), black where it is missing. The
 * colours span the nearest to the farthest 2 % of the points of the frame. */
Picture
depthPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud);

/** \brief A warp of inverse depth: white where there is none, red where it makes depth too small,
 * blue where too large, full colours from 0.01 1/m on, which is 4 cm at 2 m. */
Picture
warpPicture (const pcl::PointCloud<pcl::Intensity>& warp);

/** \brief The bytes of an 8-bit RGB PNG file. */
std::string
encodePng (const Picture& picture);

} // namespace rgbd_planes
} // namespace pcl
