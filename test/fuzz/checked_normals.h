// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "any_settings.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/features/normal_spherical.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace fuzz {

using Normals = pcl::PointCloud<pcl::Normal>;

/** Stops unless normals have unit length, or are NaN and the cloud says so. */
inline void
expectNormals (const Normals& normals)
{
  for (const auto& n : normals) {
    const bool is_valid = pcl::isNormalFinite (n);
    expect (is_valid ? std::fabs (n.getNormalVector3fMap().norm() - 1.f) < 1e-3f
                     : std::isnan (n.normal_x) && std::isnan (n.normal_y) &&
                           std::isnan (n.normal_z) && std::isnan (n.curvature));
    expect (is_valid || !normals.is_dense);
  }
}

template <typename Estimation, typename CloudPtr, typename Output>
void
estimate (Estimation& estimation,
          const CloudPtr& cloud,
          const pcl::IndicesPtr& indices,
          Output& normals)
{
  estimation.setIndices (indices);
  estimation.setInputCloud (cloud);
  estimation.compute (normals);
}

/** Angles stay in their ranges, whatever the normals are. */
inline void
expectSpherical (const synthetic::Cloud& cloud, const Normals& normals)
{
  constexpr double pi = 3.14159275; // as a float, which is a little more
  pcl::PointCloud<pcl::NormalSpherical> spherical;
  if (!pcl::computeNormalsSpherical (cloud, normals, spherical))
    return;
  for (const auto& s : spherical)
    expect (std::isnan (s.phi) ||
            (std::fabs (s.phi) <= pi && std::fabs (s.theta) <= pi / 2));
}

/** Normals of images one after the other, which are compared with those of an estimator that has
 * seen no image before, with other threads, from points and to normals with other fields: they
 * must be the same, bit by bit. */
class CheckedNormals {
public:
  void
  change (FuzzedDataProvider& data)
  {
    const auto bytes = data.ConsumeBytes<std::uint8_t> (64);
    FuzzedDataProvider settings (bytes.data(), bytes.size());
    setAny (settings, estimation_);
    FuzzedDataProvider same_settings (bytes.data(), bytes.size());
    setAny (same_settings, unused_);
  }

  void
  compute (const synthetic::Cloud::ConstPtr& cloud,
           const pcl::IndicesPtr& indices,
           Normals& normals)
  {
    estimate (estimation_, cloud, indices, normals);
    expectNormals (normals);
    if (!cloud || normals.empty())
      return;

    const auto points = pcl::make_shared<pcl::PointCloud<Point>>();
    pcl::copyPointCloud (*cloud, *points);
    auto estimation = unused_;
    estimation.setNumberOfThreads (4);
    pcl::PointCloud<Point> others;
    estimate (estimation, points, indices, others);
    expect (others.size() == normals.size() && others.is_dense == normals.is_dense);
    for (std::size_t i = 0; i < others.size(); ++i)
      expect (
          std::memcmp (others[i].normal, normals[i].normal, 3 * sizeof (float)) == 0 &&
          std::memcmp (&others[i].curvature, &normals[i].curvature, sizeof (float)) ==
              0);
  }

private:
  using Point = pcl::PointXYZRGBNormal;

  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation_;
  pcl::IntegralImageTangentNormalEstimation<Point, Point> unused_;
};

inline void
setAny (FuzzedDataProvider& data, CheckedNormals& estimation)
{
  estimation.change (data);
}

} // namespace fuzz
