// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/normal_methods.h>
#include <pcl/apps/quiet_pcl.h>
#include <pcl/apps/stopwatch.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/linear_least_squares_normal.h>
#include <pcl/features/two_run_normal.h>

#include <memory>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using TangentNormalEstimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;
using PclNormals = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;

template <typename Estimation>
NormalMethod
makeMethod (const std::string& name, const std::shared_ptr<Estimation>& estimation)
{
  return {name, [estimation] (const Cloud::ConstPtr& cloud, Normals& normals) {
            const Stopwatch watch;
            estimation->setInputCloud (cloud);
            estimation->compute (normals);
            return watch.milliseconds();
          }};
}

/** One of PCL's, which tells whenever a cloud fits no pinhole camera. */
template <typename Estimation>
NormalMethod
makeQuietMethod (const std::string& name, const std::shared_ptr<Estimation>& estimation)
{
  return {name,
          [compute = makeMethod (name, estimation).compute] (
              const Cloud::ConstPtr& cloud, Normals& normals) {
            const QuietPcl quiet;
            return compute (cloud, normals);
          }};
}

NormalMethod
pclMethod (const std::string& mode,
           PclNormals::NormalEstimationMethod method,
           int smoothing_size)
{
  const auto estimation = std::make_shared<PclNormals>();
  estimation->setNormalEstimationMethod (method);
  estimation->setNormalSmoothingSize (static_cast<float> (smoothing_size));
  return makeQuietMethod ("pcl_" + mode + '_' + std::to_string (smoothing_size),
                          estimation);
}

} // namespace

std::vector<NormalMethod>
normalMethods ()
{
  std::vector<NormalMethod> methods;
  const auto addTangent = [&] (const std::string& name, const auto& configure) {
    const auto estimation = std::make_shared<TangentNormalEstimation>();
    configure (*estimation);
    methods.push_back (makeMethod (name, estimation));
  };
  addTangent ("tangent", [] (auto&) {});
  addTangent ("tangent_plain", [] (auto& e) { e.setEdgeAware (false); });
  addTangent ("tangent_depth_dependent",
              [] (auto& e) { e.setDepthDependentSmoothing (true); });
  addTangent ("tangent_scale_selection", [] (auto& e) { e.setScaleSelection (true); });
  const std::pair<const char*, PclNormals::NormalEstimationMethod> pcl_modes[] = {
      {"average_3d_gradient", PclNormals::AVERAGE_3D_GRADIENT},
      {"covariance_matrix", PclNormals::COVARIANCE_MATRIX},
      {"simple_3d_gradient", PclNormals::SIMPLE_3D_GRADIENT},
      {"average_depth_change", PclNormals::AVERAGE_DEPTH_CHANGE}};
  for (const auto& [mode, method] : pcl_modes)
    for (const int smoothing_size : {10, 20})
      methods.push_back (pclMethod (mode, method, smoothing_size));
  const auto least_squares = std::make_shared<
      pcl::LinearLeastSquaresNormalEstimation<pcl::PointXYZ, pcl::Normal>>();
  least_squares->setNormalSmoothingSize (10.f);
  // Its own default, 1, keeps no surfaces apart; this is that of the other modes.
  least_squares->setMaxDepthChangeFactor (0.02f);
  methods.push_back (makeQuietMethod ("pcl_linear_least_squares", least_squares));
#ifdef PCL_RGBD_PLANES_HAS_OPENCV
  for (auto& method : opencvNormalMethods())
    methods.push_back (std::move (method));
#endif
  return methods;
}

NormalMethod
twoRunMethod (const RadiusFunction& radius, unsigned int threads)
{
  const auto estimation =
      std::make_shared<pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal>>();
  estimation->setRadius (radius);
  estimation->setNumberOfThreads (threads);
  return makeMethod ("two_run_pca", estimation);
}

} // namespace rgbd_planes
} // namespace pcl
