// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/project_onto_planes.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <random>

using pcl::rgbd_planes::WarpedPlaneFit;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Planes = WarpedPlaneFit::Planes;

namespace {

constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

/** The corner of a room as a camera sees it whose inverse depth errs by \a warp, a function
 * of the pixel at VGA: a floor 1.2 m below the camera and three walls. */
class Corner {
public:
  explicit Corner (std::uint32_t width, double (*warp) (double u, double v))
  {
    cloud->resize (width, width * 3 / 4);
    const double step = 640. / width;
    for (std::uint32_t row = 0; row < cloud->height; ++row)
      for (std::uint32_t column = 0; column < width; ++column) {
        const double u = (column + 0.5) * step, v = (row + 0.5) * step;
        const Eigen::Vector3d ray ((u - 320.) / 525., (v - 240.) / 525., 1.);
        double inverse_depth = 0.;
        std::uint32_t seen = no_plane;
        for (std::size_t k = 0; k < planes.size(); ++k) {
          const Eigen::Vector4d plane = planes[k].cast<double>();
          const double one = -plane.head<3>().dot (ray) / plane[3];
          if (one > inverse_depth) {
            inverse_depth = one;
            seen = static_cast<std::uint32_t> (k);
          }
        }
        (*cloud) (column, row).getVector3fMap() =
            (ray / (inverse_depth + warp (u, v))).cast<float>();
        labels.push_back (seen);
      }
  }

  pcl::rgbd_planes::OrganizedPoints
  points () const
  {
    return {&cloud->front().x,
            4,
            static_cast<int> (cloud->width),
            static_cast<int> (cloud->height)};
  }

  /** What least squares makes of each plane by itself. */
  Planes
  fitOneByOne () const
  {
    Planes fits;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] == k) {
          const Eigen::Vector3d p = (*cloud)[i].getVector3fMap().cast<double>();
          squares += p * p.transpose() / (p.z() * p.z());
          right += p / (p.z() * p.z());
        }
      const Eigen::Vector3d m = squares.inverse() * right;
      Eigen::Vector4d plane;
      plane << -m, 1.;
      fits.push_back ((plane / m.norm()).cast<float>());
    }
    return fits;
  }

  /** Root mean square of the errors in depth of points on \a fits, in metres. */
  double
  depthError (const Planes& fits) const
  {
    double squares = 0.;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const Eigen::Vector3f p = (*cloud)[i].getVector3fMap();
      const auto depthOn = [&] (const Eigen::Vector4f& plane) {
        return -plane[3] / plane.head<3>().dot (p) * p.z();
      };
      squares += std::pow (depthOn (fits[labels[i]]) - depthOn (planes[labels[i]]), 2);
    }
    return std::sqrt (squares / static_cast<double> (labels.size()));
  }

  Planes planes{{0.f, -1.f, 0.f, 1.2f},
                {0.f, 0.f, -1.f, 4.f},
                {0.8f, 0.f, -0.6f, 2.6f},
                {-0.7071f, 0.f, -0.7071f, 3.3f}};
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  std::vector<std::uint32_t> labels;
};

double
noWarp (double, double)
{
  return 0.;
}

/** Waves of 300 and 430 pixels, 5 cm at 4 m. */
double
waves (double u, double v)
{
  return 0.002 *
         (std::sin (0.0209 * u + 0.3) + std::sin (0.0146 * (0.6 * u + 0.8 * v)));
}

Planes
fitTogether (const Corner& corner, const Planes& planes)
{
  Planes result = planes;
  WarpedPlaneFit().compute (
      corner.points(), corner.labels, pcl::rgbd_planes::DepthNoise(), result);
  return result;
}

} // namespace

TEST (WarpedPlaneFit, PlanesThatShareAWarpAreBetterTogether)
{
  for (const std::uint32_t width : {640u, 320u, 160u}) {
    const Corner corner (width, waves);
    const Planes alone = corner.fitOneByOne();
    const double before = corner.depthError (alone);
    EXPECT_GT (before, 0.01);
    EXPECT_LT (corner.depthError (fitTogether (corner, alone)), before / 4.) << width;
  }
}

TEST (WarpedPlaneFit, WithoutWarpPlanesStay)
{
  const Corner corner (320, noWarp);
  const Planes fits = fitTogether (corner, corner.planes);
  EXPECT_LT (corner.depthError (fits), 1e-4);
  for (std::size_t k = 0; k < fits.size(); ++k)
    EXPECT_LT ((fits[k] - corner.planes[k]).norm(), 1e-4f) << k;
}

TEST (WarpedPlaneFit, ThePlanesThatAreGivenNeedNotBeGood)
{
  const Corner corner (320, noWarp);
  Planes planes = corner.planes;
  for (auto& plane : planes) {
    plane[3] *= 1.01f;
    plane.head<3>() =
        Eigen::AngleAxisf (0.02f, Eigen::Vector3f::UnitY()) * plane.head<3>();
  }
  EXPECT_GT (corner.depthError (planes), 0.03);
  EXPECT_LT (corner.depthError (fitTogether (corner, planes)), 0.003);
}

TEST (WarpedPlaneFit, NormalsKeepTheirSides)
{
  const Corner corner (320, waves);
  Planes planes = corner.fitOneByOne();
  planes[1] = -planes[1];
  const Planes fits = fitTogether (corner, planes);
  for (std::size_t k = 0; k < fits.size(); ++k) {
    EXPECT_GT (fits[k].head<3>().dot (planes[k].head<3>()), 0.99f) << k;
    EXPECT_NEAR (fits[k].head<3>().norm(), 1.f, 1e-5f);
  }
}

TEST (WarpedPlaneFit, SmallPlanesAndWhatIsNoneStay)
{
  Corner corner (320, waves);
  corner.planes.push_back ({0.f, 0.f, -1.f, 2.f});
  for (std::size_t v = 0; v < 16; ++v) // 4 x 4 cells
    for (std::size_t u = 0; u < 16; ++u)
      corner.labels[v * 320 + u] = 4;
  corner.planes.push_back ({0.f, 0.f, -1.f, 0.f});
  for (std::size_t v = 0; v < 40; ++v)
    for (std::size_t u = 100; u < 140; ++u)
      corner.labels[v * 320 + u] = 5;
  const Planes fits = fitTogether (corner, corner.planes);
  for (const std::size_t k : {4u, 5u})
    EXPECT_EQ (fits[k], corner.planes[k]);
  EXPECT_NE (fits[1], corner.planes[1]);
}

TEST (WarpedPlaneFit, PointsOnALineDoNotTurnAPlane)
{
  // One row of cells is left of the wall on the right, which tells nothing about its height.
  Corner corner (320, waves);
  const Planes planes = corner.fitOneByOne();
  for (std::size_t i = 0; i < corner.labels.size(); ++i)
    if (corner.labels[i] == 3 && (i / 320 < 100 || i / 320 >= 104))
      corner.labels[i] = no_plane;
  const Planes fits = fitTogether (corner, planes);
  const Eigen::Vector3f change =
      planes[3].head<3>() / planes[3][3] - fits[3].head<3>() / fits[3][3];
  const Eigen::Vector3f untold (0.f, 1.f, (240.f - 204.f) / 525.f);
  EXPECT_GT (change.norm(), 1e-4f);
  EXPECT_NEAR (change.dot (untold), 0.f, 2e-5f);
}

TEST (WarpedPlaneFit, CellsWithFewPointsDoNotCount)
{
  // Every second cell of 4 x 4 pixels has one point left, a wrong one.
  const Corner corner (320, noWarp);
  for (std::uint32_t v = 0; v < 240; ++v)
    for (std::uint32_t u = 0; u < 320; ++u)
      if ((u / 4 + v / 4) % 2) {
        auto p = (*corner.cloud) (u, v).getVector3fMap();
        p = u % 4 || v % 4 ? Eigen::Vector3f::Constant (NAN)
                           : Eigen::Vector3f (1.1f * p);
      }
  const Planes fits = fitTogether (corner, corner.planes);
  for (std::size_t k = 0; k < fits.size(); ++k)
    EXPECT_LT ((fits[k] - corner.planes[k]).norm(), 1e-3f) << k;
}

TEST (WarpedPlaneFit, MissingPointsAndOtherSizes)
{
  WarpedPlaneFit fit;
  for (const std::uint32_t width : {320u, 161u, 8u, 320u}) {
    Corner corner (width, waves);
    std::mt19937 random (1);
    for (auto& point : *corner.cloud)
      if (random() % 10 == 0)
        point.getVector3fMap().setConstant (random() % 2 ? 0.f : NAN);
    Planes planes = corner.planes;
    fit.compute (
        corner.points(), corner.labels, pcl::rgbd_planes::DepthNoise(), planes);
    EXPECT_EQ (planes, fitTogether (corner, corner.planes)) << width;
    for (const auto& plane : planes)
      EXPECT_TRUE (plane.allFinite());
  }
}

TEST (WarpedPlaneFit, ProjectOntoPlanesUsesItOnRequest)
{
  const Corner corner (160, waves);
  std::vector<pcl::ModelCoefficients> models;
  const Planes alone = corner.fitOneByOne();
  for (const auto& plane : alone) {
    models.emplace_back();
    models.back().values.assign (plane.data(), plane.data() + 4);
  }
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (160, 120);
  for (std::size_t i = 0; i < labels->size(); ++i)
    (*labels)[i].label = corner.labels[i];
  pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
  projection.setInputCloud (corner.cloud);
  projection.setPlanes (models, labels);
  Cloud output;
  projection.filter (output);
  EXPECT_FALSE (projection.getFitTogether());
  EXPECT_LT ((projection.getPlanes()[1] - alone[1]).norm(), 1e-6f);
  projection.setFitTogether (true);
  projection.filter (output);
  const Planes together = fitTogether (corner, alone);
  EXPECT_GT ((together[1] - alone[1]).norm(), 1e-3f);
  for (std::size_t k = 0; k < together.size(); ++k)
    EXPECT_LT ((projection.getPlanes()[k] - together[k]).norm(), 1e-5f) << k;
  for (std::size_t i = 0; i < output.size(); i += 7) {
    const Eigen::Vector4f& plane = projection.getPlanes()[corner.labels[i]];
    EXPECT_NEAR (plane.dot (output[i].getVector4fMap()), 0.f, 1e-5f);
  }

  auto line = pcl::make_shared<Cloud> (*corner.cloud);
  line->width = static_cast<std::uint32_t> (line->size());
  line->height = 1;
  projection.setInputCloud (line);
  projection.filter (output);
  EXPECT_TRUE (output.empty());
}
