// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_methods.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <chrono>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

/** What the planes of a frame are written to, frame after frame. */
struct Output {
  Normals::Ptr normals = pcl::make_shared<Normals>();
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
};

template <typename Work>
double
milliseconds (const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

void
convert (const Output& output, std::size_t points, PlaneSet& planes)
{
  planes.coefficients.clear();
  planes.labels.assign (points, unlabelled);
  for (std::size_t k = 0; k < output.models.size(); ++k) {
    planes.coefficients.emplace_back (output.models[k].values.data());
    for (const auto i : output.inliers[k].indices)
      planes.labels[static_cast<std::size_t> (i)] = static_cast<std::uint32_t> (k);
  }
}

PlaneMethod
normalSpaceMethod ()
{
  struct State : Output {
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  };
  const auto state = std::make_shared<State>();
  return {"normal_space",
          [state] (const Cloud::ConstPtr& cloud, unsigned min_inliers, PlaneSet& set) {
            auto& [normals, models, inliers] = static_cast<Output&> (*state);
            const double time = milliseconds ([&] {
              state->estimation.setInputCloud (cloud);
              state->estimation.compute (*normals);
              state->segmentation.setMinInliers (min_inliers);
              state->segmentation.setInputCloud (cloud);
              state->segmentation.setInputNormals (normals);
              state->segmentation.segment (models, inliers);
            });
            convert (*state, cloud->size(), set);
            return time;
          }};
}

PlaneMethod
organizedMultiPlaneMethod ()
{
  using Region = pcl::PlanarRegion<pcl::PointXYZ>;
  struct State : Output {
    pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>
        segmentation;
  };
  const auto state = std::make_shared<State>();
  state->estimation.setNormalEstimationMethod (state->estimation.AVERAGE_3D_GRADIENT);
  state->estimation.setNormalSmoothingSize (10.f);
  return {"pcl_omps",
          [state] (const Cloud::ConstPtr& cloud, unsigned min_inliers, PlaneSet& set) {
            auto& [normals, models, inliers] = static_cast<Output&> (*state);
            const double time = milliseconds ([&] {
              state->estimation.setInputCloud (cloud);
              state->estimation.compute (*normals);
              state->segmentation.setMinInliers (min_inliers);
              state->segmentation.setInputCloud (cloud);
              state->segmentation.setInputNormals (normals);
              // It appends to its outputs, and reads past the end of used labels.
              models.clear();
              inliers.clear();
              std::vector<Region, Eigen::aligned_allocator<Region>> regions;
              auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
              std::vector<pcl::PointIndices> label_indices, boundary_indices;
              state->segmentation.segmentAndRefine (
                  regions, models, inliers, labels, label_indices, boundary_indices);
            });
            convert (*state, cloud->size(), set);
            return time;
          }};
}

} // namespace

std::vector<PlaneMethod>
planeMethods ()
{
  return {normalSpaceMethod(), organizedMultiPlaneMethod()};
}

} // namespace rgbd_planes
} // namespace pcl
