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

/** \param[in] segment (segmentation, output) runs it on the input it was given */
template <typename Estimation, typename Segmentation, typename Segment>
PlaneMethod
makeMethod (const std::string& name,
            const std::shared_ptr<Estimation>& estimation,
            const std::shared_ptr<Segmentation>& segmentation,
            const Segment& segment)
{
  const auto output = std::make_shared<Output>();
  return {name,
          [=] (const Cloud::ConstPtr& cloud, unsigned min_inliers, PlaneSet& set) {
            const auto start = std::chrono::steady_clock::now();
            estimation->setInputCloud (cloud);
            estimation->compute (*output->normals);
            segmentation->setMinInliers (min_inliers);
            segmentation->setInputCloud (cloud);
            segmentation->setInputNormals (output->normals);
            segment (*segmentation, *output);
            const std::chrono::duration<double, std::milli> elapsed =
                std::chrono::steady_clock::now() - start;
            convert (*output, cloud->size(), set);
            return elapsed.count();
          }};
}

PlaneMethod
normalSpaceMethod ()
{
  using Estimation =
      pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;
  using Segmentation = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>;
  return makeMethod ("normal_space",
                     std::make_shared<Estimation>(),
                     std::make_shared<Segmentation>(),
                     [] (Segmentation& segmentation, Output& output) {
                       segmentation.segment (output.models, output.inliers);
                     });
}

PlaneMethod
organizedMultiPlaneMethod ()
{
  using Estimation = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;
  using Segmentation =
      pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;
  using Region = pcl::PlanarRegion<pcl::PointXYZ>;
  const auto estimation = std::make_shared<Estimation>();
  estimation->setNormalEstimationMethod (Estimation::AVERAGE_3D_GRADIENT);
  estimation->setNormalSmoothingSize (10.f);
  return makeMethod ("pcl_omps",
                     estimation,
                     std::make_shared<Segmentation>(),
                     [] (Segmentation& segmentation, Output& output) {
                       // It appends to its outputs, and reads past the end of used labels.
                       output.models.clear();
                       output.inliers.clear();
                       std::vector<Region, Eigen::aligned_allocator<Region>> regions;
                       auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
                       std::vector<pcl::PointIndices> label_indices, boundary_indices;
                       segmentation.segmentAndRefine (regions,
                                                      output.models,
                                                      output.inliers,
                                                      labels,
                                                      label_indices,
                                                      boundary_indices);
                     });
}

} // namespace

std::vector<PlaneMethod>
planeMethods ()
{
  return {normalSpaceMethod(), organizedMultiPlaneMethod()};
}

} // namespace rgbd_planes
} // namespace pcl
