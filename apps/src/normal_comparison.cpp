// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/simulation/subsample.h>

#include <algorithm>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr char two_run_pca[] = "two_run_pca";

/** The fastest of three runs, or of fewer that take long, in ms: the first one also pays for
 * memory that is not in place, which the system may have taken during a long run of another. */
double
computeTimed (const NormalMethod& method,
              const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
              pcl::PointCloud<pcl::Normal>& normals)
{
  constexpr double long_run = 100.;
  double fastest = method.compute (cloud, normals);
  for (int run = 1; run < 3 && fastest < long_run; ++run)
    fastest = std::min (fastest, method.compute (cloud, normals));
  return fastest;
}

} // namespace

NormalComparison::NormalComparison (const std::vector<std::uint32_t>& steps,
                                    const RadiusFunction& radius)
: reference_ (twoRunMethod (radius, 0))
{
  for (const auto step : steps) {
    Resolution resolution{step, {}};
    for (auto& method : normalMethods())
      resolution.runners.push_back ({std::move (method), {}});
    resolution.runners.push_back ({twoRunMethod (radius, 1), {}});
    resolutions_.push_back (std::move (resolution));
  }
}

void
NormalComparison::add (const Frame& frame)
{
  const Task task = makeTask (frame);
  for (auto& resolution : resolutions_)
    run (resolution, subsampleTask (frame, task, resolution.step));
}

NormalComparison::Task
NormalComparison::makeTask (const Frame& frame)
{
  Task task{pcl::make_shared<Cloud>(), {}, {}};
  pcl::copyPointCloud (*frame.cloud, *task.cloud);
  if (!frame.truth) {
    reference_.compute (task.cloud, task.reference);
    return task;
  }
  pcl::copyPointCloud (*frame.truth, task.reference);
  for (std::size_t i = 0; i < task.reference.size(); ++i) {
    if (!pcl::isFinite ((*task.cloud)[i]))
      task.reference[i].getNormalVector3fMap().setConstant (
          std::numeric_limits<float>::quiet_NaN());
    task.is_edge.push_back ((*frame.truth)[i].edge != 0);
  }
  return task;
}

NormalComparison::Task
NormalComparison::subsampleTask (const Frame& frame,
                                 const Task& task,
                                 std::uint32_t step)
{
  return {measuredCloud (frame, step, min_pcl_pixels),
          subsample (task.reference, step),
          subsample (task.is_edge, task.cloud->width, step)};
}

void
NormalComparison::run (Resolution& resolution, const Task& task)
{
  const bool has_truth = !task.is_edge.empty();
  const Normals& tangent = resolution.runners.front().normals;
  for (auto& [method, normals] : resolution.runners) {
    stopIfInterrupted();
    if (!has_truth && method.name == two_run_pca)
      continue;
    NormalResult& result = resultOf (method.name, resolution.step, has_truth);
    result.milliseconds.push_back (computeTimed (method, task.cloud, normals));
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const bool is_edge = has_truth && task.is_edge[i];
      if (result.all.add (task.reference[i], normals[i])) {
        result.tangent_there.add (task.reference[i], tangent[i]);
        if (is_edge)
          result.tangent_there_edges.add (task.reference[i], tangent[i]);
      }
      if (has_truth)
        (is_edge ? result.edges : result.interior).add (task.reference[i], normals[i]);
    }
  }
}

NormalResult&
NormalComparison::resultOf (const std::string& method,
                            std::uint32_t step,
                            bool has_truth)
{
  NormalResult key;
  key.method = method;
  key.resolution = resolutionName (step);
  key.reference = has_truth ? "truth" : two_run_pca;
  const auto known =
      std::find_if (results_.begin(), results_.end(), [&] (const NormalResult& result) {
        return result.method == key.method && result.resolution == key.resolution &&
               result.reference == key.reference;
      });
  return known != results_.end() ? *known : results_.emplace_back (key);
}

} // namespace rgbd_planes
} // namespace pcl
