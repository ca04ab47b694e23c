// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/StdVector>

#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Fits the planes of an image whose depths have a smooth error in common, such as
 * calibration leaves.
 *
 * The inverse depth 1/z of a plane m * p = 1 is m * (x/z, y/z, 1). What is measured is that
 * plus the warp of the camera at the pixel, which does not depend on the plane: a sum of cosines
 * with waves of down to a third of the width of the image, each as likely as the others. All
 * planes and the warp are found together by least squares. A single plane cannot be told from
 * a warp that is linear in the image; several planes, each bent by its part of the
 * same smooth warp, can.
 */
class PCL_RGBD_PLANES_EXPORTS WarpedPlaneFit {
public:
  /** \brief a, b, c, d of each plane, in the camera frame. */
  using Planes =
      std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>;

  /** \brief Replaces planes by better ones; those with few points stay.
   * \param[in] points in the camera frame, z forward
   * \param[in] plane_of for each point; no plane: a number beyond
   * \param[in] noise the warp is taken to be about twice its quadratic part
   */
  void
  compute (const OrganizedPoints& points,
           const std::vector<std::uint32_t>& plane_of,
           const DepthNoise& noise,
           Planes& planes);

private:
  /** \brief The means of a square of pixels that sees one plane. */
  struct Cell {
    Eigen::Vector3d ray = Eigen::Vector3d::Zero(); // x/z, y/z, 1
    double inverse_depth = 0.;
    std::uint32_t plane = 0;
    int column = 0, row = 0; // of the cell
  };

  struct Wave {
    int along_row, along_column; // half periods in the image
    double variance;             // of its amplitude; that of all waves together is 1
  };

  /** \brief The normal equations of a plane. */
  struct PlaneSums {
    Eigen::Vector3d m; // of the given plane; the unknown is what it changes by
    std::size_t cells = 0;
    Eigen::Matrix3d squares, inverse;
    Eigen::Vector3d right;
    Eigen::Matrix<double, 3, Eigen::Dynamic> waves;
  };

  void
  prepareWaves (int width, int height);

  void
  collectCells (const OrganizedPoints& points,
                const std::vector<std::uint32_t>& plane_of,
                const DepthNoise& noise);

  /** \brief The mean of a cell; false where it does not see one plane. */
  bool
  meanOf (const OrganizedPoints& points,
          const std::vector<std::uint32_t>& plane_of,
          const DepthNoise& noise,
          Cell& cell) const;

  void
  sumUp (const DepthNoise& noise);

  void
  solve (const DepthNoise& noise);

  int width_ = 0, height_ = 0, cell_size_ = 1;
  std::vector<Wave> waves_;
  Eigen::MatrixXd row_cosines_, column_cosines_; // half periods x cells
  std::vector<Cell> cells_;
  std::vector<PlaneSums> planes_;
  Eigen::VectorXd cosines_, right_, amplitudes_;
  Eigen::MatrixXd squares_;
  Eigen::Matrix<double, 3, Eigen::Dynamic> weighed_;
  Eigen::LLT<Eigen::MatrixXd> factors_;
};

} // namespace rgbd_planes
} // namespace pcl
