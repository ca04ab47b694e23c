// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "organized_ball_search.h"
#include "two_run_plane.h"

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/threads.h>
#include <pcl/features/impl/two_run_normals.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Fewer points are not worth a thread. */
constexpr std::size_t part_size = 256;

/** Finds the neighbours of a place, point \a index of the cloud, within a radius. */
using NeighbourSearch = std::function<void (
    int index, const float* place, float radius, std::vector<int>& found)>;

NeighbourSearch
searchImage (const OrganizedPoints& surface)
{
  const auto search = std::make_shared<OrganizedBallSearch>();
  search->setPoints (surface);
  return [search] (int, const float* place, float radius, std::vector<int>& found) {
    search->search (place, radius, found);
  };
}

NeighbourSearch
searchTree (const OrganizedPoints& surface)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto measured = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const float* p = surface[i];
    cloud->emplace_back (p[0], p[1], p[2]);
    // Farther ones overflow in FLANN.
    if (isMeasured (p) && squaredRange (p) <= DepthNoise::max_squared_range)
      measured->push_back (static_cast<pcl::index_t> (i));
  }
  if (measured->empty())
    return [] (int, const float*, float, std::vector<int>& found) { found.clear(); };

  const auto tree = std::make_shared<pcl::KdTreeFLANN<pcl::PointXYZ>> (false);
  tree->setInputCloud (cloud, measured);
  return [tree] (int, const float* place, float radius, std::vector<int>& found) {
    std::vector<float> squared_distances;
    tree->radiusSearch (
        {place[0], place[1], place[2]}, radius, found, squared_distances);
  };
}

NeighbourSearch
searchWindow (const OrganizedPoints& points, int window_size)
{
  const int half = window_size / 2;
  return [points,
          half] (int index, const float* place, float radius, std::vector<int>& found) {
    found.clear();
    const int u = index % points.width, v = index / points.width;
    const int right = std::min (u + half, points.width - 1);
    const int bottom = std::min (v + half, points.height - 1);
    const Eigen::Vector3f centre = Eigen::Vector3f::Map (place);
    for (int row = std::max (v - half, 0); row <= bottom; ++row)
      for (int column = std::max (u - half, 0); column <= right; ++column) {
        const int i = row * points.width + column;
        const float* p = points[static_cast<std::size_t> (i)];
        if (isMeasured (p) &&
            (Eigen::Vector3f::Map (p) - centre).squaredNorm() < radius * radius)
          found.push_back (i);
      }
  };
}

/** What a thread needs for one normal after the other. */
struct Workspace {
  std::vector<int> found;
  std::vector<Eigen::Vector3f> neighbours;
};

bool
normalAt (int index,
          const float* place,
          const OrganizedPoints& surface,
          const NeighbourSearch& search,
          const TwoRunNormalParameters& parameters,
          Workspace& workspace,
          LocalPlane& plane)
{
  if (!isMeasured (place))
    return false;
  const Eigen::Vector3f p = Eigen::Vector3f::Map (place);
  const Eigen::Vector3f from_sensor =
      p - Eigen::Vector3f::Map (parameters.sensor_origin.data());
  const float z = std::abs (
      from_sensor.dot (Eigen::Vector3f::Map (parameters.viewing_axis.data())));
  const float radius = parameters.radius (z);
  if (!(radius > 0.f))
    return false;

  search (index, place, radius, workspace.found);
  workspace.neighbours.clear();
  for (const int i : workspace.found)
    workspace.neighbours.push_back (
        Eigen::Vector3f::Map (surface[static_cast<std::size_t> (i)]) - p);
  if (!fitPlaneInTwoRuns (workspace.neighbours, plane))
    return false;
  if (plane.normal.dot (from_sensor) > 0.f)
    plane.normal = -plane.normal;
  return true;
}

} // namespace

std::size_t
computeTwoRunNormals (const OrganizedPoints& points,
                      const std::vector<int>& indices,
                      const OrganizedPoints& surface,
                      const TwoRunNormalParameters& parameters,
                      const NormalOutput& output)
{
  const NeighbourSearch search = parameters.window_size > 0
                                     ? searchWindow (points, parameters.window_size)
                                 : surface.height > 1 ? searchImage (surface)
                                                      : searchTree (surface);
  const std::size_t parts = (indices.size() + part_size - 1) / part_size;
  const int threads = static_cast<int> (std::clamp<std::size_t> (
      numberOfThreads (parameters.threads), 1, std::max<std::size_t> (parts, 1)));
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t valid = 0;
  // Those of memory that is short, or of the radius, must not leave a parallel region.
  std::exception_ptr exception;
#pragma omp parallel num_threads(threads) reduction(+ : valid)
  {
    Workspace workspace;
#pragma omp for schedule(dynamic, part_size)
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const float* place = points[static_cast<std::size_t> (indices[i])];
      LocalPlane plane{{nan, nan, nan}, nan};
      try {
        valid +=
            normalAt (indices[i], place, surface, search, parameters, workspace, plane);
      }
      catch (...) {
#pragma omp critical
        exception = std::current_exception();
      }
      std::copy_n (plane.normal.data(), 3, output.normal + i * output.stride);
      output.curvature[i * output.stride] = plane.curvature;
    }
  }
  if (exception)
    std::rethrow_exception (exception);
  return valid;
}

} // namespace rgbd_planes
} // namespace pcl
