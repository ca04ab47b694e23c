// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/filters/depth_warp_correction.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace warped_corner {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Correction = pcl::DepthWarpCorrection<pcl::PointXYZ>;
using Models = std::vector<pcl::ModelCoefficients>;
using Inliers = std::vector<pcl::PointIndices>;
using Planes = pcl::rgbd_planes::PlaneVectors;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** The corner of a room as a camera sees it whose inverse depth errs by \a warp, a function
 * of the pixel at VGA: a floor 1.2 m below the camera and walls. */
class Corner {
public:
  explicit Corner (std::uint32_t width,
                   double (*warp) (double u, double v),
                   const Planes& floor_and_walls = threeWalls())
  : planes (floor_and_walls)
  , inliers (floor_and_walls.size())
  {
    cloud->resize (width, width * 3 / 4);
    truth.resize (width, width * 3 / 4);
    const double step = 640. / width;
    for (std::uint32_t row = 0; row < cloud->height; ++row)
      for (std::uint32_t column = 0; column < width; ++column) {
        const double u = (column + 0.5) * step, v = (row + 0.5) * step;
        const Eigen::Vector3d ray ((u - 320.) / 525., (v - 240.) / 525., 1.);
        double inverse_depth = 0.;
        std::size_t seen = 0;
        for (std::size_t k = 0; k < planes.size(); ++k) {
          const Eigen::Vector4d plane = planes[k].cast<double>();
          const double one = -plane.head<3>().dot (ray) / plane[3];
          if (one > inverse_depth) {
            inverse_depth = one;
            seen = k;
          }
        }
        truth (column, row).getVector3fMap() = (ray / inverse_depth).cast<float>();
        (*cloud) (column, row).getVector3fMap() =
            (ray / (inverse_depth + warp (u, v))).cast<float>();
        inliers[seen].indices.push_back (static_cast<int> (row * width + column));
      }
  }

  Models
  models () const
  {
    Models result;
    for (const auto& plane : planes) {
      result.emplace_back();
      result.back().values.assign (plane.data(), plane.data() + 4);
    }
    return result;
  }

  /** Root mean square of the errors in depth, in metres. */
  double
  depthError (const Cloud& points) const
  {
    double squares = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      squares += std::pow (points[i].z - truth[i].z, 2);
    return std::sqrt (squares / static_cast<double> (points.size()));
  }

  static Planes
  threeWalls ()
  {
    return {{0.f, -1.f, 0.f, 1.2f},
            {0.f, 0.f, -1.f, 4.f},
            {0.8f, 0.f, -0.6f, 2.6f},
            {-0.7071f, 0.f, -0.7071f, 3.3f}};
  }

  /** Two walls, whose angle is not a right one by \a skew, in degrees. */
  static Planes
  twoWalls (float skew)
  {
    const float angle =
        std::atan2 (0.8f, -0.6f) - skew * static_cast<float> (M_PI) / 180.f;
    return {{0.f, -1.f, 0.f, 1.2f},
            {0.8f, 0.f, -0.6f, 2.8f},
            {std::cos (angle), 0.f, -std::sin (angle), 3.4f}};
  }

  Planes planes;
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  Cloud truth;
  Inliers inliers;
};

inline double
noWarp (double, double)
{
  return 0.;
}

/** Waves of 300 and 430 pixels, 5 cm at 4 m. */
inline double
waves (double u, double v)
{
  return 0.002 *
         (std::sin (0.0209 * u + 0.3) + std::sin (0.0146 * (0.6 * u + 0.8 * v)));
}

inline Cloud
correctWith (Correction& correction, const Cloud::ConstPtr& cloud)
{
  Cloud output;
  correction.setInputCloud (cloud);
  correction.filter (output);
  return output;
}

inline Cloud
correct (const Corner& corner)
{
  Correction correction;
  EXPECT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  return correctWith (correction, corner.cloud);
}

inline void
expectSameBytes (const Cloud& a, const Cloud& b)
{
  ASSERT_EQ (a.size(), b.size());
  EXPECT_EQ (std::memcmp (a.data(), b.data(), a.size() * sizeof (pcl::PointXYZ)), 0);
}

} // namespace warped_corner
