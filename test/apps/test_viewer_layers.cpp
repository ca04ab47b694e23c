// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "viewer_scene.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/pictures.h>
#include <pcl/apps/viewer_layers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

using namespace pcl::rgbd_planes;
using viewer_scene::operator==;

namespace {

class ViewerLayersTest : public testing::Test {
protected:
  ViewerLayersTest() { frame_.compute (viewer_scene::makeFrame(), 1); }

  pcl::PointCloud<pcl::PointXYZRGB>
  paint (const std::string& layers) const
  {
    return paintCloud (frame_, parseLayers (layers));
  }

  std::vector<ColouredLine>
  draw (const std::string& layers) const
  {
    return drawLines (frame_, parseLayers (layers));
  }

  /** The share of the points of a surface that have a colour. */
  double
  share (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
         viewer_scene::Surface surface,
         const pcl::RGB& colour) const
  {
    double all = 0., coloured = 0.;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (scene_.surface[i] == surface) {
        all += 1.;
        coloured += pcl::RGB (cloud[i].r, cloud[i].g, cloud[i].b) == colour;
      }
    return coloured / all;
  }

  /** The colour of a point in the middle of each surface. */
  static pcl::RGB
  colourOf (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
            viewer_scene::Surface surface)
  {
    const int rows[] = {440, 100, 360};
    const auto& point = cloud[static_cast<std::size_t> (640 * rows[surface] + 320)];
    return {point.r, point.g, point.b};
  }

  const synthetic::Scene scene_ = viewer_scene::render();
  ViewerFrame frame_{viewer_scene::cameraToBase()};
};

/** Undoes what drawLines() does that lines are seen. */
Eigen::Vector3f
onSurface (const Eigen::Vector3f& point)
{
  return point / 0.995f;
}

} // namespace

TEST_F (ViewerLayersTest, HaveNames)
{
  const ViewerLayers layers = parseLayers ("scan,planes");
  EXPECT_EQ (layers.count(), 2u);
  EXPECT_TRUE (layers[planes_layer] && layers[scan_layer]);
  EXPECT_EQ (layerNames (layers), "planes,scan");
  EXPECT_TRUE (parseLayers ("none").none());
  EXPECT_EQ (layerNames (ViewerLayers()), "none");
  EXPECT_TRUE (parseLayers (layerNames (ViewerLayers().set())).all());
  EXPECT_THROW (parseLayers ("planes,walls"), AppError);
  EXPECT_THROW (parseLayers ("planes,,scan"), AppError);
}

TEST_F (ViewerLayersTest, WithoutAnyTheCameraIsSeen)
{
  const auto cloud = paint ("none");
  ASSERT_EQ (cloud.size(), scene_.surface.size());
  for (const auto surface :
       {viewer_scene::floor, viewer_scene::wall, viewer_scene::box})
    EXPECT_EQ (share (cloud, surface, viewer_scene::camera_colour), 1.);
  EXPECT_TRUE (draw ("none").empty());
}

TEST_F (ViewerLayersTest, DepthIsSeenWhereThereIsNoColour)
{
  auto frame = viewer_scene::makeFrame();
  for (auto& point : *frame.cloud)
    point.rgba = pcl::RGB (0, 0, 0).rgba;
  frame_.compute (frame, 1);
  const auto cloud = paint ("none");
  const auto wall = colourOf (cloud, viewer_scene::wall);
  EXPECT_GT (wall.r + wall.g + wall.b, 0);
  EXPECT_FALSE (wall == colourOf (cloud, viewer_scene::box));
}

TEST_F (ViewerLayersTest, UnmeasuredPointsAreLeftOut)
{
  const auto frame = viewer_scene::makeFrame();
  for (std::size_t i = 0; i < 6400; ++i)
    (*frame.cloud)[i].x = (*frame.cloud)[i].y = (*frame.cloud)[i].z = NAN;
  frame_.compute (frame, 1);
  EXPECT_EQ (paint ("planes").size(), frame.cloud->size() - 6400);
}

TEST_F (ViewerLayersTest, PlanesHaveColoursThatStay)
{
  const auto cloud = paint ("planes");
  std::map<viewer_scene::Surface, pcl::RGB> colours;
  for (const auto surface :
       {viewer_scene::floor, viewer_scene::wall, viewer_scene::box}) {
    colours[surface] = colourOf (cloud, surface);
    EXPECT_GT (share (cloud, surface, colours[surface]), 0.98) << surface;
    for (const auto other :
         {viewer_scene::floor, viewer_scene::wall, viewer_scene::box})
      EXPECT_TRUE (other >= surface || !(colours[other] == colours[surface]));
  }

  // The wall is nearly hidden, so that the floor is the largest plane now.
  auto frame = viewer_scene::makeFrame();
  for (std::size_t i = 0; i < 640 * 300; ++i)
    (*frame.cloud)[i].x = (*frame.cloud)[i].y = (*frame.cloud)[i].z = NAN;
  frame_.compute (frame, 1);
  const auto next = paint ("planes");
  const auto& point = next[next.size() - 640 * 40];
  EXPECT_TRUE (pcl::RGB (point.r, point.g, point.b) == colours[viewer_scene::floor]);
  frame_.compute (viewer_scene::makeFrame(), 2);
  const auto coarse = paint ("planes")[320 * 220 + 160];
  EXPECT_TRUE (pcl::RGB (coarse.r, coarse.g, coarse.b) == colours[viewer_scene::floor])
      << "at another resolution";
}

TEST_F (ViewerLayersTest, TheFloorIsFreeOfObstacles)
{
  const pcl::RGB green (40, 110, 50);
  const auto cloud = paint ("obstacles");
  EXPECT_GT (share (cloud, viewer_scene::floor, green), 0.99);
  // What is nearly as low as the floor may be taken for it.
  constexpr float highest_y = viewer_scene::camera_height - 0.04f;
  int safe = 0;
  for (const auto& point : cloud)
    safe += point.y < highest_y && pcl::RGB (point.r, point.g, point.b) == green;
  EXPECT_EQ (safe, 0);
  for (const auto surface : {viewer_scene::wall, viewer_scene::box}) {
    const auto colour = colourOf (cloud, surface);
    EXPECT_TRUE (colour.r > colour.g && colour.b == 0) << "red to yellow";
  }
}

TEST_F (ViewerLayersTest, ObjectsHaveColoursOfTheirOwnAndBoxes)
{
  ASSERT_EQ (frame_.summary().objects.size(), 1u);
  const auto planes = paint ("planes"), both = paint ("planes,objects");
  const auto colour = colourOf (both, viewer_scene::box);
  for (const auto surface :
       {viewer_scene::floor, viewer_scene::wall, viewer_scene::box})
    EXPECT_FALSE (colour == colourOf (planes, surface));
  EXPECT_GT (share (both, viewer_scene::box, colour), 0.9);

  int edges = 0;
  for (const auto& line : draw ("objects")) {
    const bool is_edge = line.points.size() == 2;
    edges += is_edge;
    for (const auto& point : line.points) {
      const Eigen::Vector3f p = onSurface (point);
      if (is_edge) {
        EXPECT_NEAR (std::fabs (p.x()), 0.15f, 0.02f);
        EXPECT_NEAR (p.z(), viewer_scene::box_distance, 0.05f);
        EXPECT_TRUE (std::fabs (p.y() - viewer_scene::camera_height) < 0.02f ||
                     std::fabs (p.y() - (viewer_scene::camera_height - 0.255f)) < 0.02f)
            << p.y();
      }
      else
        EXPECT_NEAR (p.y(), viewer_scene::camera_height, 0.01f) << "hull of the floor";
    }
  }
  EXPECT_EQ (edges, 12);
}

TEST_F (ViewerLayersTest, ObstaclesKeepTheirColoursWhereObjectsAreShown)
{
  const auto alone = paint ("obstacles"), both = paint ("obstacles,objects");
  ASSERT_EQ (alone.size(), both.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    ASSERT_EQ (alone[i].rgba, both[i].rgba) << i;
}

TEST_F (ViewerLayersTest, ContoursGoAroundThePlanes)
{
  const auto lines = draw ("contours");
  ASSERT_EQ (lines.size(), 3u);
  const auto cloud = paint ("planes");
  for (const auto surface :
       {viewer_scene::floor, viewer_scene::wall, viewer_scene::box}) {
    const auto line = std::find_if (lines.begin(), lines.end(), [&] (const auto& l) {
      return l.colour == colourOf (cloud, surface);
    });
    ASSERT_NE (line, lines.end()) << surface;
    EXPECT_EQ (line->points.front(), line->points.back());
    float left = 0.f, right = 0.f;
    for (const auto& point : line->points) {
      const Eigen::Vector3f p = onSurface (point);
      left = std::min (left, p.x() / p.z());
      right = std::max (right, p.x() / p.z());
      const float truth = surface == viewer_scene::floor  ? viewer_scene::camera_height
                          : surface == viewer_scene::wall ? viewer_scene::wall_distance
                                                          : viewer_scene::box_distance;
      EXPECT_NEAR (surface == viewer_scene::floor ? p.y() : p.z(), truth, 0.01f);
    }
    const float half = (surface == viewer_scene::box ? 40.f : 320.f) / 525.f;
    EXPECT_NEAR (left, -half, 0.01f) << surface;
    EXPECT_NEAR (right, half, 0.01f) << surface;
  }
  const auto darker = draw ("planes,contours");
  EXPECT_EQ (darker[0].colour.r, lines[0].colour.r / 2) << "to be seen on the planes";
}

TEST_F (ViewerLayersTest, NormalsStandOnSurfaces)
{
  const auto lines = draw ("normals");
  EXPECT_GT (lines.size(), 2000u);
  std::size_t right = 0;
  for (const auto& line : lines) {
    ASSERT_EQ (line.points.size(), 2u);
    const Eigen::Vector3f normal = line.points[1] - line.points[0];
    const bool on_floor = std::fabs (onSurface (line.points[0]).y() -
                                     viewer_scene::camera_height) < 1e-3f;
    const Eigen::Vector3f truth =
        on_floor ? -Eigen::Vector3f::UnitY() : -Eigen::Vector3f::UnitZ();
    right += synthetic::angleDegrees (normal, truth) < 3.f;
  }
  EXPECT_GT (static_cast<double> (right), 0.95 * static_cast<double> (lines.size()));
}

TEST_F (ViewerLayersTest, TheScanEndsAtObstacles)
{
  const auto lines = draw ("scan");
  int at_box = 0, at_wall = 0;
  for (const auto& line : lines) {
    const Eigen::Vector3f foot = onSurface (line.points.at (0));
    EXPECT_NEAR (foot.y(), viewer_scene::camera_height, 0.005f);
    const bool is_box = std::fabs (foot.x() / foot.z()) < 0.07f;
    const bool is_wall = std::fabs (foot.x() / foot.z()) > 0.08f;
    at_box += is_box;
    at_wall += is_wall;
    if (is_box || is_wall) {
      EXPECT_NEAR (foot.z(),
                   is_box ? viewer_scene::box_distance : viewer_scene::wall_distance,
                   0.03f);
    }
  }
  EXPECT_GT (at_box, 10);
  EXPECT_GT (at_wall, 80);
}

TEST_F (ViewerLayersTest, PointsTellTheirPlane)
{
  const std::string text = frame_.describePlane ({0.3f, -0.2f, 3.01f});
  unsigned id = 0, points = 0;
  double a = 0., b = 0., c = 0., d = 0., rms = 0.;
  char plane_class[10] = "";
  ASSERT_EQ (std::sscanf (text.c_str(),
                          "plane %u: %lf x %lf y %lf z %lf = 0, %u points, rms %lf mm, "
                          "%9s",
                          &id,
                          &a,
                          &b,
                          &c,
                          &d,
                          &points,
                          &rms,
                          plane_class),
             8)
      << text;
  EXPECT_TRUE (planeColour (id) == colourOf (paint ("planes"), viewer_scene::wall));
  EXPECT_NEAR (a, 0., 1e-3);
  EXPECT_NEAR (b, 0., 1e-3);
  EXPECT_NEAR (c, -1., 1e-3);
  EXPECT_NEAR (d, viewer_scene::wall_distance, 5e-3);
  const auto of_wall =
      std::count (scene_.surface.begin(), scene_.surface.end(), viewer_scene::wall);
  EXPECT_NEAR (points, of_wall, 0.02 * static_cast<double> (of_wall));
  EXPECT_LT (rms, 1.);
  EXPECT_STREQ (plane_class, "wall");
  EXPECT_NE (frame_.describePlane ({0.f, 0.6f, 1.6f}).find (", floor"),
             std::string::npos);
  EXPECT_EQ (ViewerFrame (std::nullopt).describePlane ({0.f, 0.f, 1.f}),
             "no point here");
}

TEST_F (ViewerLayersTest, BeyondTheRangeOfTheSensorAreNoPlanes)
{
  const DepthNoise noise{0.001f, 0.002f, 0.9f * viewer_scene::wall_distance};
  ViewerFrame frame (viewer_scene::cameraToBase(), std::nullopt, noise);
  frame.compute (viewer_scene::makeFrame(), 1);
  EXPECT_EQ (frame.describePlane ({0.f, 0.f, viewer_scene::wall_distance}),
             "no plane here");
}

TEST_F (ViewerLayersTest, FramesWithoutPlanesAreShown)
{
  auto frame = viewer_scene::makeFrame();
  for (auto& point : *frame.cloud)
    point.x = point.y = point.z = NAN;
  frame_.compute (frame, 1);
  EXPECT_TRUE (paintCloud (frame_, ViewerLayers().set()).empty());
  EXPECT_TRUE (drawLines (frame_, ViewerLayers().set()).empty());
  EXPECT_EQ (frame_.describePlane ({0.f, 0.f, 1.f}), "no point here");
}

TEST_F (ViewerLayersTest, FramesMayBeTooSmall)
{
  Frame frame;
  frame.name = "row";
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (640, 1);
  EXPECT_THROW (frame_.compute (frame, 1), AppError);
  EXPECT_THROW (frame_.compute (viewer_scene::makeFrame(), 480), AppError);
}
