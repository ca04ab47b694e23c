// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/scene_lines.h>
#include <pcl/apps/viewer_frame.h>

#include <array>
#include <bitset>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Something that the viewer shows or not. */
struct ViewerLayer {
  const char* name;
  char key;
  const char* help;
};

enum LayerNumber {
  planes_layer,
  contours_layer,
  normals_layer,
  objects_layer,
  obstacles_layer,
  scan_layer
};

/** \brief All layers, by LayerNumber. */
constexpr std::array<ViewerLayer, 6> viewer_layers{
    {{"planes", 'p', "points in the colours of their planes, grey where there is none"},
     {"contours", 'c', "polygons around the connected parts of planes"},
     {"normals", 'n', "lines that stand on the surfaces"},
     {"objects",
      'o',
      "points, boxes (red: not graspable), hulls below; with obstacles only lines"},
     {"obstacles", 'b', "floor green, obstacles red to yellow, drop-offs blue"},
     {"scan", 'v', "virtual laser scan of the obstacles, yellow posts on the floor"}}};

/** \brief Which layers are shown, by LayerNumber. */
using ViewerLayers = std::bitset<viewer_layers.size()>;

/** \brief The layers of a list of names such as "planes,contours", or of "none"; AppError where
 * a name is unknown. */
ViewerLayers
parseLayers (const std::string& names);

/** \brief The inverse of parseLayers(). */
std::string
layerNames (ViewerLayers layers);

/** \brief The measured points in the colours of \a layers, those of the camera without, or those
 * of their depth where all are black. */
pcl::PointCloud<pcl::PointXYZRGB>
paintCloud (const ViewerFrame& frame, ViewerLayers layers);

/** \brief The lines of \a layers, moved towards the camera by 0.5 %, so that the points of the
 * surfaces they lie on do not hide them. */
std::vector<ColouredLine>
drawLines (const ViewerFrame& frame, ViewerLayers layers);

} // namespace rgbd_planes
} // namespace pcl
