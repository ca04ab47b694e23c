// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/plane_methods.h>
#include <pcl/apps/quiet_pcl.h>
#include <pcl/apps/stopwatch.h>
#include <pcl/common/angles.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <algorithm>
#include <iterator>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** That programs set with PCL's normals. */
constexpr float usual_smoothing_size = 10.f;

void
convert (const SegmentedPlanes& output, std::size_t points, PlaneSet& planes)
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
makeMethod (const std::string& name, const FindPlanes& find)
{
  const auto output = std::make_shared<SegmentedPlanes>();
  return {name,
          [=] (const Cloud::ConstPtr& cloud, unsigned min_inliers, FoundPlanes& set) {
            const Stopwatch watch;
            find (cloud, min_inliers, *output);
            const double milliseconds = watch.milliseconds();
            convert (*output, cloud->size(), set);
            set.cloud = cloud;
            return milliseconds;
          },
          {}};
}

/** \param[in] segment (segmentation, planes) runs it on the input it was given */
template <typename Estimation, typename Segmentation, typename Segment>
FindPlanes
findPlanes (const std::shared_ptr<Estimation>& estimation,
            const std::shared_ptr<Segmentation>& segmentation,
            const Segment& segment)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  return [=] (const Cloud::ConstPtr& cloud,
              unsigned min_inliers,
              SegmentedPlanes& planes) {
    estimation->setInputCloud (cloud);
    estimation->compute (*normals);
    segmentation->setMinInliers (min_inliers);
    segmentation->setInputCloud (cloud);
    segmentation->setInputNormals (normals);
    segment (*segmentation, planes);
  };
}

/** Ours, where parts of it can be left out. */
class NormalSpaceMethod
: public pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> {
public:
  explicit NormalSpaceMethod (const PlaneAdditions& additions)
  {
    parameters_.additions = additions;
  }
};

/** What ours adds to the paper, on normals that are edge-aware or not. */
struct Additions : PlaneAdditions {
  bool edges = true;
};

using TangentEstimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

/** \param[in] set (estimation, segmentation) changes their settings */
PlaneMethod
normalSpaceMethod (
    const std::string& name,
    const Additions& additions,
    const DepthNoise& noise,
    const std::function<void (TangentEstimation&, NormalSpaceMethod&)>& set = {})
{
  const auto estimation = std::make_shared<TangentEstimation>();
  estimation->setEdgeAware (additions.edges);
  estimation->setDepthNoise (noise);
  const auto segmentation = std::make_shared<NormalSpaceMethod> (additions);
  segmentation->setDepthNoise (noise);
  if (set)
    set (*estimation, *segmentation);
  const auto segment = [] (NormalSpaceMethod& method, SegmentedPlanes& planes) {
    method.segment (planes.models, planes.inliers);
  };
  return makeMethod (name, findPlanes (estimation, segmentation, segment));
}

void
takeSphericalGrid (TangentEstimation&, NormalSpaceMethod& segmentation)
{
  segmentation.setNormalSpaceGrid (NormalSpaceGrid::spherical);
}

/** Sets what organizedMultiPlanes() has. */
void
keepSettings (TangentEstimation& estimation, NormalSpaceMethod& segmentation)
{
  const pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>
      theirs;
  estimation.setNormalSmoothingSize (usual_smoothing_size);
  segmentation.setAngularThreshold (theirs.getAngularThreshold());
  segmentation.setDistanceThreshold (theirs.getDistanceThreshold());
  segmentation.setMaximumCurvature (theirs.getMaximumCurvature());
}

/** Ours on corrected points. */
PlaneMethod
correctedMethod (const CorrectedOption& option)
{
  const auto correction = std::make_shared<DepthCorrection> (option);
  const auto planes = std::make_shared<SegmentedPlanes>();
  return {"corrected",
          [=] (const Cloud::ConstPtr& cloud, unsigned min_inliers, FoundPlanes& set) {
            const Stopwatch watch;
            const auto& corrected = correction->correct (cloud, min_inliers);
            correction->findPlanes (corrected, min_inliers, *planes);
            const double milliseconds = watch.milliseconds();
            convert (*planes, cloud->size(), set);
            set.cloud = corrected;
            return milliseconds;
          },
          correction->calibration()};
}

struct Addition {
  std::string name;
  bool Additions::*switched_on;
};

const Addition all_additions[] = {{"edges", &Additions::edges},
                                  {"creases", &PlaneAdditions::creases},
                                  {"noise", &PlaneAdditions::noise},
                                  {"peaks", &PlaneAdditions::peaks},
                                  {"parts", &PlaneAdditions::parts},
                                  {"growth", &PlaneAdditions::growth},
                                  {"bends", &PlaneAdditions::bends},
                                  {"curved", &PlaneAdditions::curved},
                                  {"repeat", &PlaneAdditions::repeat},
                                  {"joining", &PlaneAdditions::joining},
                                  {"steps", &PlaneAdditions::steps},
                                  {"strips", &PlaneAdditions::strips},
                                  {"patches", &PlaneAdditions::patches},
                                  {"assignment", &PlaneAdditions::assignment},
                                  {"intersections", &PlaneAdditions::intersections}};

Additions
additionsWithout (const std::string& list)
{
  Additions additions;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min (list.find (',', begin), list.size());
    const std::string name = list.substr (begin, end - begin);
    begin = end + 1;
    bool known = false;
    for (const Addition& addition : all_additions)
      if (name == "all" || name == addition.name) {
        additions.*addition.switched_on = false;
        known = true;
      }
    if (!known)
      throw AppError ("--without: '" + name + "' must be one of " +
                      planeAdditionNames() + ", or all");
  }
  return additions;
}

bool
areSame (const Additions& a, const Additions& b)
{
  return std::all_of (
      std::begin (all_additions), std::end (all_additions), [&] (const auto& addition) {
        return a.*addition.switched_on == b.*addition.switched_on;
      });
}

} // namespace

FindPlanes
organizedMultiPlanes (bool tuned)
{
  using Estimation = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;
  using Segmentation =
      pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;
  using Region = pcl::PlanarRegion<pcl::PointXYZ>;
  const auto estimation = std::make_shared<Estimation>();
  estimation->setNormalEstimationMethod (Estimation::AVERAGE_3D_GRADIENT);
  estimation->setNormalSmoothingSize (usual_smoothing_size);
  const auto segment = [] (Segmentation& segmentation, SegmentedPlanes& planes) {
    // It appends to its outputs, and reads past the end of used labels.
    planes.models.clear();
    planes.inliers.clear();
    std::vector<Region, Eigen::aligned_allocator<Region>> regions;
    auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
    std::vector<pcl::PointIndices> label_indices, boundary_indices;
    segmentation.segmentAndRefine (regions,
                                   planes.models,
                                   planes.inliers,
                                   labels,
                                   label_indices,
                                   boundary_indices);
  };
  const auto segmentation = std::make_shared<Segmentation>();
  if (tuned) {
    segmentation->setAngularThreshold (pcl::deg2rad (6.));
    segmentation->setDistanceThreshold (0.05);
    segmentation->setMaximumCurvature (0.01);
  }
  const FindPlanes find = findPlanes (estimation, segmentation, segment);
  return [=] (const Cloud::ConstPtr& cloud,
              unsigned min_inliers,
              SegmentedPlanes& planes) {
    const QuietPcl quiet; // it tells whenever a cloud fits no pinhole camera
    find (cloud, min_inliers, planes);
  };
}

std::string
planeAdditionNames ()
{
  std::string names;
  for (const Addition& addition : all_additions)
    names += (names.empty() ? "" : ", ") + addition.name;
  return names;
}

std::vector<PlaneMethod>
planeMethods (const PlaneMethodOptions& options)
{
  const auto& [spherical_grid, kept_settings, without, corrected, noise] = options;
  std::vector<PlaneMethod> methods{
      normalSpaceMethod ("normal_space", {}, noise),
      makeMethod ("pcl_omps", organizedMultiPlanes()),
      makeMethod ("pcl_omps_tuned", organizedMultiPlanes (true))};
  if (spherical_grid)
    methods.push_back (
        normalSpaceMethod ("spherical_grid", {}, noise, takeSphericalGrid));
  if (kept_settings)
    methods.push_back (normalSpaceMethod ("kept_settings", {}, noise, keepSettings));
  for (auto list = without.begin(); list != without.end(); ++list) {
    const Additions additions = additionsWithout (*list);
    const auto same = std::find_if (without.begin(), list, [&] (const auto& other) {
      return areSame (additions, additionsWithout (other));
    });
    if (same != list)
      throw AppError ("--without: '" + *list + "' is " +
                      (*same == *list ? "given twice" : "the same as '" + *same + "'") +
                      "; leave one out");
    methods.push_back (normalSpaceMethod ("no_" + *list, additions, noise));
  }
  if (corrected)
    methods.push_back (correctedMethod (*corrected));
  return methods;
}

} // namespace rgbd_planes
} // namespace pcl
