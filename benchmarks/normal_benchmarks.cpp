// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "benchmarks.h"

#include <pcl/apps/input_options.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>

#include <functional>
#include <iterator>

namespace pcl {
namespace rgbd_planes {

namespace {

using Normals = pcl::PointCloud<pcl::Normal>;
using PclEstimation = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;
using OurEstimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

/** Makes the clouds of a benchmark when it runs. */
using MakeClouds = std::function<Clouds()>;

/** The least that any estimator does: every point read, every normal written. */
void
copyFloor (benchmark::State& state, const Clouds& clouds)
{
  Normals normals (clouds.front()->width, clouds.front()->height);
  pcl::Normal* output = normals.points.data();
  benchmark::DoNotOptimize (output);
  measure (state, clouds, [&, output] (const Cloud::ConstPtr& cloud) {
    pcl::Normal* normal = output;
    for (const pcl::PointXYZ& point : cloud->points) {
      normal->getNormalVector4fMap() = point.getVector4fMap();
      Eigen::Vector4f::MapAligned (normal->data_c).setZero();
      ++normal;
    }
    benchmark::ClobberMemory();
  });
}

/** \param[in] configure (estimation) sets what differs from its defaults */
template <typename Estimation, typename Configure>
auto
runOf (const MakeClouds& make_clouds, const Configure& configure)
{
  return [=] (benchmark::State& state) {
    Estimation estimation;
    configure (estimation);
    Normals normals;
    measure (state, make_clouds(), [&] (const Cloud::ConstPtr& cloud) {
      estimation.setInputCloud (cloud);
      estimation.compute (normals);
      if (normals.size() != cloud->size())
        state.SkipWithError ("no normals");
    });
  };
}

template <typename Estimation, typename Configure>
void
addEstimator (const std::string& name,
              const MakeClouds& make_clouds,
              const Configure& configure)
{
  addBenchmark (name, runOf<Estimation> (make_clouds, configure));
}

void
defaults (OurEstimation&)
{}

/** The estimator of the paper. */
void
plain (OurEstimation& estimation)
{
  estimation.setEdgeAware (false);
}

void
average3DGradient (PclEstimation& estimation)
{
  estimation.setNormalEstimationMethod (PclEstimation::AVERAGE_3D_GRADIENT);
  estimation.setNormalSmoothingSize (10.f);
}

void
addWindowSizes (const MakeClouds& make_clouds)
{
  for (const int window : {8, 16, 32, 64}) {
    const std::string size = '/' + std::to_string (window);
    addEstimator<OurEstimation> (
        "normals/tangent_window" + size, make_clouds, [=] (OurEstimation& estimation) {
          estimation.setNormalSmoothingSize (static_cast<float> (window));
        });
    addEstimator<OurEstimation> ("normals/tangent_plain_window" + size,
                                 make_clouds,
                                 [=] (OurEstimation& estimation) {
                                   plain (estimation);
                                   estimation.setRectSize (window, window);
                                 });
  }
}

struct ImageSize {
  const char* megapixels;
  std::uint32_t width;
  std::uint32_t height;
};

constexpr ImageSize image_sizes[] = {
    {"0.3mp", 640, 480}, {"1mp", 1152, 864}, {"2mp", 1632, 1224}, {"4mp", 2304, 1728}};

} // namespace

void
registerNormalBenchmarks (const Clouds& frames)
{
  for (const std::uint32_t step : {1u, 2u, 4u}) {
    const std::string resolution = '/' + resolutionName (step);
    const MakeClouds clouds = [=] { return subsample (frames, step); };
    addBenchmark ("normals/copy_floor" + resolution,
                  [=] (benchmark::State& state) { copyFloor (state, clouds()); });
    addEstimator<OurEstimation> ("normals/tangent" + resolution, clouds, defaults);
    addEstimator<OurEstimation> ("normals/tangent_plain" + resolution, clouds, plain);
    addEstimator<PclEstimation> (
        "normals/pcl_average_3d_gradient" + resolution, clouds, average3DGradient);
  }
  const MakeClouds at_vga = [=] { return frames; };
  addInstructionBenchmarks ("normals/tangent_instructions",
                            runOf<OurEstimation> (at_vga, defaults));
  addWindowSizes (at_vga);
  const auto resampled = [=] (const ImageSize& size) {
    return [=] { return Clouds{resample (*frames.front(), size.width, size.height)}; };
  };
  for (const ImageSize& size : image_sizes)
    addEstimator<OurEstimation> (std::string ("normals/tangent_points/") +
                                     size.megapixels,
                                 resampled (size),
                                 defaults);
  for (const unsigned threads : {1u, 2u})
    addEstimator<OurEstimation> (
        "normals/tangent_threads/" + std::to_string (threads),
        resampled (*std::rbegin (image_sizes)),
        [=] (OurEstimation& estimation) { estimation.setNumberOfThreads (threads); });
}

} // namespace rgbd_planes
} // namespace pcl
