// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/plane_outputs.h>
#include <pcl/segmentation/impl/region_contour.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

void
PlaneOutputs::fillModels (const PlaneExtraction& extraction,
                          const PCLHeader& header,
                          std::vector<ModelCoefficients>& model_coefficients,
                          std::vector<PointIndices>& inlier_indices)
{
  const auto& planes = extraction.planes();
  model_coefficients.resize (planes.size());
  inlier_indices.resize (planes.size());
  list_ends_.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& plane = planes[k];
    model_coefficients[k].header = header;
    model_coefficients[k].values = {
        plane.normal[0], plane.normal[1], plane.normal[2], plane.d};
    inlier_indices[k].header = header;
    inlier_indices[k].indices.resize (extraction.runs().pixels()[k]);
    list_ends_[k] = inlier_indices[k].indices.data();
  }
  for (const auto& run : extraction.runs().runs())
    run.appendTo (list_ends_[run.label]);
}

void
PlaneOutputs::fillBoundaries (const PlaneExtraction& extraction,
                              std::uint32_t width,
                              const PCLHeader& header,
                              std::vector<PointIndices>& boundary_indices)
{
  const std::size_t planes = extraction.planes().size();
  parts_.find (extraction.runs());
  largest_parts_.assign (planes, {});
  for (const auto& part : parts_.parts())
    if (part.pixels > largest_parts_[part.label].pixels)
      largest_parts_[part.label] = part;
  boundary_indices.resize (planes);
  for (std::size_t k = 0; k < planes; ++k) {
    boundary_indices[k].header = header;
    traceContour (extraction.labels(),
                  width,
                  largest_parts_[k].first,
                  boundary_indices[k].indices);
  }
}

void
PlaneOutputs::fillSegments (const PlaneExtraction& extraction,
                            std::size_t min_points,
                            const PCLHeader& header,
                            std::vector<PointIndices>& segment_indices,
                            std::vector<std::size_t>& plane_of_segment)
{
  parts_.find (extraction.runs());
  const auto& parts = parts_.parts();
  const auto isLarge = [min_points] (const ConnectedParts::Part& part) {
    return part.pixels >= min_points;
  };
  segment_indices.resize (
      static_cast<std::size_t> (std::count_if (parts.begin(), parts.end(), isLarge)));
  plane_of_segment.clear();
  list_ends_.assign (parts.size(), nullptr);
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (isLarge (parts[part])) {
      PointIndices& segment = segment_indices[plane_of_segment.size()];
      segment.header = header;
      segment.indices.resize (parts[part].pixels);
      list_ends_[part] = segment.indices.data();
      plane_of_segment.push_back (parts[part].label);
    }
  const auto& runs = extraction.runs().runs();
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (index_t*& end = list_ends_[parts_.partOfRun()[i]])
      runs[i].appendTo (end);
}

void
fillRms (const PlaneExtraction& extraction, std::vector<double>& rms)
{
  const auto& planes = extraction.planes();
  const auto& moments = extraction.moments();
  rms.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k)
    rms[k] = std::sqrt (std::max (moments[k].squaredDistances (planes[k]), 0.) /
                        static_cast<double> (moments[k].points));
}

bool
areAllFarther (float range,
               const Eigen::Vector3f& sensor,
               const OrganizedPoints& points)
{
  bool is_any = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isMeasured (points[i]))
      continue;
    is_any = true;
    if ((Eigen::Map<const Eigen::Vector3f> (points[i]) - sensor).norm() <= range)
      return false;
  }
  return is_any;
}

} // namespace rgbd_planes
} // namespace pcl
