// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// All classes of the library, one after the other on the same clouds, as a robot would use
// them: with inputs, indices and settings of any kind, set in any order.

#include "any_settings.h"
#include "checked_normals.h"
#include "fuzzed_filters.h"

#include <pcl/common/transforms.h>
#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/segmentation/depth_noise_estimation.h>
#include <pcl/segmentation/plane_tracker.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace fuzz;

namespace {

void
expectIndices (const pcl::Indices& indices, std::size_t size)
{
  expect (!indices.empty() && pcl::rgbd_planes::indicesInside (indices, size));
  expect (std::adjacent_find (indices.begin(), indices.end(), std::greater_equal<>()) ==
          indices.end());
}

class Pipeline {
public:
  explicit Pipeline (FuzzedDataProvider& data) : data_ (data)
  {
    segmentation_.setMinInliers (20);
    extraction_.setMinPoints (5);
  }

  /** Does one thing of many. */
  void
  step ()
  {
    const auto todo =
        data_.PickValueInArray ({&Pipeline::takeCloud,
                                 &Pipeline::takeIndices,
                                 &Pipeline::change<&Pipeline::estimation_>,
                                 &Pipeline::change<&Pipeline::two_run_estimation_>,
                                 &Pipeline::change<&Pipeline::segmentation_>,
                                 &Pipeline::change<&Pipeline::extraction_>,
                                 &Pipeline::change<&Pipeline::detection_>,
                                 &Pipeline::spoilResults,
                                 &Pipeline::runAll,
                                 &Pipeline::runAll,
                                 &Pipeline::estimateNormals,
                                 &Pipeline::estimateTwoRunNormals,
                                 &Pipeline::findPlanes,
                                 &Pipeline::trackPlanes,
                                 &Pipeline::measureNoise,
                                 &Pipeline::findObjects,
                                 &Pipeline::findObstacles,
                                 &Pipeline::filter});
    (this->*todo)();
  }

private:
  void
  takeCloud ()
  {
    cloud_ = data_.ConsumeIntegralInRange (0, 30) == 0 ? nullptr : anyCloud (data_);
    indices_.reset();
    if (!cloud_)
      return;
    switch (data_.ConsumeIntegralInRange (0, 15)) {
    case 13: // in the frame of a robot, or of a laser scanner
      pcl::transformPointCloud (*cloud_, *cloud_, anyPose (data_));
      break;
    case 14: // no camera sees such an image
      std::rotate (
          cloud_->begin(), cloud_->begin() + cloud_->size() / 3, cloud_->end());
      break;
    case 15:
      cloud_->sensor_origin_[data_.ConsumeIntegralInRange (0, 2)] = anyFloat (data_);
    }
  }

  void
  takeIndices ()
  {
    const std::size_t size = cloud_ ? cloud_->size() : 0;
    indices_ = anyIndices (data_, size);
    detection_.setExcludedIndices (data_.ConsumeBool() ? anyIndices (data_, size)
                                                       : nullptr);
  }

  template <auto tool>
  void
  change ()
  {
    setAny (data_, this->*tool);
  }

  /** Normals, planes and labels of others may be anything. */
  void
  spoilResults ()
  {
    if (!normals_->empty()) {
      auto& normal = (*normals_)[data_.ConsumeIntegralInRange<std::size_t> (
          0, normals_->size() - 1)];
      normal.data_n[data_.ConsumeIntegralInRange (0, 2)] = anyFloat (data_);
      normal.curvature = anyFloat (data_);
    }
    if (!labels_->empty())
      (*labels_)[data_.ConsumeIntegralInRange<std::size_t> (0, labels_->size() - 1)]
          .label = data_.ConsumeIntegral<std::uint32_t>();
    if (planes_.empty())
      return;
    const auto k = data_.ConsumeIntegralInRange<std::size_t> (0, planes_.size() - 1);
    planes_[k].values.resize (data_.ConsumeIntegralInRange (3, 5));
    planes_[k].values[data_.ConsumeIntegralInRange (0, 2)] = anyFloat (data_);
    if (data_.ConsumeBool())
      planes_.pop_back();
  }

  void
  runAll ()
  {
    estimateNormals();
    findPlanes();
    trackPlanes();
    measureNoise();
    findObjects();
    findObstacles();
    filter();
  }

  void
  estimateNormals ()
  {
    estimation_.compute (cloud_, indices_, *normals_);
    if (cloud_)
      expectSpherical (*cloud_, *normals_);
  }

  void
  estimateTwoRunNormals ()
  {
    // With a large radius, all points are neighbours of all.
    constexpr std::size_t most_points = 300;
    if (cloud_ && cloud_->size() > most_points)
      return;
    estimate (two_run_estimation_, cloud_, indices_, *normals_);
    expectNormals (*normals_);
  }

  template <typename Segmentation>
  void
  setInputs (Segmentation& segmentation)
  {
    segmentation.setInputCloud (cloud_);
    segmentation.setInputNormals (normals_);
    segmentation.setIndices (indices_);
  }

  void
  findPlanes ()
  {
    setInputs (segmentation_);
    decltype (segmentation_)::Regions regions;
    std::vector<pcl::PointIndices> label_indices, boundaries, parts;
    std::vector<std::size_t> plane_of_part;
    segmentation_.segmentAndRefine (
        regions, planes_, inliers_, labels_, label_indices, boundaries);
    segmentation_.getSegments (parts, plane_of_part);

    expect (regions.size() == planes_.size() && inliers_.size() == planes_.size());
    std::vector<std::uint32_t> plane_of (labels_->size(), segmentation_.unlabelled);
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const auto& values = planes_[k].values;
      expectIndices (inliers_[k].indices, labels_->size());
      for (const auto i : inliers_[k].indices)
        plane_of[static_cast<std::size_t> (i)] = static_cast<std::uint32_t> (k);
      expect (values.size() == 4 && std::isfinite (values[3]));
      expect (values[3] >= 0.f || !cloud_->sensor_origin_.head<3>().isZero (0.f));
      expect (std::fabs (std::hypot (values[0], values[1], values[2]) - 1.f) < 1e-3f);
    }
    for (std::size_t i = 0; i < plane_of.size(); ++i)
      expect ((*labels_)[i].label == plane_of[i]);
    for (std::size_t k = 0; k < boundaries.size(); ++k)
      for (const auto i : boundaries[k].indices)
        expect (plane_of.at (static_cast<std::size_t> (i)) == k);
    for (const auto& part : parts)
      expectIndices (part.indices, labels_->size());
    expect (segmentation_.getRms().size() == planes_.size());
    expect (segmentation_.getParameterCovariances().size() == planes_.size());
    for (const auto& covariance : segmentation_.getParameterCovariances())
      expect (covariance.allFinite());
  }

  void
  trackPlanes ()
  {
    std::vector<std::uint32_t> ids;
    tracker_.track (planes_, *labels_, ids);
    expect (ids.empty() || ids.size() == planes_.size());
    std::sort (ids.begin(), ids.end());
    expect (std::adjacent_find (ids.begin(), ids.end()) == ids.end());
  }

  void
  measureNoise ()
  {
    if (!cloud_ || !noise_estimation_.addFrame (*cloud_))
      return;
    pcl::rgbd_planes::DepthNoise noise;
    if (noise_estimation_.estimate (noise))
      expect (noise.sigmaAtSquare (1.f) > 0.f &&
              std::isfinite (noise.sigmaAtSquare (1.f)) &&
              noise.normal_scatter >= 1.f &&
              noise.normal_scatter <= pcl::rgbd_planes::DepthNoise::max_normal_scatter);
  }

  void
  findObjects ()
  {
    setInputs (extraction_);
    std::vector<pcl::SupportedObject> objects;
    extraction_.extract (planes_, inliers_, objects);
    for (const auto& object : objects) {
      expectIndices (object.indices.indices, cloud_->size());
      expect (object.support < planes_.size());
      expect (object.centroid.allFinite() && object.box_size.minCoeff() >= 0.f);
    }
  }

  void
  findObstacles ()
  {
    setInputs (detection_);
    detection_.setInputPlanes (planes_, labels_);
    std::vector<pcl::rgbd_planes::Obstacle> obstacles;
    detection_.detect (obstacles, *classes_);
    expect (classes_->empty() || classes_->size() == cloud_->size());
    for (const auto& obstacle : obstacles)
      expectIndices (obstacle.indices, cloud_->size());
    for (const float range : detection_.getScan().ranges)
      expect (range >= 0.f || range == -std::numeric_limits<float>::infinity());
  }

  void
  filter ()
  {
    filters_.applyAll (data_, {cloud_, indices_, planes_, inliers_, labels_, classes_});
  }

  FuzzedDataProvider& data_;
  synthetic::Cloud::Ptr cloud_;
  pcl::IndicesPtr indices_;
  Normals::Ptr normals_ = pcl::make_shared<Normals>();
  Labels::Ptr labels_ = pcl::make_shared<Labels>();
  Labels::Ptr classes_ = pcl::make_shared<Labels>();
  std::vector<pcl::ModelCoefficients> planes_;
  std::vector<pcl::PointIndices> inliers_;
  CheckedNormals estimation_;
  pcl::TwoRunNormalEstimation<PointXYZ, pcl::Normal> two_run_estimation_;
  pcl::NormalSpacePlaneSegmentation<PointXYZ, pcl::Normal> segmentation_;
  pcl::SupportedObjectExtraction<PointXYZ, pcl::Normal> extraction_;
  pcl::ObstacleDetection<PointXYZ, pcl::Normal> detection_;
  pcl::PlaneTracker tracker_;
  pcl::DepthNoiseEstimation noise_estimation_;
  Filters filters_;
};

} // namespace

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* bytes, std::size_t size)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  FuzzedDataProvider data (bytes, size);
  Pipeline pipeline (data);
  for (int step = 0; step < 12 && data.remaining_bytes() > 0; ++step)
    pipeline.step();
  return 0;
}
