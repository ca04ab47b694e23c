// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/impl/plane_points.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The smooth error of depth that calibration leaves, told by planes.
 *
 * The inverse depth 1/z of a plane m * p = 1 is m * (x/z, y/z, 1). What is measured is that
 * plus the warp of the camera at the pixel, which does not depend on the plane: a sum of
 * cosines with waves of down to a third of the longer side of the image, each as likely as the
 * others. All planes of all frames and the warp are found together by least squares. What
 * bends planes tells the warp. A part that is linear in the image tilts all of them alike, which
 * only angles between them tell: walls, floors and tables of buildings meet at right angles.
 */
class PCL_RGBD_PLANES_EXPORTS DepthWarp {
public:
  /** \brief Forgets all frames and the warp. */
  void
  clear ();

  /** \brief Adds what the planes of a frame tell; false, and nothing is added, where most points
   * are nowhere near their planes. A frame of a camera that stands, on which three quarters of
   * the image are as in the last one, tells nothing more. Where there is no memory for it, all
   * frames are forgotten.
   * \param[in] points in the camera frame, z forward; an image of the size of those before
   * \param[in] plane_of for each point; no plane: a number beyond. Planes with few
   * points tell nothing.
   * \param[in] noise weighs the points; the warp is taken to be about twice its quadratic part
   * \param[in] right_angles large planes within 4 degrees of a right angle are taken to be at one,
   * to half a degree
   */
  bool
  add (const OrganizedPoints& points,
       const std::vector<std::uint32_t>& plane_of,
       const PlaneVectors& planes,
       const DepthNoise& noise,
       bool right_angles);

  std::size_t
  frames () const
  {
    return frames_;
  }

  /** \brief Whether frames told the warp, or setImage(). */
  bool
  isKnown () const
  {
    return known_;
  }

  /** \brief Takes the place of all frames, see image(). */
  void
  setImage (const Eigen::MatrixXf& image);

  int
  width () const
  {
    return width_;
  }

  int
  height () const
  {
    return height_;
  }

  /** \brief What the warp adds to inverse depths, 1/m, width x height: one column for each row
   * of the image. */
  const Eigen::MatrixXf&
  image () const
  {
    return image_;
  }

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
    std::size_t cells = 0;
    Eigen::Matrix3d squares;
    Eigen::Vector3d right;
    Eigen::Matrix<double, 3, Eigen::Dynamic> waves;
  };

  /** \brief The normal of a plane that fits its points without warp. */
  struct Normal {
    Eigen::Vector3d unit;
    Eigen::Matrix3d covariance;
    /** With the amplitudes of the waves of the warp. */
    Eigen::Matrix<double, 3, Eigen::Dynamic> change;
  };

  void
  resize (int width, int height);

  void
  collectCells (const OrganizedPoints& points,
                const std::vector<std::uint32_t>& plane_of,
                const PlaneVectors& planes,
                const DepthNoise& noise);

  bool
  findMean (const OrganizedPoints& points,
            const std::vector<std::uint32_t>& plane_of,
            const DepthNoise& noise,
            Cell& cell) const;

  static double
  errorOf (const Cell& cell, const PlaneVectors& planes);

  bool
  areNear (const PlaneVectors& planes, const DepthNoise& noise) const;

  bool
  isSameView (const DepthNoise& noise) const;

  void
  addEquations (const PlaneVectors& planes, const DepthNoise& noise, bool right_angles);

  void
  sumUp (const PlaneVectors& planes, const DepthNoise& noise);

  void
  addProductsOfWaves ();

  void
  eliminatePlanes (const PlaneVectors& planes);

  void
  addRightAngles ();

  void
  solve (const DepthNoise& noise);

  std::size_t frames_ = 0;
  bool known_ = false;
  int width_ = 0, height_ = 0, cell_size_ = 1;
  std::vector<Wave> waves_;
  Eigen::MatrixXd row_cosines_, column_cosines_; // half periods x cells
  Eigen::MatrixXf pixel_row_cosines_, pixel_column_cosines_;
  std::vector<Cell> cells_, view_; // of a frame, and of the last one that was added
  std::vector<PlaneSums> planes_;
  std::vector<Normal> normals_; // of the large planes of a frame
  Eigen::MatrixXd weights_;     // of the cells of a frame
  /** The normal equations of the waves, over all frames. */
  Eigen::MatrixXd squares_;
  Eigen::VectorXd right_;
  Eigen::MatrixXf image_;
};

} // namespace rgbd_planes
} // namespace pcl
