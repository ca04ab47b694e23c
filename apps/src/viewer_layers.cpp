// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/obstacle_pictures.h>
#include <pcl/apps/pictures.h>
#include <pcl/apps/viewer_layers.h>
#include <pcl/segmentation/impl/connected_parts.h>
#include <pcl/segmentation/impl/region_contour.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace pcl {
namespace rgbd_planes {

namespace {

bool
isBlack (const pcl::RGB& colour)
{
  return colour.r == 0 && colour.g == 0 && colour.b == 0;
}

pcl::RGB
darken (const pcl::RGB& colour, float shade)
{
  const auto channel = [&] (std::uint8_t c) {
    return static_cast<std::uint8_t> (shade * static_cast<float> (c));
  };
  return {channel (colour.r), channel (colour.g), channel (colour.b)};
}

Picture
cameraPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  Picture picture = colourPicture (cloud);
  return std::all_of (picture.begin(), picture.end(), isBlack) ? depthPicture (cloud)
                                                               : picture;
}

/** In the colours of their identities. */
Picture
trackedPlanesPicture (const ViewerFrame& frame)
{
  auto labels = frame.segmenter().labels();
  for (auto& point : labels)
    if (point.label != unlabelled)
      point.label = frame.ids()[point.label];
  return planesPicture (frame.cloud(), labels);
}

void
paintObstacles (const ViewerFrame& frame, Picture& picture)
{
  const Picture obstacles = obstaclesPicture (
      frame.cloud(), frame.segmenter().obstacleClasses(), frame.summary().obstacles);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (!isBlack (obstacles[i]))
      picture[i] = obstacles[i];
}

/** In other colours than the planes. */
void
paintObjects (const ViewerFrame& frame, Picture& picture)
{
  const auto& ids = frame.ids();
  const std::uint32_t first =
      ids.empty() ? 0 : *std::max_element (ids.begin(), ids.end()) + 1;
  const auto& objects = frame.summary().objects;
  for (std::size_t k = 0; k < objects.size(); ++k)
    for (const auto i : objects[k].object.indices.indices)
      picture[static_cast<std::size_t> (i)] =
          planeColour (first + static_cast<std::uint32_t> (k));
}

/** Around the connected parts of planes that have as many points as a plane must have; the
 * points are moved onto the plane.
 * \param[in] shade 1 for the colours of the planes, less for darker ones */
void
addContours (const ViewerFrame& frame, float shade, std::vector<ColouredLine>& lines)
{
  const auto& points = frame.segmenter().labels();
  std::vector<std::uint32_t> labels (points.size());
  std::transform (points.begin(), points.end(), labels.begin(), [] (const auto& point) {
    return point.label;
  });
  std::vector<std::uint32_t> same (frame.ids().size());
  std::iota (same.begin(), same.end(), 0u);
  LabelRuns runs;
  runs.find (labels, points.width, same);
  ConnectedParts parts;
  parts.find (runs);
  pcl::Indices contour;
  for (const auto& part : parts.parts()) {
    if (part.pixels < frame.summary().min_inliers)
      continue;
    traceContour (labels, points.width, part.first, contour);
    Eigen::Hyperplane<float, 3> plane;
    plane.coeffs() =
        Eigen::Vector4f (frame.segmenter().models()[part.label].values.data());
    ColouredLine line{darken (planeColour (frame.ids()[part.label]), shade), {}};
    for (const auto i : contour)
      line.points.push_back (plane.projection (
          frame.cloud()[static_cast<std::size_t> (i)].getVector3fMap()));
    line.points.push_back (line.points.front());
    lines.push_back (std::move (line));
  }
}

/** About 60 normals in a row, about as long as the way to the next one. */
void
addNormals (const ViewerFrame& frame, std::vector<ColouredLine>& lines)
{
  const pcl::RGB white (255, 255, 255);
  const auto& cloud = frame.cloud();
  const std::uint32_t step = std::max (1u, cloud.width / 60);
  constexpr float length = 0.03f; // of a normal, for each metre of depth
  for (std::uint32_t v = step / 2; v < cloud.height; v += step)
    for (std::uint32_t u = step / 2; u < cloud.width; u += step) {
      const auto& normal = frame.segmenter().normals() (u, v);
      if (!std::isfinite (normal.normal_x))
        continue;
      const Eigen::Vector3f p = cloud (u, v).getVector3fMap();
      lines.push_back (
          {white, {p, p + length * p.norm() * normal.getNormalVector3fMap()}});
    }
}

void
addObjects (const ViewerFrame& frame, std::vector<ColouredLine>& lines)
{
  for (const auto& support : frame.segmenter().supportPlanes())
    if (!support.is_on_object)
      lines.push_back (hullLine (support, planeColour (frame.ids()[support.index])));
  for (const auto& summary : frame.summary().objects)
    for (auto& edge : boxLines (summary.object))
      lines.push_back (std::move (edge));
}

/** A post on the floor for each direction in which something was seen. */
void
addScan (const ViewerFrame& frame, std::vector<ColouredLine>& lines)
{
  const FrameSummary& summary = frame.summary();
  if (!summary.camera_to_base)
    return;
  const pcl::RGB yellow (255, 255, 60);
  constexpr float height_m = 0.05f;
  const Eigen::Affine3f base_to_camera =
      summary.camera_to_base->inverse (Eigen::Isometry);
  for (std::size_t i = 0; i < summary.scan.ranges.size(); ++i) {
    const float range = summary.scan.ranges[i];
    if (!std::isfinite (range))
      continue;
    const float angle =
        summary.scan.angle_min + static_cast<float> (i) * summary.scan.angle_increment;
    const float x = range * std::cos (angle), y = range * std::sin (angle);
    lines.push_back ({yellow,
                      {base_to_camera * Eigen::Vector3f (x, y, 0.f),
                       base_to_camera * Eigen::Vector3f (x, y, height_m)}});
  }
}

} // namespace

ViewerLayers
parseLayers (const std::string& names)
{
  ViewerLayers layers;
  if (names == "none")
    return layers;
  std::istringstream stream (names);
  for (std::string name; std::getline (stream, name, ',');) {
    const auto* layer = std::find_if (viewer_layers.begin(),
                                      viewer_layers.end(),
                                      [&] (const auto& l) { return l.name == name; });
    if (layer == viewer_layers.end())
      throw AppError ("--show: there is no '" + name + "'; known are " +
                      layerNames (ViewerLayers().set()) + ", or none");
    layers.set (static_cast<std::size_t> (layer - viewer_layers.begin()));
  }
  return layers;
}

std::string
layerNames (ViewerLayers layers)
{
  std::string names;
  for (std::size_t k = 0; k < layers.size(); ++k)
    if (layers[k])
      names += (names.empty() ? "" : ",") + std::string (viewer_layers[k].name);
  return names.empty() ? "none" : names;
}

pcl::PointCloud<pcl::PointXYZRGB>
paintCloud (const ViewerFrame& frame, ViewerLayers layers)
{
  Picture picture = layers[planes_layer] ? trackedPlanesPicture (frame)
                                         : cameraPicture (frame.cloud());
  // Their colours mean nothing, those of obstacles do.
  if (layers[obstacles_layer])
    paintObstacles (frame, picture);
  else if (layers[objects_layer])
    paintObjects (frame, picture);
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (std::isfinite (frame.cloud()[i].z)) {
      cloud.push_back (frame.cloud()[i]);
      cloud.back().rgba = picture[i].rgba;
    }
  return cloud;
}

std::vector<ColouredLine>
drawLines (const ViewerFrame& frame, ViewerLayers layers)
{
  constexpr float towards_camera = 0.995f;
  std::vector<ColouredLine> lines;
  if (layers[contours_layer])
    addContours (frame, layers[planes_layer] ? 0.5f : 1.f, lines);
  if (layers[normals_layer])
    addNormals (frame, lines);
  if (layers[objects_layer])
    addObjects (frame, lines);
  if (layers[scan_layer])
    addScan (frame, lines);
  for (auto& line : lines)
    for (auto& point : line.points)
      point *= towards_camera;
  return lines;
}

} // namespace rgbd_planes
} // namespace pcl
