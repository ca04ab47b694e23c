// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/PCLHeader.h>
#include <pcl/PointIndices.h>
#include <pcl/segmentation/impl/connected_parts.h>
#include <pcl/segmentation/impl/plane_extraction.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Gives planes that were extracted as PCL's messages, of which none depends on the type
 * of points.
 *
 * All methods replace their outputs, whose memory they use again. */
class PCL_RGBD_PLANES_EXPORTS PlaneOutputs {
public:
  /** \brief The coefficients of each plane, and its points in ascending order. */
  void
  fillModels (const PlaneExtraction& extraction,
              const PCLHeader& header,
              std::vector<ModelCoefficients>& model_coefficients,
              std::vector<PointIndices>& inlier_indices);

  /** \brief The outer boundary of the largest connected part of each plane, as traceContour()
   * has it, in an image of \a width pixels. */
  void
  fillBoundaries (const PlaneExtraction& extraction,
                  std::uint32_t width,
                  const PCLHeader& header,
                  std::vector<PointIndices>& boundary_indices);

  /** \brief The connected parts of all planes with at least \a min_points points, by their first
   * points, and the plane of each part. */
  void
  fillSegments (const PlaneExtraction& extraction,
                std::size_t min_points,
                const PCLHeader& header,
                std::vector<PointIndices>& segment_indices,
                std::vector<std::size_t>& plane_of_segment);

private:
  std::vector<index_t*> list_ends_;
  ConnectedParts parts_;
  std::vector<ConnectedParts::Part> largest_parts_;
};

/** \brief Root of the mean squared distance of the points of each plane to it, in metres. */
PCL_RGBD_PLANES_EXPORTS void
fillRms (const PlaneExtraction& extraction, std::vector<double>& rms);

/** \brief Whether all measured \a points, of which there is one at least, are farther than
 * \a range from \a sensor. */
PCL_RGBD_PLANES_EXPORTS bool
areAllFarther (float range,
               const Eigen::Vector3f& sensor,
               const OrganizedPoints& points);

} // namespace rgbd_planes
} // namespace pcl
